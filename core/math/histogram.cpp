#include "core/math/histogram.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numeric>

namespace texloom {

namespace {

constexpr int kDigitBits = 11;
constexpr std::size_t kDigits = std::size_t{1} << kDigitBits;
/// Samples between two checks.
constexpr std::size_t kEntriesBetweenChecks = std::size_t{1} << 18;

/// An integer that orders as the float does.
std::uint32_t orderedBits(float value) {
    const auto bits = std::bit_cast<std::uint32_t>(value + 0.0F);
    return (bits >> 31) != 0 ? ~bits : bits | 0x80000000U;
}

/// A step coprime to `count`, near its golden section: its multiples scatter evenly.
std::size_t scatteringStep(std::size_t count) {
    auto step = static_cast<std::size_t>(0.6180339887 * static_cast<double>(count));
    while (std::gcd(step, count) != 1)
        ++step;
    return step;
}

} // namespace

void SampleRanks::sort(const PlaneView& plane, const std::function<void()>& check) {
    const auto width = static_cast<std::size_t>(plane.width);
    const std::size_t count = width * static_cast<std::size_t>(plane.height);
    for (auto* values : {&m_order, &m_keys, &m_otherOrder, &m_otherKeys})
        values->resize(count);
    const std::size_t step = scatteringStep(count);
    std::size_t index = 0;
    for (std::size_t i = 0; i < count; ++i, index += step, index -= index >= count ? count : 0) {
        if (i % kEntriesBetweenChecks == 0)
            check();
        m_order[i] = static_cast<std::uint32_t>(index);
        m_keys[i] = orderedBits(plane(static_cast<int>(index % width), static_cast<int>(index / width)));
    }
    for (int shift = 0; shift < 32; shift += kDigitBits) {
        std::array<std::size_t, kDigits> starts{};
        const auto digit = [shift](std::uint32_t key) { return (key >> shift) & (kDigits - 1); };
        for (std::size_t i = 0; i < count; ++i)
            ++starts[digit(m_keys[i])];
        std::exclusive_scan(starts.begin(), starts.end(), starts.begin(), std::size_t{0});
        for (std::size_t i = 0; i < count; ++i) {
            if (i % kEntriesBetweenChecks == 0)
                check();
            const std::size_t to = starts[digit(m_keys[i])]++;
            m_otherKeys[to] = m_keys[i];
            m_otherOrder[to] = m_order[i];
        }
        m_keys.swap(m_otherKeys);
        m_order.swap(m_otherOrder);
    }
}

Histogram::Histogram(const PlaneView& plane, const std::function<void()>& check) {
    SampleRanks ranks;
    ranks.sort(plane, check);
    const auto width = static_cast<std::uint32_t>(plane.width);
    m_sorted.resize(ranks.size());
    for (std::size_t rank = 0; rank < ranks.size(); ++rank)
        m_sorted[rank] = plane(static_cast<int>(ranks[rank] % width), static_cast<int>(ranks[rank] / width));
}

double Histogram::match(const PlaneSpan& plane, SampleRanks& ranks,
                        const std::function<void()>& check) const {
    ranks.sort(plane, check);
    const auto width = static_cast<std::uint32_t>(plane.width);
    const double ratio = static_cast<double>(m_sorted.size()) / static_cast<double>(ranks.size());
    const double last = static_cast<double>(m_sorted.size() - 1);
    double changes = 0;
    for (std::size_t rank = 0; rank < ranks.size(); ++rank) {
        if (rank % kEntriesBetweenChecks == 0)
            check();
        const double at = std::clamp((static_cast<double>(rank) + 0.5) * ratio - 0.5, 0.0, last);
        const auto below = static_cast<std::size_t>(at);
        const auto share = static_cast<float>(at - static_cast<double>(below));
        const float value = m_sorted[below];
        const float next = share > 0 ? m_sorted[below + 1] : value;
        float& sample = plane(static_cast<int>(ranks[rank] % width), static_cast<int>(ranks[rank] / width));
        const float matched = value + share * (next - value);
        const auto change = static_cast<double>(matched - sample);
        changes += change * change;
        sample = matched;
    }
    return changes / static_cast<double>(ranks.size());
}

} // namespace texloom
