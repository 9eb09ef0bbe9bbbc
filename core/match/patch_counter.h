#pragma once

#include "core/image/position_map.h"
#include "core/image/size.h"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace texloom {

/// How often the pixels of each of an exemplar's patches are in use, kept up to date while patches are taken
/// and given back one by one (U and Π of Gutierrez, thesis 2020, eq. 3.10-3.12).
class PatchCounter {
public:
    /// @param patches by top left pixel. @param sizes of the exemplars. @param patch side in pixels.
    /// @param wanted number of patches that will be in use.
    PatchCounter(std::vector<Source> patches, std::span<const Size> sizes, int patch, std::int64_t wanted);

    /// The number of the patch at a place, or −1.
    int numberOf(const Source& source) const;
    /// Takes a patch (1) or gives it back (−1). `changed` is told of each patch that shares pixels with it.
    void count(int number, int times, const std::function<void(int number)>& changed);
    /// Mean use of a patch's pixels, relative to that if all pixels were used equally: Π_patch / Π_best.
    double share(int number) const { return static_cast<double>(m_uses[at(number)]) / m_even; }

private:
    static std::size_t at(int number) { return static_cast<std::size_t>(number); }

    std::vector<Source> m_patches;
    std::vector<Size> m_sizes;
    int m_patch;
    double m_even;                           ///< of m_uses if all pixels are used equally
    std::vector<std::vector<int>> m_numbers; ///< by exemplar and pixel
    std::vector<std::int64_t> m_uses;        ///< by patch: the sum of the uses of its pixels
};

} // namespace texloom
