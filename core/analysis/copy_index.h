#pragma once

#include "core/image/position_map.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace texloom {

/// Looks up which output pixels are copies of an exemplar pixel: the inverse of a position map, for pointing
/// at the exemplar. For large maps it records every step-th pixel in each direction, which still finds the
/// copies of larger pieces.
class CopyIndex {
public:
    struct Place {
        int x = 0, y = 0;

        friend bool operator==(const Place&, const Place&) = default;
    };

    /// @param most the largest number of output pixels to record. @param check called for every row; may
    /// throw.
    explicit CopyIndex(
        const PositionMap& map, std::int64_t most = 1 << 21, const std::function<void()>& check = [] {});

    /// Output pixels that `source` was copied to, row by row, at most `most`.
    std::vector<Place> copiesOf(const Source& source, std::size_t most) const;

    /// Bytes that an index of a map takes, for exemplars with this many pixels in total.
    static std::uint64_t bytesFor(std::int64_t exemplarPixels, std::int64_t most = 1 << 21);

private:
    std::size_t cellOf(const Source& source) const;

    Size m_size;
    std::vector<Size> m_exemplars;
    int m_step = 1;
    std::vector<std::uint32_t> m_begin;  ///< by exemplar pixel: where its copies begin in m_copies
    std::vector<std::uint32_t> m_copies; ///< indices of output pixels, sorted by source
};

} // namespace texloom
