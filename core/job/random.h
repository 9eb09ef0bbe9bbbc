#pragma once

#include <cstdint>

namespace texloom {

/// Random numbers by coordinate: a pure function of (seed, stream, x, y, n), so that a draw depends on the
/// place it is made for and never on which thread makes it or when. Philox 4x32-10 of Salmon et al.,
/// "Parallel random numbers: as easy as 1, 2, 3" (SC 2011), through Random123.
class Random {
public:
    /// @param stream numbers of one seed in different streams are independent.
    explicit Random(std::uint64_t seed, std::uint32_t stream = 0) : m_seed(seed), m_stream(stream) {}

    /// 32 independent bits for draw `n` at place (x, y).
    std::uint32_t bits(int x, int y, std::uint32_t n = 0) const;
    /// A real number in [0, 1), in steps of 2^-32.
    double uniform(int x, int y, std::uint32_t n = 0) const;
    /// A whole number in [0, count), every one equally likely to within 2^-32 × count. `count` is at least 1.
    std::uint32_t below(std::uint32_t count, int x, int y, std::uint32_t n = 0) const;
    /// A real number of the normal distribution with mean 0 and variance 1 (Box & Muller 1958), within ±6.8.
    double normal(int x, int y, std::uint32_t n = 0) const;

private:
    std::uint64_t m_seed;
    std::uint32_t m_stream;
};

} // namespace texloom
