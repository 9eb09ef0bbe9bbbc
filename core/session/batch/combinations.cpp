#include "core/session/batch/combinations.h"

#include <limits>
#include <utility>

namespace texloom {

Combinations::Combinations(std::vector<std::size_t> lengths, Fastest fastest)
    : m_lengths(std::move(lengths)), m_fastest(fastest) {
    constexpr std::size_t kMost = std::numeric_limits<std::size_t>::max();
    for (const std::size_t length : m_lengths)
        m_count = m_count > kMost / length ? kMost : m_count * length;
}

std::vector<std::size_t> Combinations::at(std::size_t combination) const {
    std::vector<std::size_t> indices(m_lengths.size());
    for (std::size_t i = 0; i < m_lengths.size(); ++i) {
        const std::size_t list = m_fastest == Fastest::First ? i : m_lengths.size() - 1 - i;
        indices[list] = combination % m_lengths[list];
        combination /= m_lengths[list];
    }
    return indices;
}

} // namespace texloom
