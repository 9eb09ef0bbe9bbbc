#include "core/analysis/correlation_peaks.h"

#include "core/analysis/lattice_multiples.h"

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

namespace texloom {

namespace {

constexpr std::size_t kMostPeaks = 56;
constexpr std::size_t kShortPeaks = 12;
constexpr std::size_t kConsidered = 1500;

using Peak = CorrelationPeaks::Peak;

Correlation smoothed(const Correlation& gamma) {
    Correlation smooth = gamma;
    const auto row = [&](int x, int y) {
        return gamma.at(x - 1, y) + 2 * gamma.at(x, y) + gamma.at(x + 1, y);
    };
    for (int y = 1 - gamma.top(); y < gamma.bottom(); ++y)
        for (int x = 1 - gamma.left(); x < gamma.right(); ++x)
            smooth.at(x, y) = (row(x, y - 1) + 2 * row(x, y) + row(x, y + 1)) / 16;
    return smooth;
}

/// Indices of the maxima, ordered by the distance of each from a higher one and from the origin, farthest
/// first.
/// @param peaks highest first.
std::vector<std::size_t> byDominance(const std::vector<Peak>& peaks) {
    std::vector<std::pair<double, std::size_t>> reach;
    for (std::size_t i = 0; i < peaks.size(); ++i) {
        double nearest = std::hypot(peaks[i].x, peaks[i].y);
        for (std::size_t j = 0; j < i; ++j) {
            nearest = std::min(nearest, std::hypot(peaks[i].x - peaks[j].x, peaks[i].y - peaks[j].y));
            nearest = std::min(nearest, std::hypot(peaks[i].x + peaks[j].x, peaks[i].y + peaks[j].y));
        }
        reach.emplace_back(-nearest, i);
    }
    std::sort(reach.begin(), reach.end());
    std::vector<std::size_t> order;
    for (const auto& [minus, i] : reach)
        order.push_back(i);
    return order;
}

/// Indices of the maxima that are not low, nearest to the origin first.
std::vector<std::size_t> byLength(const std::vector<Peak>& peaks) {
    constexpr float kHighEnough = 0.25F;
    std::vector<std::pair<double, std::size_t>> lengths;
    for (std::size_t i = 0; i < peaks.size() && peaks[i].height > kHighEnough * peaks.front().height; ++i)
        lengths.emplace_back(std::hypot(peaks[i].x, peaks[i].y), i);
    std::sort(lengths.begin(), lengths.end());
    std::vector<std::size_t> order;
    for (const auto& [length, i] : lengths)
        order.push_back(i);
    return order;
}

} // namespace

CorrelationPeaks::CorrelationPeaks(const Correlation& gamma, const std::function<void()>& check,
                                   const LatticeCriteria& criteria)
    : m_check(check), m_criteria(criteria), m_smooth(smoothed(gamma)) {}

Peak CorrelationPeaks::summit(Vec2 near, int reach) const {
    const int cx = static_cast<int>(std::lround(near.x)), cy = static_cast<int>(std::lround(near.y));
    Peak best{cx, cy, -2};
    for (int y = cy - reach; y <= cy + reach; ++y)
        for (int x = cx - reach; x <= cx + reach; ++x)
            if (m_smooth.contains(x, y) && m_smooth.at(x, y) > best.height)
                best = {x, y, m_smooth.at(x, y)};
    return best;
}

/// Local maxima of the half plane, highest first.
std::vector<Peak> CorrelationPeaks::all() const {
    std::vector<Peak> found;
    const int right = static_cast<int>(size().width * kLongestVector);
    const int bottom = static_cast<int>(size().height * kLongestVector);
    for (int y = 0; y <= std::min(bottom, size().height - 3); ++y) {
        m_check();
        for (int x = -right; x <= right; ++x) {
            if ((y == 0 && x <= 0) || !inside({double(x), double(y)}, 1) ||
                std::hypot(x, y) < kShortestVector)
                continue;
            const float here = m_smooth.at(x, y);
            bool highest = here > 0;
            for (int dy = -1; dy <= 1 && highest; ++dy)
                for (int dx = -1; dx <= 1; ++dx)
                    highest = highest && m_smooth.at(x + dx, y + dy) <= here;
            if (highest)
                found.push_back({x, y, here});
        }
    }
    std::sort(found.begin(), found.end(), [](const Peak& a, const Peak& b) {
        return std::tuple(-a.height, a.y, a.x) < std::tuple(-b.height, b.y, b.x);
    });
    return found;
}

std::vector<Peak> CorrelationPeaks::dominant() const {
    std::vector<Peak> peaks = all();
    peaks.resize(std::min(peaks.size(), kConsidered));
    std::set<std::size_t> chosen;
    for (std::size_t i = 0; i < std::min(kMostPeaks / 2, peaks.size()); ++i)
        chosen.insert(i);
    const std::vector<std::size_t> nearest = byLength(peaks);
    chosen.insert(nearest.begin(),
                  nearest.begin() + static_cast<std::ptrdiff_t>(std::min(kShortPeaks, nearest.size())));
    for (const std::size_t i : byDominance(peaks)) {
        if (chosen.size() >= kMostPeaks)
            break;
        chosen.insert(i);
    }
    std::vector<Peak> kept;
    for (const std::size_t i : chosen)
        kept.push_back(peaks[i]);
    return kept;
}

} // namespace texloom
