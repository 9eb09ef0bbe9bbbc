#include "core/analysis/lattice_detector.h"

#include "core/analysis/correlation_peaks.h"
#include "core/analysis/lattice_fit.h"
#include "core/analysis/lattice_multiples.h"
#include "core/analysis/lattice_rating.h"
#include "core/analysis/lattice_rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

namespace texloom {

namespace {

constexpr std::size_t kShortlist = 32;
constexpr std::size_t kReported = 4;
constexpr double kTrusted = 0.5; // confidence
constexpr double kHalf = 0.5;    // of the best goodness, for an alternative
constexpr double kSame = 1.5;    // pixels between vectors that count as equal

/// Polynomials of degree 0 to 2 on `length` points, orthonormal.
std::array<std::vector<double>, 3> polynomials(int length) {
    std::array<std::vector<double>, 3> basis;
    for (std::size_t degree = 0; degree < basis.size(); ++degree) {
        std::vector<double>& own = basis[degree];
        for (int i = 0; i < length; ++i)
            own.push_back(std::pow(2 * (i + 0.5) / length - 1, static_cast<double>(degree)));
        for (std::size_t lower = 0; lower < degree; ++lower) {
            double shared = 0;
            for (std::size_t i = 0; i < own.size(); ++i)
                shared += own[i] * basis[lower][i];
            for (std::size_t i = 0; i < own.size(); ++i)
                own[i] -= shared * basis[lower][i];
        }
        double norm = 0;
        for (const double value : own)
            norm += value * value;
        for (double& value : own)
            value = norm > 0 ? value / std::sqrt(norm) : 0;
    }
    return basis;
}

/// Subtracts from a channel the quadratic surface that fits it best.
void flatten(PlaneSpan plane) {
    const auto across = polynomials(plane.width), down = polynomials(plane.height);
    std::array<std::array<double, 3>, 3> weights{};
    for (int y = 0; y < plane.height; ++y) {
        std::array<double, 3> row{};
        for (int x = 0; x < plane.width; ++x)
            for (std::size_t i = 0; i < 3; ++i)
                row[i] += static_cast<double>(plane(x, y)) * across[i][static_cast<std::size_t>(x)];
        for (std::size_t j = 0; j < 3; ++j)
            for (std::size_t i = 0; i + j < 3; ++i)
                weights[j][i] += row[i] * down[j][static_cast<std::size_t>(y)];
    }
    for (int y = 0; y < plane.height; ++y) {
        std::array<double, 3> row{};
        for (std::size_t j = 0; j < 3; ++j)
            for (std::size_t i = 0; i + j < 3; ++i)
                row[i] += weights[j][i] * down[j][static_cast<std::size_t>(y)];
        for (int x = 0; x < plane.width; ++x)
            for (std::size_t i = 0; i < 3; ++i)
                plane(x, y) -= static_cast<float>(row[i] * across[i][static_cast<std::size_t>(x)]);
    }
}

/// Candidate lattices of a texture.
class Search {
public:
    explicit Search(const CorrelationPeaks& peaks) : m_peaks(peaks) {}

    /// Tries pairs of peaks and parts of the best of them.
    void run();
    /// Puts the best into the analysis. @param rows of the texture, if it has any.
    void report(const std::optional<Rows>& rows, LatticeAnalysis& analysis) const;

private:
    void reportRepeating(const std::optional<Rows>& rows, LatticeAnalysis& analysis) const;
    std::vector<Lattice> likelyPairs() const;
    void addUnlike(const Lattice& lattice);
    void addFiner();
    std::vector<LatticeCandidate> candidates(const std::optional<Rows>& rows) const;

    const CorrelationPeaks& m_peaks;
    std::vector<Lattice> m_lattices;
};

/// Pairs of peaks, reduced, most likely first.
std::vector<Lattice> Search::likelyPairs() const {
    constexpr double kLeastArea = 6;
    const std::vector<CorrelationPeaks::Peak> chosen = m_peaks.dominant();
    std::set<std::tuple<int, int, int, int>> seen;
    std::vector<std::pair<double, Lattice>> rough;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        m_peaks.check();
        for (std::size_t j = 0; j < i; ++j) {
            const Lattice raw{{double(chosen[i].x), double(chosen[i].y)},
                              {double(chosen[j].x), double(chosen[j].y)}};
            if (raw.area() < kLeastArea)
                continue;
            const Lattice pair = raw.reduced();
            const auto round = [](double v) { return static_cast<int>(std::lround(v)); };
            if (std::min(pair.v1.length(), pair.v2.length()) < kShortestVector ||
                !seen.emplace(round(pair.v1.x), round(pair.v1.y), round(pair.v2.x), round(pair.v2.y)).second)
                continue;
            if (const double goodness = roughGoodness(m_peaks, pair); goodness > 0)
                rough.emplace_back(-goodness, pair);
        }
    }
    std::stable_sort(rough.begin(), rough.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<Lattice> pairs;
    for (const auto& [minus, pair] : rough)
        pairs.push_back(pair);
    return pairs;
}

void Search::addUnlike(const Lattice& lattice) {
    if (std::min(lattice.v1.length(), lattice.v2.length()) >= kShortestVector &&
        std::none_of(m_lattices.begin(), m_lattices.end(),
                     [&](const Lattice& known) { return known.like(lattice, kSame); }))
        m_lattices.push_back(lattice);
}

void Search::run() {
    for (const Lattice& pair : likelyPairs()) {
        if (m_lattices.size() == kShortlist)
            break;
        m_peaks.check();
        addUnlike(fitted(m_peaks, pair));
    }
    addFiner();
}

/// Adds the lattices with two or three times as many points where those fit equally well: their vectors may
/// not be among the peaks.
void Search::addFiner() {
    constexpr double kWorthTrying = 0.75; // of the coarser lattice's goodness
    static const std::array<std::array<double, 3>, 7> kDivisions = {
        {{1, 0, 2}, {0, 1, 2}, {1, 1, 2}, {1, 0, 3}, {0, 1, 3}, {1, 1, 3}, {1, -1, 3}}};
    for (std::size_t i = 0; i < m_lattices.size() && m_lattices.size() < 2 * kShortlist; ++i) {
        m_peaks.check();
        const Lattice coarse = m_lattices[i];
        const double reached = roughGoodness(m_peaks, coarse);
        for (const auto& [a, b, parts] : kDivisions) {
            const Vec2 point = (1 / parts) * coarse.at(a, b);
            const Lattice raw = (a == 0 ? Lattice{coarse.v1, point} : Lattice{point, coarse.v2}).reduced();
            if (std::min(raw.v1.length(), raw.v2.length()) >= kShortestVector &&
                roughGoodness(m_peaks, raw) >= kWorthTrying * reached)
                addUnlike(fitted(m_peaks, raw));
        }
    }
}

constexpr double kLeastDip = 0.1; // of γ between two multiples of a vector

/// Whether γ hardly falls between two multiples of one of the vectors, which then gives no more than a
/// direction.
bool onRidge(const CorrelationPeaks& peaks, const Lattice& lattice) {
    const auto flat = [&](Vec2 v) {
        return placeEffect(peaks, lattice, (1 / v.length()) * v, lattice.area() / v.length()).dip < kLeastDip;
    };
    return flat(lattice.v1) || flat(lattice.v2);
}

/// Whether a lattice whose points all lie on the rows tells no more than the rows do.
bool onlyRows(const CorrelationPeaks& peaks, const Lattice& lattice, const Rows& rows) {
    constexpr double kByChance = 10; // the best of very many lattices comes near this
    const Vec2 across{-rows.along.y, rows.along.x};
    const double a = dot(lattice.v1, across) / rows.distance, b = dot(lattice.v2, across) / rows.distance;
    if (std::max(std::abs(a - std::round(a)), std::abs(b - std::round(b))) * rows.distance > kSame)
        return false;
    const auto row = [](double v) { return static_cast<int>(std::abs(std::lround(v))); };
    const int every = std::max(1, std::gcd(row(a), row(b)));
    const PlaceEffect effect = placeEffect(peaks, lattice, rows.along, every * rows.distance);
    return effect.dip < kLeastDip || effect.ratio < kByChance;
}

/// All lattices that were found, rated, best first.
std::vector<LatticeCandidate> Search::candidates(const std::optional<Rows>& rows) const {
    std::vector<LatticeCandidate> all;
    for (const Lattice& lattice : m_lattices) {
        m_peaks.check();
        const LatticeCandidate candidate = rated(m_peaks, lattice);
        const bool trusted = rows && rows->confidence >= kTrusted;
        if (candidate.goodness > 0 && !onRidge(m_peaks, lattice) &&
            !(trusted && onlyRows(m_peaks, lattice, *rows)))
            all.push_back(candidate);
    }
    std::stable_sort(all.begin(), all.end(), [](const LatticeCandidate& a, const LatticeCandidate& b) {
        return a.goodness > b.goodness;
    });
    return all;
}

/// Fills a list up to what is reported. A lattice that is part of a better one, and fits no better at its own
/// points, comes last.
void addBest(std::vector<LatticeCandidate>& reported, const std::vector<LatticeCandidate>& all) {
    std::vector<LatticeCandidate> parts;
    for (const LatticeCandidate& next : all) {
        const auto known = [&](const LatticeCandidate& r) { return r.lattice.like(next.lattice, kSame); };
        if (std::any_of(reported.begin(), reported.end(), known))
            continue;
        const auto says = [&](const LatticeCandidate& better) {
            return better.lattice.includes(next.lattice, kSame) &&
                   next.correlation < 1.05 * better.correlation;
        };
        const bool part = std::any_of(reported.begin(), reported.end(), says);
        (part ? parts : reported).push_back(next);
    }
    reported.insert(reported.end(), parts.begin(), parts.end());
    reported.resize(std::min(reported.size(), kReported));
}

/// The smallest tile that is half as good as the best and stands out itself; none if that is the best.
std::optional<LatticeCandidate> smallestTile(const CorrelationPeaks& peaks,
                                             std::vector<LatticeCandidate> candidates) {
    constexpr double kSmaller = 0.75;
    const LatticeCandidate best = candidates.front();
    std::erase_if(candidates, [&](const LatticeCandidate& c) {
        return c.goodness < kHalf * best.goodness || c.lattice.area() > kSmaller * best.lattice.area();
    });
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const LatticeCandidate& a, const LatticeCandidate& b) {
                         return a.lattice.area() < b.lattice.area();
                     });
    for (const LatticeCandidate& candidate : candidates) {
        peaks.check();
        if (confidenceIn(peaks, candidate) >= kTrusted)
            return candidate;
    }
    return {};
}

void Search::report(const std::optional<Rows>& rows, LatticeAnalysis& analysis) const {
    reportRepeating(rows, analysis);
    if (analysis.confidence >= kTrusted)
        return;
    // Where nothing repeats, a direction may still be of use.
    const std::optional<Rows> ordered = findOrderedRows(m_peaks);
    if (!ordered || ordered->confidence < kTrusted)
        return;
    analysis.confidence = ordered->confidence;
    std::vector<LatticeCandidate>& reported = analysis.candidates;
    std::erase_if(reported, [](const LatticeCandidate& c) { return c.lattice.rowsOnly(); });
    reported.insert(reported.begin(), ordered->candidate);
    reported.resize(std::min(reported.size(), kReported));
}

void Search::reportRepeating(const std::optional<Rows>& rows, LatticeAnalysis& analysis) const {
    const std::vector<LatticeCandidate> all = candidates(rows);
    std::vector<LatticeCandidate>& reported = analysis.candidates;
    if (!all.empty()) {
        reported.push_back(all.front());
        analysis.confidence = confidenceIn(m_peaks, all.front());
    }
    // Rows serve as the lattice where no other is reliable.
    if (rows && rows->candidate.goodness > 0 &&
        (all.empty() || rows->candidate.correlation >= kHalf * all.front().correlation)) {
        const bool first = all.empty() || (analysis.confidence < kTrusted && rows->confidence >= kTrusted);
        reported.insert(first ? reported.begin() : reported.end(), rows->candidate);
        analysis.confidence = first ? rows->confidence : analysis.confidence;
    }
    if (all.empty())
        return;
    if (const std::optional<LatticeCandidate> finest = smallestTile(m_peaks, all))
        reported.push_back(*finest);
    addBest(reported, all);
    std::stable_sort(
        reported.begin() + 1, reported.end(),
        [](const LatticeCandidate& a, const LatticeCandidate& b) { return a.goodness > b.goodness; });
}

} // namespace

LatticeCandidate fittedLattice(const Correlation& correlation, const Lattice& rough,
                               const std::function<void()>& check) {
    const CorrelationPeaks peaks(correlation, check);
    const Lattice shortest = rough.reduced();
    const bool rows = std::min(shortest.v1.length(), shortest.v2.length()) < kShortestVector;
    LatticeCandidate candidate = rated(peaks, rows ? fittedRows(peaks, shortest) : fitted(peaks, shortest));
    const Lattice near{candidate.lattice.nearest(rough.v1), candidate.lattice.nearest(rough.v2)};
    const bool same = std::abs(near.area() - candidate.lattice.area()) < 0.5 * candidate.lattice.area();
    candidate.lattice = same ? near : rough;
    return candidate;
}

LatticeCandidate ratedLattice(const Correlation& correlation, const Lattice& lattice,
                              const std::function<void()>& check) {
    return rated(CorrelationPeaks(correlation, check), lattice);
}

LatticeAnalysis analyzeLattice(const ImageView& exemplar, const std::function<void()>& check) {
    LatticeAnalysis analysis;
    if (exemplar.size().shorterSide() < 8)
        return analysis;
    Image flat(exemplar);
    for (int c = 0; c < flat.channels(); ++c) {
        check();
        flatten(flat.plane(c));
    }
    analysis.correlation = autocorrelation(flat, check);
    const CorrelationPeaks peaks(analysis.correlation, check);
    Search search(peaks);
    search.run();
    search.report(findRows(peaks), analysis);
    return analysis;
}

std::uint64_t latticeBytesFor(Size exemplar, int channels) {
    const auto pixels = static_cast<std::uint64_t>(exemplar.area());
    // Transforms of twice the exemplar in each direction and a little more, γ twice, integral images.
    constexpr std::uint64_t kTransforms = 5 * 8 * 5, kSums = 2 * sizeof(double) + 2 * sizeof(float);
    return pixels * (kTransforms + kSums * static_cast<std::uint64_t>(channels)) + (4U << 20);
}

double latticeSecondsFor(Size exemplar) {
    return 4e-7 * static_cast<double>(exemplar.area());
}

} // namespace texloom
