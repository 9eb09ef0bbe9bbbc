#pragma once

#include <cstddef>
#include <vector>

namespace texloom {

/// All ways to take one value from each of several lists, in order.
class Combinations {
public:
    /// Which list's values change from one combination to the next.
    enum class Fastest { First, Last };

    /// @param lengths of the lists, at least 1 each; without lists there is one combination, of nothing.
    Combinations(std::vector<std::size_t> lengths, Fastest fastest);

    /// How many there are; the largest number there is where they are more than that.
    std::size_t count() const { return m_count; }
    /// For each list the index of its value in one combination, which is less than count().
    std::vector<std::size_t> at(std::size_t combination) const;

private:
    std::vector<std::size_t> m_lengths;
    Fastest m_fastest;
    std::size_t m_count = 1;
};

} // namespace texloom
