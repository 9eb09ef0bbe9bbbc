#include "core/analysis/lattice_detector.h"

#include "core/analysis/correlation_peaks.h"
#include "core/analysis/lattice_fit.h"
#include "core/analysis/lattice_multiples.h"
#include "core/analysis/lattice_rating.h"
#include "core/analysis/lattice_rows.h"
#include "core/analysis/lattice_views.h"

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

/// Candidate lattices of a texture.
class Search {
public:
    /// @param every whether all of divisions() are tried
    Search(const CorrelationPeaks& peaks, bool every) : m_peaks(peaks), m_every(every) {}

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
    bool m_every;
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

/// Lattices with two and three times as many points, or also five and seven times: each has one at (a v1 + b
/// v2) / parts, and v1 where a is 0, else v2.
std::vector<std::array<double, 3>> divisions(bool all) {
    std::vector<std::array<double, 3>> some = {{1, 0, 2}, {0, 1, 2}, {1, 1, 2}, {1, 0, 3},
                                               {0, 1, 3}, {1, 1, 3}, {1, -1, 3}};
    for (const int parts : {5, 7}) {
        if (!all)
            break;
        some.push_back({0, 1, double(parts)});
        for (int b = 0; b < parts; ++b)
            some.push_back({1, double(b), double(parts)});
    }
    return some;
}

/// Adds the lattices of divisions() where those fit equally well: their vectors may not be among the peaks.
void Search::addFiner() {
    constexpr double kWorthTrying = 0.75; // of the coarser lattice's goodness
    const std::vector<std::array<double, 3>> parted = divisions(m_every);
    for (std::size_t i = 0; i < m_lattices.size() && m_lattices.size() < 2 * kShortlist; ++i) {
        m_peaks.check();
        const Lattice coarse = m_lattices[i];
        const double reached = roughGoodness(m_peaks, coarse);
        for (const auto& [a, b, parts] : parted) {
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

LatticeCandidate fittedLattice(const LatticeAnalysis& analysis, const Lattice& rough,
                               const std::function<void()>& check) {
    const CorrelationPeaks peaks(analysis.rating(), check, analysis.criteria);
    const Lattice shortest = rough.reduced();
    const bool rows = std::min(shortest.v1.length(), shortest.v2.length()) < kShortestVector;
    LatticeCandidate candidate = rated(peaks, rows ? fittedRows(peaks, shortest) : fitted(peaks, shortest));
    const Lattice near{candidate.lattice.nearest(rough.v1), candidate.lattice.nearest(rough.v2)};
    const bool same = std::abs(near.area() - candidate.lattice.area()) < 0.5 * candidate.lattice.area();
    candidate.lattice = same ? near : rough;
    return candidate;
}

LatticeCandidate ratedLattice(const LatticeAnalysis& analysis, const Lattice& lattice,
                              const std::function<void()>& check) {
    return rated(CorrelationPeaks(analysis.rating(), check, analysis.criteria), lattice);
}

namespace {

LatticeAnalysis analysisOf(const ImageView& view, bool every, const std::function<void()>& check,
                           const LatticeCriteria& criteria) {
    LatticeAnalysis analysis;
    analysis.criteria = criteria;
    analysis.correlation = autocorrelation(view, check);
    const CorrelationPeaks peaks(analysis.correlation, check, criteria);
    Search search(peaks, every);
    search.run();
    search.report(findRows(peaks), analysis);
    return analysis;
}

/// Makes the best candidate of another view the last of those reported.
void addOther(std::vector<LatticeCandidate>& reported, const std::vector<LatticeCandidate>& others) {
    if (others.empty() || std::any_of(reported.begin(), reported.end(), [&](const LatticeCandidate& known) {
            return known.lattice.like(others.front().lattice, kSame);
        }))
        return;
    reported.resize(std::min(reported.size(), kReported - 1));
    reported.push_back(others.front());
}

/// Whether nothing but rounding is left of an exemplar without its light, which has edges of its own.
bool isPlain(const ImageView& exemplar, const ImageView& flat) {
    constexpr float kRounding = 1e-5F;
    const ValueRange whole = valueRange(exemplar), left = valueRange(flat);
    return left.largest - left.smallest <=
           kRounding * std::max(std::abs(whole.largest), std::abs(whole.smallest));
}

} // namespace

LatticeAnalysis analyzeLattice(const ImageView& exemplar, const std::function<void()>& check,
                               const LatticeCriteria& criteria) {
    if (exemplar.size().shorterSide() < 8)
        return {};
    const Image flat = withoutLight(exemplar, check);
    LatticeAnalysis analysis = analysisOf(flat, false, check, criteria);
    if (analysis.found() || isPlain(exemplar, flat))
        return analysis;
    LatticeAnalysis edges = analysisOf(edgesOf(flat, check), true, check, criteria);
    if (!edges.found()) {
        addOther(analysis.candidates, edges.candidates);
        return analysis;
    }
    addOther(edges.candidates, analysis.candidates);
    edges.edges = std::exchange(edges.correlation, std::move(analysis.correlation));
    return edges;
}

std::uint64_t latticeBytesFor(Size exemplar, int channels) {
    const auto pixels = static_cast<std::uint64_t>(exemplar.area());
    // Transforms of twice the exemplar in each direction and a little more, γ twice, integral images.
    constexpr std::uint64_t kTransforms = 5 * 8 * 5, kSums = 2 * sizeof(double) + 2 * sizeof(float);
    // While the lattice is looked for in edges: γ of the exemplar itself, and the pictures of edges.
    constexpr std::uint64_t kEdges = 4 * sizeof(float) + 4 * sizeof(float);
    return pixels * (kTransforms + kEdges + kSums * static_cast<std::uint64_t>(channels)) + (4U << 20);
}

double latticeSecondsFor(Size exemplar) {
    return 8e-7 * static_cast<double>(exemplar.area());
}

} // namespace texloom
