#pragma once

#include "core/image/position_map.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace texloom {

/// Tells at once which output pixels are copies of an exemplar pixel: the way back of a position map, for
/// whoever points at the exemplar. Of large maps it knows every step-th pixel in each direction; copies of
/// pieces larger than that are found all the same.
class CopyIndex {
public:
    struct Place {
        int x = 0, y = 0;

        friend bool operator==(const Place&, const Place&) = default;
    };

    /// @param most how many output pixels to know. @param check called for every row; may throw.
    explicit CopyIndex(
        const PositionMap& map, std::int64_t most = 1 << 21, const std::function<void()>& check = [] {});

    /// Output pixels that `source` was copied to, row by row, at most `most`.
    std::vector<Place> copiesOf(const Source& source, std::size_t most) const;

    /// Bytes that an index of a map takes, for exemplars of so many pixels together.
    static std::uint64_t bytesFor(std::int64_t exemplarPixels, std::int64_t most = 1 << 21);

private:
    std::size_t cellOf(const Source& source) const;

    Size m_size;
    std::vector<Size> m_exemplars;
    int m_step = 1;
    std::vector<std::uint32_t> m_begin;  ///< by exemplar pixel: where its copies begin in m_copies
    std::vector<std::uint32_t> m_copies; ///< the numbers of output pixels, sorted by source
};

} // namespace texloom
