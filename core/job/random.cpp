#include "core/job/random.h"

#include <Random123/philox.h>

#include <cmath>
#include <numbers>

namespace texloom {

std::uint32_t Random::bits(int x, int y, std::uint32_t n) const {
    using Generator = r123::Philox4x32;
    const Generator::ctr_type counter = {
        {static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), n / 4, m_stream}};
    const Generator::key_type key = {
        {static_cast<std::uint32_t>(m_seed), static_cast<std::uint32_t>(m_seed >> 32)}};
    return Generator{}(counter, key)[n % 4];
}

double Random::uniform(int x, int y, std::uint32_t n) const {
    return bits(x, y, n) * 0x1p-32;
}

double Random::normal(int x, int y, std::uint32_t n) const {
    const double radius = std::sqrt(-2 * std::log((bits(x, y, 2 * n) + 0.5) * 0x1p-32));
    return radius * std::cos(2 * std::numbers::pi * uniform(x, y, 2 * n + 1));
}

std::uint32_t Random::below(std::uint32_t count, int x, int y, std::uint32_t n) const {
    return static_cast<std::uint32_t>((static_cast<std::uint64_t>(bits(x, y, n)) * count) >> 32);
}

} // namespace texloom
