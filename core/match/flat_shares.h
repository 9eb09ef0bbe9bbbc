#pragma once

#include "core/image/image.h"
#include "core/match/patch_source.h"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace texloom {

/// How much of each patch of some exemplars lies in parts of one flat colour. Such a part fits itself without
/// any error wherever one looks in it, so that an output which grows by what fits best stays in it for ever
/// where the exemplar does not show how it ends: where it reaches the exemplar's right or lower border.
class FlatShares {
public:
    /// @param patch side in pixels, at most the exemplars' shorter sides. @param check called for every row;
    /// may throw.
    FlatShares(std::span<const PatchSource> exemplars, int patch, const std::function<void()>& check);

    /// Whether there is an allowed patch that is flat all over; in most exemplars there is none.
    bool any() const { return m_largest >= 1; }
    /// The mean share of the allowed patches, each as often as its exemplar's weight says.
    double usual() const { return m_usual; }
    /// For each exemplar the shares, 0 to 1, of the patches named by their top left pixels; of those that its
    /// mask forbids, too.
    const std::vector<Image>& shares() const { return m_shares; }

    static std::uint64_t bytesFor(Size exemplar, int patch);

private:
    std::vector<Image> m_shares;
    double m_usual = 0;
    float m_largest = 0;
};

} // namespace texloom
