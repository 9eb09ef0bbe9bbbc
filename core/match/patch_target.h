#pragma once

#include "core/image/position_map.h"
#include "core/match/interleaved.h"
#include "core/match/patch_source.h"
#include "core/match/whole_patches.h"

#include <cstdint>
#include <vector>

namespace texloom {

/// One image to find patches in, its pixels laid out for distances.
class PatchTarget {
public:
    PatchTarget(const PatchSource& source, int patch)
        : m_pixels(source.image.size(), source.image.channels), m_positions{source.image.width - patch + 1,
                                                                            source.image.height - patch + 1} {
        m_pixels.load(source.image, 0, 0, source.image.size());
        if (source.mask.data)
            allow(source.mask, patch);
    }

    /// Number of patches in each direction, whether they are allowed or not.
    Size positions() const { return m_positions; }
    const Interleaved& pixels() const { return m_pixels; }
    int longerSide() const { return m_positions.longerSide(); }
    /// Number of allowed patches.
    std::int64_t count() const {
        return m_allowed.empty() ? m_positions.area() : static_cast<std::int64_t>(m_list.size());
    }
    /// Whether the patch with this top left pixel is allowed.
    bool has(int x, int y) const {
        return x >= 0 && y >= 0 && x < m_positions.width && y < m_positions.height &&
               (m_allowed.empty() || m_allowed[index(x, y)] != 0);
    }
    /// The nth allowed patch, row by row.
    Source nth(std::int64_t n, std::uint16_t exemplar) const {
        const std::int64_t at = m_allowed.empty() ? n : m_list[static_cast<std::size_t>(n)];
        return {static_cast<std::uint16_t>(at % m_positions.width),
                static_cast<std::uint16_t>(at / m_positions.width), exemplar};
    }

private:
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(m_positions.width) +
               static_cast<std::size_t>(x);
    }

    void allow(const PlaneView& mask, int patch) {
        m_allowed.assign(static_cast<std::size_t>(m_positions.area()), 0);
        anyWholePatch(mask, patch, [this](int x, int y) {
            m_allowed[index(x, y)] = 1;
            m_list.push_back(static_cast<std::int32_t>(index(x, y)));
            return false;
        });
    }

    Interleaved m_pixels;
    Size m_positions;
    std::vector<std::uint8_t> m_allowed; ///< empty: all
    std::vector<std::int32_t> m_list;    ///< the allowed ones
};

} // namespace texloom
