#pragma once

#include "core/base/large_memory.h"
#include "core/image/image.h"

#include <cstdint>
#include <span>
#include <vector>

namespace texloom {

/// Where one output pixel came from: column and row in an exemplar, and which exemplar.
struct Source {
    std::uint16_t x = kNone;
    std::uint16_t y = kNone;
    std::uint16_t exemplar = kNone;

    /// Stands for "no source" in each member.
    static constexpr std::uint16_t kNone = 65535;

    bool valid() const { return exemplar != kNone; }
    friend bool operator==(const Source&, const Source&) = default;
};

/// For every output pixel the exemplar pixel it was copied from: the coordinate transform of Ashikhmin (2001)
/// and the synthesis map of Raad & Galerne (IPOL 2017, section 4). Applying it to another image of the
/// exemplar's size (a normal map, say) gives that image in register with the result.
/// Exemplars are at most 65,535 px on a side.
class PositionMap {
public:
    PositionMap() = default;
    /// Every pixel without a source. @param exemplarSizes size in pixels of each exemplar, in their order.
    PositionMap(Size size, std::vector<Size> exemplarSizes);
    /// The identity map of an image of this size.
    static PositionMap identity(Size size);

    Size size() const { return m_size; }
    int width() const { return m_size.width; }
    int height() const { return m_size.height; }
    const std::vector<Size>& exemplarSizes() const { return m_exemplarSizes; }
    static std::uint64_t bytesFor(Size size) {
        return static_cast<std::uint64_t>(size.area()) * sizeof(Source);
    }

    Source& at(int x, int y) { return m_sources[index(x, y)]; }
    const Source& at(int x, int y) const { return m_sources[index(x, y)]; }

    /// The picture that this map makes of `exemplars` (one image per exemplar, each of that exemplar's size,
    /// all with the same number of channels): output pixel p is exemplar pixel at(p), bit for bit; pixels
    /// without a source are 0. @throws Error naming sizes if the images do not fit the map.
    Image apply(std::span<const ImageView> exemplars) const;
    Image apply(const ImageView& exemplar) const { return apply(std::span<const ImageView>(&exemplar, 1)); }

    /// Keeps the top left `size` pixels, in place.
    void shrink(Size size);

    friend bool operator==(const PositionMap&, const PositionMap&) = default;

private:
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(m_size.width) +
               static_cast<std::size_t>(x);
    }

    Size m_size;
    std::vector<Size> m_exemplarSizes;
    std::vector<Source, LargeAllocator<Source>> m_sources;
};

} // namespace texloom
