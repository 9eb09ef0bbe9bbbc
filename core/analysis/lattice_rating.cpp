#include "core/analysis/lattice_rating.h"

#include "core/analysis/lattice_multiples.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace texloom {

namespace {

/// Significant multiples for means that need not include all of them: the nearest, and where there are many,
/// only those that are significant without counting pixels.
std::vector<Vec2> someMultiples(const CorrelationPeaks& peaks, const Lattice& lattice) {
    constexpr int kRings = 24;
    constexpr int kMany = 24;
    const Size exemplar = peaks.size();
    const int rings = std::min(kRings, ringsOf(exemplar, lattice));
    std::vector<Vec2> sure, all;
    int first = 0, second = 0; // how many of the sure ones are multiples of each vector
    eachMultiple(exemplar, lattice, rings, [&](int a, int b, Vec2 p) {
        all.push_back(p);
        if (!overlapHoldsTile(exemplar, lattice, p))
            return;
        sure.push_back(p);
        first += a != 0 ? 1 : 0;
        second += b != 0 ? 1 : 0;
    });
    if (std::min(first, second) >= kMany)
        return sure;
    std::erase_if(all,
                  [&](Vec2 p) { return !significant(exemplar, lattice, p, peaks.criteria().significance); });
    return all;
}

} // namespace

double goodnessOf(double correlation, double multiples, double alpha) {
    return correlation <= 0 ? 0 : std::pow(correlation, alpha) * std::pow(multiples, alpha - 1);
}

double roughGoodness(const CorrelationPeaks& peaks, const Lattice& lattice) {
    constexpr int kRings = 3;
    constexpr double kNear = 0.8;
    const Size size = peaks.size();
    double sum = 0;
    int count = 0;
    eachMultiple(size, lattice, kRings, [&](int, int, Vec2 p) {
        if (std::abs(p.x) < kNear * size.width && std::abs(p.y) < kNear * size.height) {
            sum += peaks.height(p);
            ++count;
        }
    });
    const double all = std::max(1.0, 2.0 * static_cast<double>(size.area()) / lattice.area());
    return count == 0 ? 0 : goodnessOf(sum / count, all, peaks.criteria().alpha);
}

LatticeCandidate rated(const CorrelationPeaks& peaks, const Lattice& lattice) {
    LatticeCandidate candidate{lattice};
    double sum = 0;
    int summed = 0;
    bool first = false, second = false;
    const int rings = ringsOf(peaks.size(), lattice);
    const Thinned thinned(peaks.size(), lattice, rings);
    eachMultiple(peaks.size(), lattice, rings, [&](int a, int b, Vec2 p) {
        if (!significant(peaks.size(), lattice, p, peaks.criteria().significance))
            return;
        ++candidate.multiples;
        if (thinned.keeps(a, b)) {
            sum += peaks.height(p);
            ++summed;
        }
        first = first || a != 0;
        second = second || b != 0;
    });
    if (summed > 0)
        candidate.correlation = sum / summed;
    if (first && second)
        candidate.goodness = goodnessOf(candidate.correlation, candidate.multiples, peaks.criteria().alpha);
    return candidate;
}

double confidenceIn(const CorrelationPeaks& peaks, const LatticeCandidate& candidate) {
    constexpr int kSteps = 4;
    constexpr double kStep = 1.0 / kSteps;
    double on = 0, off = 0, squares = 0;
    int count = 0, between = 0;
    const Lattice& lattice = candidate.lattice;
    for (const Vec2 p : someMultiples(peaks, lattice)) {
        on += peaks.height(p);
        ++count;
        for (int i = 1; i < kSteps * kSteps; ++i) {
            const int right = i % kSteps, down = i / kSteps;
            const Vec2 beside = p + lattice.at(kStep * right, kStep * down);
            if (!peaks.inside(beside, 2))
                continue;
            const double height = peaks.height(beside);
            off += height;
            squares += height * height;
            ++between;
        }
    }
    if (count == 0 || between == 0)
        return 0;
    on /= count;
    off /= between;
    const double contrast = std::max(0.0, (on - off) / (1 - std::min(0.99, off)));
    const double scatter = std::sqrt(std::max(1e-12, squares / between - off * off));
    const double times = contrast / 4 * std::max(0.0, (on - off) / scatter) * std::sqrt(candidate.multiples);
    return contrast / (contrast + 0.1) * (1 - std::exp(-times * times));
}

PlaceEffect placeEffect(const CorrelationPeaks& peaks, const Lattice& lattice, Vec2 along, double distance) {
    constexpr std::size_t kPlaces = 16;
    const Vec2 period = (lattice.area() / distance) * along;
    std::array<double, kPlaces> means{}, squares{};
    const std::vector<Vec2> multiples = someMultiples(peaks, lattice);
    const auto count = static_cast<double>(multiples.size());
    for (const Vec2 p : multiples)
        for (std::size_t i = 0; i < kPlaces; ++i) {
            Vec2 at = p + (double(i) / kPlaces) * period;
            if (!peaks.inside(at, 2))
                at = at - period;
            const double height = peaks.inside(at, 2) ? peaks.height(at) : 0;
            means[i] += height;
            squares[i] += height * height;
        }
    if (count < 2)
        return {};
    double mean = 0, within = 0, between = 0;
    for (std::size_t i = 0; i < kPlaces; ++i) {
        means[i] /= count;
        within += (squares[i] - count * means[i] * means[i]) / (count - 1) / kPlaces;
        mean += means[i] / kPlaces;
    }
    for (const double place : means)
        between += (place - mean) * (place - mean) / (kPlaces - 1);
    const auto [lowest, highest] = std::minmax_element(means.begin(), means.end());
    return {*highest > 0 ? 1 - *lowest / *highest : 0, count * between / std::max(1e-12, within)};
}

} // namespace texloom
