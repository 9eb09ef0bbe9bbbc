#include "core/math/transport.h"

#include <algorithm>
#include <numeric>

namespace texloom {

namespace {

/// The cumulative sum at the pixels' borders, from 0 to 1.
std::vector<double> cumulative(std::span<const float> signal) {
    std::vector<double> sums(signal.size() + 1, 0.0);
    for (std::size_t i = 0; i < signal.size(); ++i)
        sums[i + 1] = sums[i] + std::max(0.0, static_cast<double>(signal[i]));
    const double whole = sums.back();
    for (std::size_t i = 0; i < sums.size(); ++i)
        sums[i] = whole > 0 ? sums[i] / whole : static_cast<double>(i) / static_cast<double>(signal.size());
    sums.back() = 1;
    return sums;
}

/// Where a cumulative sum on the way from one border to the next has reached `mass`.
double placeAt(const std::vector<double>& sums, std::size_t next, double mass) {
    const double before = sums[next - 1], step = sums[next] - before;
    const auto place = static_cast<double>(next - 1);
    return step > 0 ? place + std::clamp((mass - before) / step, 0.0, 1.0) : place;
}

} // namespace

Midway::Midway(std::span<const float> first, std::span<const float> second, double share)
    : m_length(static_cast<int>(first.size())), m_mass((1 - share) * massOf(first) + share * massOf(second)) {
    const std::vector<double> a = cumulative(first), b = cumulative(second);
    const auto add = [&](double mass, double placeA, double placeB) {
        m_knots.push_back({mass, placeA, placeB, (1 - share) * placeA + share * placeB});
    };
    add(0, 0, 0);
    // Both sums are followed together; a border of either is a knot. Where one is constant, its place
    // advances while the other's waits; where both are, they advance together.
    std::size_t i = 1, j = 1;
    while (i < a.size() || j < b.size()) {
        const double nextA = i < a.size() ? a[i] : 2, nextB = j < b.size() ? b[j] : 2;
        if (nextA == nextB) {
            add(nextA, static_cast<double>(i++), static_cast<double>(j++));
        } else if (nextA < nextB) {
            add(nextA, static_cast<double>(i), j < b.size() ? placeAt(b, j, nextA) : m_length);
            ++i;
        } else {
            add(nextB, i < a.size() ? placeAt(a, i, nextB) : m_length, static_cast<double>(j));
            ++j;
        }
    }
}

std::vector<double> Midway::placesOf(double Knot::*which) const {
    std::vector<double> places;
    std::size_t at = 1;
    for (int x = 0; x <= m_length; ++x) {
        while (at + 1 < m_knots.size() && m_knots[at].between < x)
            ++at;
        const Knot& before = m_knots[at - 1];
        const Knot& after = m_knots[at];
        const double step = after.between - before.between;
        const double part = step > 0 ? std::clamp((x - before.between) / step, 0.0, 1.0) : 1.0;
        places.push_back(before.*which + part * (after.*which - before.*which));
    }
    return places;
}

std::vector<float> Midway::signal() const {
    const std::vector<double> sums = placesOf(&Knot::mass);
    std::vector<float> signal;
    for (std::size_t i = 0; i + 1 < sums.size(); ++i)
        signal.push_back(static_cast<float>(m_mass * (sums[i + 1] - sums[i])));
    return signal;
}

std::vector<float> deformed(std::span<const float> signal, std::span<const double> places, double mass) {
    const std::vector<double> sums = cumulative(signal);
    const auto at = [&](double place) {
        const auto index =
            static_cast<std::size_t>(std::clamp(place, 0.0, static_cast<double>(signal.size()) - 1e-9));
        return sums[index] + (place - static_cast<double>(index)) * (sums[index + 1] - sums[index]);
    };
    std::vector<float> result;
    for (std::size_t i = 0; i < signal.size(); ++i)
        result.push_back(static_cast<float>(mass * (at(places[i + 1]) - at(places[i]))));
    return result;
}

double massOf(std::span<const float> signal) {
    return std::accumulate(signal.begin(), signal.end(), 0.0);
}

} // namespace texloom
