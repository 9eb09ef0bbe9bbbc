#include "core/analysis/lattice_detector.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <tuple>

namespace texloom {

namespace {

constexpr double kAlpha = 1.12;       // of eq. 3.22
constexpr double kSignificant = 0.85; // share of the tile that an overlap must hold (section 3.3.1)
constexpr double kReach = 0.55;       // longest vector as a share of the exemplar
constexpr double kShortest = 3.5;     // shortest vector that is told from the maximum at 0, in pixels
constexpr double kLeastDip = 0.1;     // how much γ falls between two multiples, or they are one ridge
constexpr double kWorthTrying = 0.75; // of a lattice's goodness, for one with more points
constexpr std::size_t kMostPeaks = 56;
constexpr std::size_t kShortPeaks = 12;
constexpr std::size_t kShortlist = 32;
constexpr std::size_t kReported = 4;

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

/// Takes the quadratic surface nearest to a channel out of it.
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

/// Rates and fits lattices on one correlation.
class Detector {
public:
    Detector(const Correlation& gamma, const std::function<void()>& check)
        : m_gamma(gamma), m_check(check), m_size(gamma.size()), m_smooth(smoothed(gamma)) {}

    /// The best candidates, best first, and the confidence in the first.
    void rate(LatticeAnalysis& analysis) const;
    /// See fittedLattice().
    LatticeCandidate fittedNear(const Lattice& rough) const;

private:
    struct Peak {
        int x = 0, y = 0;
        float height = 0;
    };
    /// A lattice as it was fitted, and as a candidate: the two differ where the texture is free along a line.
    struct Rated {
        Lattice fitted;
        LatticeCandidate candidate;
    };

    static Correlation smoothed(const Correlation& gamma);
    /// Largest smoothed γ within `reach` of a point, and where.
    Peak summit(Vec2 near, int reach) const;
    std::vector<Peak> peaks() const;
    std::vector<Peak> dominantPeaks() const;
    bool inside(Vec2 p, int margin) const {
        return std::abs(p.x) + margin < m_size.width - 1 && std::abs(p.y) + margin < m_size.height - 1;
    }
    bool significant(const Lattice& lattice, Vec2 multiple) const;
    Lattice fitted(Lattice lattice, int rings) const;
    Lattice fitted(const Lattice& lattice) const;
    double roughGoodness(const Lattice& lattice) const;
    Rated rated(const Lattice& lattice) const;
    double meanBeside(const Lattice& lattice, Vec2 offset) const;
    double confidence(const Rated& rated) const;
    template <class Visit> void eachMultiple(const Lattice& lattice, int rings, Visit visit) const;
    int ringsOf(const Lattice& lattice) const;
    std::vector<Lattice> pairs() const;
    void addFiner(std::vector<Lattice>& best) const;

    const Correlation& m_gamma;
    const std::function<void()>& m_check;
    Size m_size;
    Correlation m_smooth;
};

Correlation Detector::smoothed(const Correlation& gamma) {
    Correlation smooth = gamma;
    const auto row = [&](int x, int y) {
        return gamma.at(x - 1, y) + 2 * gamma.at(x, y) + gamma.at(x + 1, y);
    };
    for (int y = 1 - gamma.top(); y < gamma.bottom(); ++y)
        for (int x = 1 - gamma.left(); x < gamma.right(); ++x)
            smooth.at(x, y) = (row(x, y - 1) + 2 * row(x, y) + row(x, y + 1)) / 16;
    return smooth;
}

Detector::Peak Detector::summit(Vec2 near, int reach) const {
    const int cx = static_cast<int>(std::lround(near.x)), cy = static_cast<int>(std::lround(near.y));
    Peak best{cx, cy, -2};
    for (int y = cy - reach; y <= cy + reach; ++y)
        for (int x = cx - reach; x <= cx + reach; ++x)
            if (m_smooth.contains(x, y) && m_smooth.at(x, y) > best.height)
                best = {x, y, m_smooth.at(x, y)};
    return best;
}

/// Local maxima of the half plane that are short enough for a vector.
std::vector<Detector::Peak> Detector::peaks() const {
    std::vector<Peak> found;
    const int right = static_cast<int>(m_size.width * kReach),
              bottom = static_cast<int>(m_size.height * kReach);
    for (int y = 0; y <= std::min(bottom, m_size.height - 3); ++y) {
        m_check();
        for (int x = -right; x <= right; ++x) {
            if ((y == 0 && x <= 0) || !inside({double(x), double(y)}, 1) || std::hypot(x, y) < kShortest)
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
    return found;
}

/// The peaks worth pairing: those far from any higher one (Lin, Wang & Yang 1997, through the source's
/// chapter 6), and the highest.
std::vector<Detector::Peak> Detector::dominantPeaks() const {
    std::vector<Peak> all = peaks();
    std::sort(all.begin(), all.end(), [](const Peak& a, const Peak& b) {
        return std::tuple(-a.height, a.y, a.x) < std::tuple(-b.height, b.y, b.x);
    });
    constexpr std::size_t kConsidered = 1500;
    all.resize(std::min(all.size(), kConsidered));
    std::vector<std::pair<double, std::size_t>> reach;
    for (std::size_t i = 0; i < all.size(); ++i) {
        double nearest = std::hypot(all[i].x, all[i].y);
        for (std::size_t j = 0; j < i; ++j) {
            nearest = std::min(nearest, std::hypot(all[i].x - all[j].x, all[i].y - all[j].y));
            nearest = std::min(nearest, std::hypot(all[i].x + all[j].x, all[i].y + all[j].y));
        }
        reach.emplace_back(-nearest, i);
    }
    std::sort(reach.begin(), reach.end());
    std::set<std::size_t> chosen;
    for (std::size_t i = 0; i < std::min(kMostPeaks / 2, all.size()); ++i)
        chosen.insert(i);
    std::vector<std::pair<double, std::size_t>> lengths;
    for (std::size_t i = 0; i < all.size() && all[i].height > 0.25F * all.front().height; ++i)
        lengths.emplace_back(std::hypot(all[i].x, all[i].y), i);
    std::sort(lengths.begin(), lengths.end());
    for (std::size_t i = 0; i < std::min(kShortPeaks, lengths.size()); ++i)
        chosen.insert(lengths[i].second);
    for (std::size_t i = 0; i < reach.size() && chosen.size() < kMostPeaks; ++i)
        chosen.insert(reach[i].second);
    std::vector<Peak> kept;
    for (const std::size_t i : chosen)
        kept.push_back(all[i]);
    return kept;
}

template <class Visit> void Detector::eachMultiple(const Lattice& lattice, int rings, Visit visit) const {
    for (int b = 0; b <= rings; ++b)
        for (int a = b == 0 ? 1 : -rings; a <= rings; ++a)
            if (const Vec2 p = lattice.at(a, b); inside(p, 2))
                visit(a, b, p);
}

int Detector::ringsOf(const Lattice& lattice) const {
    // Height of the parallelogram over each side: how many rows of the lattice fit in the reach.
    const double longest = std::hypot(m_size.width, m_size.height);
    const double height = lattice.area() / std::max(lattice.v1.length(), lattice.v2.length());
    return static_cast<int>(std::ceil(longest / std::max(1.0, height)));
}

bool Detector::significant(const Lattice& lattice, Vec2 multiple) const {
    const Size overlap{m_size.width - static_cast<int>(std::lround(std::abs(multiple.x))),
                       m_size.height - static_cast<int>(std::lround(std::abs(multiple.y)))};
    const Vec2 extent = lattice.extent();
    if (overlap.width >= extent.x + 1 && overlap.height >= extent.y + 1)
        return true;
    if (static_cast<double>(overlap.area()) < kSignificant * lattice.area())
        return false;
    return tileCoverage(lattice, overlap) >= kSignificant;
}

/// The offset of the top of the parabola through three values one apart, −0.5 to 0.5.
double parabolaTop(float before, float here, float after) {
    const double bend =
        static_cast<double>(before) - 2 * static_cast<double>(here) + static_cast<double>(after);
    return bend < 0 ? std::clamp(0.5 * static_cast<double>(before - after) / bend, -0.5, 0.5) : 0;
}

/// The lattice that comes nearest to the maxima of γ at its multiples up to `rings`, by least squares.
Lattice Detector::fitted(Lattice lattice, int rings) const {
    const int reach = std::clamp(static_cast<int>(0.2 * lattice.v1.length()), 1, 3);
    double aa = 0, ab = 0, bb = 0;
    Vec2 pa, pb;
    eachMultiple(lattice, rings, [&](int a, int b, Vec2 p) {
        const Peak top = summit(p, reach);
        if (top.height <= 0 || !inside({double(top.x), double(top.y)}, 1))
            return;
        const float here = m_smooth.at(top.x, top.y);
        if (m_smooth.at(top.x - 1, top.y) > here || m_smooth.at(top.x + 1, top.y) > here ||
            m_smooth.at(top.x, top.y - 1) > here || m_smooth.at(top.x, top.y + 1) > here)
            return;
        const Vec2 at{top.x + parabolaTop(m_smooth.at(top.x - 1, top.y), here, m_smooth.at(top.x + 1, top.y)),
                      top.y +
                          parabolaTop(m_smooth.at(top.x, top.y - 1), here, m_smooth.at(top.x, top.y + 1))};
        const double share = (1 - std::abs(at.x) / m_size.width) * (1 - std::abs(at.y) / m_size.height);
        const double weight = static_cast<double>(here) * share;
        aa += weight * a * a;
        ab += weight * a * b;
        bb += weight * b * b;
        pa = pa + weight * a * at;
        pb = pb + weight * b * at;
    });
    const double determinant = aa * bb - ab * ab;
    if (determinant <= 1e-9 * aa * bb)
        return lattice;
    return {(1 / determinant) * (bb * pa - ab * pb), (1 / determinant) * (aa * pb - ab * pa)};
}

/// Fitted from the nearest multiples to all, so that no maximum is taken for its neighbour.
Lattice Detector::fitted(const Lattice& lattice) const {
    Lattice now = lattice;
    const int most = ringsOf(lattice);
    for (int rings = 1;; rings = std::min(2 * rings, most)) {
        const Lattice next = fitted(now, rings).reduced();
        if (next.area() < 0.5 * lattice.area() || next.area() > 2 * lattice.area())
            return lattice;
        now = next;
        if (rings >= most)
            return fitted(now, most).reduced();
    }
}

/// Eq. 3.22 from the nearest multiples alone.
double Detector::roughGoodness(const Lattice& lattice) const {
    double sum = 0;
    int count = 0;
    eachMultiple(lattice, 3, [&](int, int, Vec2 p) {
        if (std::abs(p.x) < 0.8 * m_size.width && std::abs(p.y) < 0.8 * m_size.height) {
            sum += static_cast<double>(summit(p, 1).height);
            ++count;
        }
    });
    if (sum <= 0)
        return 0;
    const double all = std::max(1.0, 2.0 * static_cast<double>(m_size.area()) / lattice.area());
    return std::pow(sum / count, kAlpha) * std::pow(all, kAlpha - 1);
}

/// Mean of γ at the significant multiples, each moved by `offset` tiles.
double Detector::meanBeside(const Lattice& lattice, Vec2 offset) const {
    double sum = 0;
    int count = 0;
    constexpr int kEnough = 24;
    eachMultiple(lattice, std::min(kEnough, ringsOf(lattice)), [&](int a, int b, Vec2 p) {
        const Vec2 beside = lattice.at(a + offset.x, b + offset.y);
        if (!inside(beside, 2) || !significant(lattice, p))
            return;
        sum += static_cast<double>(summit(beside, 1).height);
        ++count;
    });
    return count > 0 ? sum / count : 0;
}

/// The lattice with its goodness. Where γ does not fall between multiples of one vector, that vector means
/// nothing: the texture is free along it, and as many multiples count as a square tile would have.
Detector::Rated Detector::rated(const Lattice& lattice) const {
    double sum = 0;
    int count = 0;
    eachMultiple(lattice, ringsOf(lattice), [&](int, int, Vec2 p) {
        if (significant(lattice, p)) {
            sum += static_cast<double>(summit(p, 1).height);
            ++count;
        }
    });
    Rated result{lattice, {lattice, 0, 0, count}};
    if (sum <= 0)
        return result;
    LatticeCandidate& candidate = result.candidate;
    candidate.correlation = sum / count;
    const double limit = (1 - kLeastDip) * candidate.correlation;
    // A vector that is a multiple of the true one has no dip at some of these.
    const auto isRidge = [&](Vec2 step) {
        return meanBeside(lattice, 0.5 * step) > limit && meanBeside(lattice, 0.37 * step) > limit &&
               meanBeside(lattice, 0.21 * step) > limit;
    };
    const bool free1 = isRidge({1, 0}), free2 = isRidge({0, 1});
    if (free1 && free2)
        return result;
    if (free1 || free2) {
        const Vec2 along = free1 ? lattice.v1 : lattice.v2, other = free1 ? lattice.v2 : lattice.v1;
        const Vec2 step = (1 / along.length()) * along;
        const Vec2 across = other - dot(other, step) * step;
        candidate.lattice = Lattice{step, across}.reduced();
        candidate.multiples = std::max(1, static_cast<int>(count * along.length() / across.length()));
    }
    candidate.goodness = std::pow(candidate.correlation, kAlpha) * std::pow(candidate.multiples, kAlpha - 1);
    return result;
}

/// How far γ at the multiples stands out from γ at all points between them, in height and against its
/// scatter: chance lattices, of which the best of very many is looked at, have few multiples.
double Detector::confidence(const Rated& rated) const {
    constexpr int kSteps = 4;
    constexpr double kStep = 1.0 / kSteps;
    double on = 0, off = 0, squares = 0;
    int count = 0, between = 0;
    const Lattice& lattice = rated.fitted;
    eachMultiple(lattice, ringsOf(lattice), [&](int a, int b, Vec2 p) {
        if (!significant(lattice, p))
            return;
        on += static_cast<double>(summit(p, 1).height);
        ++count;
        for (int i = 1; i < kSteps * kSteps; ++i) {
            const int right = i % kSteps, down = i / kSteps;
            const Vec2 beside = lattice.at(a + kStep * right, b + kStep * down);
            if (!inside(beside, 2))
                continue;
            const auto height = static_cast<double>(summit(beside, 1).height);
            off += height;
            squares += height * height;
            ++between;
        }
    });
    if (count == 0 || between == 0)
        return 0;
    on /= count;
    off /= between;
    const double contrast = std::max(0.0, (on - off) / (1 - std::min(0.99, off)));
    const double scatter = std::sqrt(std::max(1e-12, squares / between - off * off));
    const double times =
        contrast / 4 * std::max(0.0, (on - off) / scatter) * std::sqrt(rated.candidate.multiples);
    return contrast / (contrast + 0.1) * (1 - std::exp(-times * times));
}

std::vector<Lattice> Detector::pairs() const {
    const std::vector<Peak> chosen = dominantPeaks();
    std::set<std::tuple<int, int, int, int>> seen;
    std::vector<std::pair<double, Lattice>> rough;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        m_check();
        for (std::size_t j = 0; j < i; ++j) {
            const Lattice raw{{double(chosen[i].x), double(chosen[i].y)},
                              {double(chosen[j].x), double(chosen[j].y)}};
            if (raw.area() < 6)
                continue;
            const Lattice pair = raw.reduced();
            const auto round = [](double v) { return static_cast<int>(std::lround(v)); };
            if (std::min(pair.v1.length(), pair.v2.length()) < kShortest ||
                !seen.emplace(round(pair.v1.x), round(pair.v1.y), round(pair.v2.x), round(pair.v2.y)).second)
                continue;
            rough.emplace_back(-roughGoodness(pair), pair);
        }
    }
    std::stable_sort(rough.begin(), rough.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<Lattice> best;
    for (const auto& [minus, pair] : rough) {
        if (best.size() == kShortlist || minus >= 0)
            break;
        m_check();
        const Lattice lattice = fitted(pair);
        if (std::none_of(best.begin(), best.end(), [&](const Lattice& b) { return b.like(lattice, 1.5); }))
            best.push_back(lattice);
    }
    return best;
}

/// Adds the lattices with two or three times as many points where those fit as well: their vectors may not be
/// among the peaks.
void Detector::addFiner(std::vector<Lattice>& best) const {
    static const std::array<std::array<double, 3>, 7> kDivisions = {
        {{1, 0, 2}, {0, 1, 2}, {1, 1, 2}, {1, 0, 3}, {0, 1, 3}, {1, 1, 3}, {1, -1, 3}}};
    for (std::size_t i = 0; i < best.size() && best.size() < 2 * kShortlist; ++i) {
        m_check();
        const Lattice coarse = best[i];
        const double reached = roughGoodness(coarse);
        for (const auto& [a, b, parts] : kDivisions) {
            const Vec2 point = (1 / parts) * coarse.at(a, b);
            const Lattice raw = (a == 0 ? Lattice{coarse.v1, point} : Lattice{point, coarse.v2}).reduced();
            if (std::min(raw.v1.length(), raw.v2.length()) < kShortest ||
                roughGoodness(raw) < kWorthTrying * reached)
                continue;
            const Lattice finer = fitted(raw);
            if (std::none_of(best.begin(), best.end(),
                             [&](const Lattice& b2) { return b2.like(finer, 1.5); }))
                best.push_back(finer);
        }
    }
}

void Detector::rate(LatticeAnalysis& analysis) const {
    std::vector<Lattice> lattices = pairs();
    addFiner(lattices);
    std::vector<Rated> all;
    for (const Lattice& lattice : lattices) {
        m_check();
        Rated next = rated(lattice);
        const auto known = [&](const Rated& r) {
            return r.candidate.lattice.like(next.candidate.lattice, 1.5);
        };
        if (next.candidate.goodness > 0 && std::none_of(all.begin(), all.end(), known))
            all.push_back(next);
    }
    std::stable_sort(all.begin(), all.end(), [](const Rated& a, const Rated& b) {
        return a.candidate.goodness > b.candidate.goodness;
    });
    if (all.empty())
        return;
    analysis.confidence = confidence(all.front());
    // A lattice that is part of a better one, and no better where its points lie, is the last to be told of.
    std::vector<LatticeCandidate>&reported = analysis.candidates, parts;
    for (const Rated& next : all) {
        const auto says = [&](const LatticeCandidate& better) {
            return better.lattice.includes(next.candidate.lattice, 1.5) &&
                   next.candidate.correlation < 1.05 * better.correlation;
        };
        const bool part = std::any_of(reported.begin(), reported.end(), says);
        (part ? parts : reported).push_back(next.candidate);
    }
    reported.insert(reported.end(), parts.begin(), parts.end());
    reported.resize(std::min(reported.size(), kReported));
    std::stable_sort(
        reported.begin(), reported.end(),
        [](const LatticeCandidate& a, const LatticeCandidate& b) { return a.goodness > b.goodness; });
}

LatticeCandidate Detector::fittedNear(const Lattice& rough) const {
    LatticeCandidate candidate = rated(fitted(rough.reduced())).candidate;
    const Lattice near{candidate.lattice.nearest(rough.v1), candidate.lattice.nearest(rough.v2)};
    const bool same = std::abs(near.area() - candidate.lattice.area()) < 0.5 * candidate.lattice.area();
    candidate.lattice = same ? near : rough;
    return candidate;
}

} // namespace

LatticeCandidate fittedLattice(const Correlation& correlation, const Lattice& rough,
                               const std::function<void()>& check) {
    return Detector(correlation, check).fittedNear(rough);
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
    const Detector detector(analysis.correlation, check);
    detector.rate(analysis);
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
