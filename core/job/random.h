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

/// A few numbers from one draw of Random (Marsaglia's xorshift), where a draw each would cost too much.
class QuickRandom {
public:
    explicit QuickRandom(std::uint32_t bits) : m_state(bits | 1U) {}
    /// In [-radius, radius].
    int within(int radius) {
        m_state ^= m_state << 13U;
        m_state ^= m_state >> 17U;
        m_state ^= m_state << 5U;
        const auto range = 2 * static_cast<std::uint64_t>(radius) + 1;
        return static_cast<int>((m_state * range) >> 32U) - radius;
    }

private:
    std::uint32_t m_state;
};

} // namespace texloom
