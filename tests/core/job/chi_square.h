#pragma once

#include <vector>

namespace texloom::test {

/// χ² of counts against evenness; about the number of cells less one, ± its √2-fold root, if they are even.
inline double chiSquare(const std::vector<int>& counts) {
    double total = 0;
    for (const int count : counts)
        total += count;
    const double expected = total / static_cast<double>(counts.size());
    double sum = 0;
    for (const int count : counts)
        sum += (count - expected) * (count - expected) / expected;
    return sum;
}

constexpr double kLeast255 = 160, kMost255 = 370; ///< four standard deviations about 255, for 256 cells

} // namespace texloom::test
