#pragma once

#include "core/match/patch_match.h"

#include <functional>
#include <span>
#include <vector>

namespace texloom {

/// The exemplars at several scales, each half the one before (Gaussian pyramid, standard deviation 0.8 px).
class ExemplarPyramid {
public:
    /// @param exemplars must outlive the pyramid: they are its level 0. @param levels wanted, at least 1;
    /// there are fewer where a level would hold no whole patch. @param patch side in pixels.
    /// @param check called now and then; may throw.
    ExemplarPyramid(std::span<const PatchSource> exemplars, int levels, int patch,
                    const std::function<void()>& check);

    int levels() const { return static_cast<int>(m_levels.size()); }
    /// All exemplars at one scale.
    std::span<const PatchSource> level(int number) const {
        return m_levels[static_cast<std::size_t>(number)];
    }
    std::vector<Size> sizes(int number) const;

    /// Levels until the shortest side falls below `side` pixels, at least 1.
    static int levelsFor(std::span<const Size> exemplars, int side);
    /// Bytes of all levels but the first.
    static std::uint64_t bytesFor(std::span<const Size> exemplars, int channels);

private:
    std::vector<Image> m_images; ///< what the views of m_levels show
    std::vector<std::vector<PatchSource>> m_levels;
};

} // namespace texloom
