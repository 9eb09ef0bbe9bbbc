#include "core/analysis/lattice_rows.h"

#include "core/analysis/lattice_fit.h"
#include "core/analysis/lattice_multiples.h"
#include "core/analysis/lattice_rating.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace texloom {

namespace {

/// Displacements by more than this share of the exemplar compare too little of it.
constexpr double kFarthest = 0.8;
/// At displacements along a row below this share of those, γ may be high for other reasons too.
constexpr double kNearOrigin = 0.25;

/// The share of an exemplar in which two displaced copies overlap.
double overlapShare(Size exemplar, int dx, int dy) {
    return (1 - std::abs(dx) / double(exemplar.width)) * (1 - std::abs(dy) / double(exemplar.height));
}

/// Visits the displacements of one half plane up to a share of the exemplar.
template <class Visit> void eachDisplacement(const CorrelationPeaks& peaks, double reach, Visit visit) {
    const int right = std::min(static_cast<int>(peaks.size().width * reach), peaks.size().width - 2);
    const int bottom = std::min(static_cast<int>(peaks.size().height * reach), peaks.size().height - 2);
    for (int y = 0; y <= bottom; ++y) {
        peaks.check();
        for (int x = y == 0 ? 1 : -right; x <= right; ++x)
            visit(x, y);
    }
}

/// Means of γ over lines, by their distance from the origin in pixels.
class Profile {
public:
    /// @param normal unit vector perpendicular to the lines. @param reach share of the exemplar. @param keep
    /// selects the displacements to use.
    template <class Keep> Profile(const CorrelationPeaks& peaks, Vec2 normal, double reach, Keep keep) {
        const Size size = peaks.size();
        const auto length = static_cast<std::size_t>(
            reach * (std::abs(normal.x) * size.width + std::abs(normal.y) * size.height) + 3);
        m_means.assign(length, 0.0);
        std::vector<double> weights(length, 0.0);
        eachDisplacement(peaks, reach, [&](int x, int y) {
            if (!keep(x, y))
                return;
            const double distance = std::abs(normal.x * x + normal.y * y);
            const auto line = static_cast<std::size_t>(distance);
            const double weight = overlapShare(size, x, y), next = distance - static_cast<double>(line);
            const auto gamma = static_cast<double>(peaks.smooth().at(x, y));
            m_means[line] += weight * (1 - next) * gamma;
            weights[line] += weight * (1 - next);
            m_means[line + 1] += weight * next * gamma;
            weights[line + 1] += weight * next;
        });
        // Lines through the corners are too short to tell anything.
        constexpr double kShort = 0.1;
        const double least = kShort * *std::max_element(weights.begin(), weights.end());
        std::size_t end = 0;
        for (; end < length && weights[end] > least; ++end)
            m_means[end] /= weights[end];
        m_means.resize(end);
    }

    Profile(const CorrelationPeaks& peaks, Vec2 normal, double reach)
        : Profile(peaks, normal, reach, [](int, int) { return true; }) {}

    int length() const { return static_cast<int>(m_means.size()); }
    double operator[](int line) const { return m_means[static_cast<std::size_t>(line)]; }
    double at(double distance) const {
        const int line = std::clamp(static_cast<int>(distance), 0, length() - 2);
        return (*this)[line] + (distance - line) * ((*this)[line + 1] - (*this)[line]);
    }
    bool peakAt(int line) const {
        return line > 0 && line + 1 < length() && (*this)[line] > 0 && (*this)[line] >= (*this)[line - 1] &&
               (*this)[line] >= (*this)[line + 1];
    }

    /// How much the means differ from line to line, leaving out those next to the origin.
    double variance() const {
        constexpr int kMiddle = 4;
        double sum = 0, squares = 0;
        for (int line = kMiddle; line < length(); ++line) {
            sum += (*this)[line];
            squares += (*this)[line] * (*this)[line];
        }
        const int count = std::max(1, length() - kMiddle);
        return squares / count - sum / count * sum / count;
    }

private:
    std::vector<double> m_means;
};

Vec2 unit(double angle) {
    return {std::cos(angle), std::sin(angle)};
}

/// The direction in which γ changes most, by its gradients.
double steepestAngle(const CorrelationPeaks& peaks) {
    constexpr int kMiddle = 8; // here γ falls equally in all directions
    const Correlation& gamma = peaks.smooth();
    double xx = 0, xy = 0, yy = 0;
    eachDisplacement(peaks, kLongestVector, [&](int x, int y) {
        if (x * x + y * y < kMiddle * kMiddle)
            return;
        const auto gx = static_cast<double>(gamma.at(x + 1, y) - gamma.at(x - 1, y));
        const auto gy = static_cast<double>(gamma.at(x, y + 1) - gamma.at(x, y - 1));
        const double weight = overlapShare(peaks.size(), x, y);
        xx += weight * gx * gx;
        xy += weight * gx * gy;
        yy += weight * gy * gy;
    });
    return 0.5 * std::atan2(2 * xy, xx - yy);
}

/// The angle near either of two at which the means differ most from line to line: gradients are too coarse
/// for lines as long as the exemplar.
double sharpestAngle(const CorrelationPeaks& peaks, double angle, double other) {
    // A pseudo-random subset of very many displacements still covers the lines of any direction.
    constexpr double kMany = 400'000;
    const auto all = static_cast<double>(peaks.size().area()) * 2 * kFarthest * kFarthest;
    const auto limit = static_cast<std::uint32_t>(std::min(1.0, kMany / all) * 0xffffffff);
    const auto some = [limit](int x, int y) {
        const std::uint32_t mixed =
            (static_cast<std::uint32_t>(x) * 0x9e3779b1U + static_cast<std::uint32_t>(y)) * 0x85ebca77U;
        return (mixed ^ (mixed >> 15U)) * 0xc2b2ae3dU <= limit;
    };
    const auto variance = [&](double at) { return Profile(peaks, unit(at), kFarthest, some).variance(); };
    double best = variance(angle);
    if (const double instead = variance(other); instead > best) {
        best = instead;
        angle = other;
    }
    const double finest = 0.25 / peaks.size().longerSide();
    for (double step = 0.02; step > finest; step /= 2) {
        const double more = variance(angle + step), less = variance(angle - step);
        if (std::max(more, less) <= best)
            continue;
        best = std::max(more, less);
        angle += more > less ? step : -step;
        step *= 2; // continue in this direction
    }
    return angle;
}

/// The distance near `rough` whose multiples fit the profile's maxima best, by least squares.
double fittedDistance(const Profile& profile, double rough) {
    double distance = rough;
    for (int most = 2; most <= 32; most *= 2) {
        double above = 0, below = 0;
        for (int k = 1; k <= most && k * distance + 1 < profile.length(); ++k) {
            const int middle = static_cast<int>(std::lround(k * distance));
            const int reach = std::clamp(static_cast<int>(0.2 * distance), 1, 3);
            int top = std::max(1, middle - reach);
            for (int line = top; line <= std::min(middle + reach, profile.length() - 1); ++line)
                if (profile[line] > profile[top])
                    top = line;
            if (!profile.peakAt(top))
                continue;
            const double at = top + parabolaTop(profile[top - 1], profile[top], profile[top + 1]);
            above += profile[top] * k * at;
            below += profile[top] * k * k;
        }
        if (below > 0)
            distance = above / below;
    }
    return distance;
}

/// What the profile says about rows at a given distance.
struct Rise {
    double distance = 0;
    double mean = 0;    ///< of the profile at the multiples
    double height = 0;  ///< mean rise from halfway to each multiple
    double scatter = 0; ///< standard deviation of these
    int count = 0;
};

Rise riseAt(const Profile& profile, double distance, double extent) {
    constexpr double kWhole = 0.85; // of the last row, as for tiles
    Rise rise{distance};
    double squares = 0;
    for (int k = 1; k * distance + 2 < profile.length() && (k + kWhole) * distance <= extent; ++k) {
        const double here = std::max(
            {profile.at(k * distance), profile.at(k * distance - 0.7), profile.at(k * distance + 0.7)});
        const double step = here - profile.at((k - 0.5) * distance);
        rise.mean += here;
        rise.height += step;
        squares += step * step;
        ++rise.count;
    }
    if (rise.count == 0)
        return rise;
    rise.mean /= rise.count;
    rise.height /= rise.count;
    rise.scatter = std::sqrt(std::max(0.0, squares / rise.count - rise.height * rise.height));
    return rise;
}

/// γ at the displacement nearest to a point in range.
double nearestTo(const CorrelationPeaks& peaks, Vec2 point) {
    const auto whole = [](double v) { return static_cast<int>(std::floor(v + 0.5)); };
    return static_cast<double>(peaks.smooth().at(whole(point.x), whole(point.y)));
}

/// γ along one row.
struct Row {
    double mean = 0;
    double uncertainty = 0; ///< of the mean, from the means of parts of the row
};

/// @param from a point of the row. @param near share of the reach around that point to leave out.
Row rowThrough(const CorrelationPeaks& peaks, Vec2 from, Vec2 along, double near) {
    constexpr std::size_t kParts = 8;
    const double reach = kFarthest * std::min(peaks.size().width / std::max(1e-9, std::abs(along.x)),
                                              peaks.size().height / std::max(1e-9, std::abs(along.y)));
    std::array<double, kParts> sums{};
    std::array<int, kParts> counts{};
    for (double at = -reach; at < reach; ++at) {
        const Vec2 point = from + at * along;
        if (std::abs(at) < near * reach || !peaks.inside(point, 1))
            continue;
        const auto part = static_cast<std::size_t>((at + reach) / (2 * reach) * kParts);
        sums[std::min(part, kParts - 1)] += nearestTo(peaks, point);
        ++counts[std::min(part, kParts - 1)];
    }
    double mean = 0, squares = 0;
    int parts = 0;
    for (std::size_t i = 0; i < kParts; ++i)
        if (counts[i] > 0) {
            const double own = sums[i] / counts[i];
            mean += own;
            squares += own * own;
            ++parts;
        }
    if (parts < 2)
        return {};
    mean /= parts;
    const double variance = std::max(0.0, squares / parts - mean * mean) * parts / (parts - 1);
    return {mean, std::sqrt(variance / parts)};
}

/// The confidence that the rows repeat. @param tried number of distances of which this is the best.
double confidenceInRows(const CorrelationPeaks& peaks, Vec2 normal, const Rise& rise, int tried) {
    constexpr double kVisible = 0.02, kUnlikely = 0.5, kSure = 20;
    const Vec2 along{-normal.y, normal.x};
    const double own = rowThrough(peaks, {}, along, kNearOrigin).mean;
    if (rise.count < 2 || rise.height <= 0 || own <= 0)
        return 0;
    const double unlike =
        std::max(rise.scatter / rise.height, std::abs(rise.mean - own) / std::max(rise.mean, own));
    const double chance = std::min(1.0, tried * std::pow(unlike, rise.count - 1) / kUnlikely);
    const double uncertainty = rowThrough(peaks, rise.distance * normal, along, 0).uncertainty;
    const double times = rise.height / std::max(1e-9, kSure * uncertainty);
    return rise.height / (rise.height + kVisible) * (1 - chance) *
           (1 - std::exp(-times * times * (rise.count - 1)));
}

/// The rise with the best goodness, and the number of distances tried.
std::pair<Rise, int> bestRise(const Profile& profile, double extent, double alpha) {
    Rise best;
    double goodness = 0;
    int tried = 0;
    for (int line = static_cast<int>(std::ceil(kShortestVector)); line < kLongestVector * extent; ++line) {
        if (!profile.peakAt(line))
            continue;
        const Rise rise = riseAt(profile, fittedDistance(profile, line), extent);
        if (rise.count == 0 || rise.mean <= 0)
            continue;
        ++tried;
        const double own = goodnessOf(rise.mean, extent * extent / (rise.distance * rise.distance), alpha);
        if (own > goodness) {
            goodness = own;
            best = rise;
        }
    }
    return {best, tried};
}

/// The direction along which γ stays highest, as a unit vector: that of rows that need not repeat.
Vec2 straightestDirection(const CorrelationPeaks& peaks) {
    const auto score = [&](Vec2 along) {
        const Row row = rowThrough(peaks, {}, along, kNearOrigin);
        return row.mean - 2 * row.uncertainty;
    };
    const double half = std::acos(-1.0);
    const int steps = static_cast<int>(std::ceil(half * peaks.size().longerSide()));
    Vec2 best{1, 0};
    double highest = score(best);
    for (int i = 1; i < steps; ++i) {
        peaks.check();
        const Vec2 along = unit(half * i / steps);
        if (const double own = score(along); own > highest) {
            highest = own;
            best = along;
        }
    }
    // A slope of a pixel or two is more likely chance than intent.
    constexpr double kHardly = 3, kAlmost = 0.9;
    for (const Vec2 axis : {Vec2{1, 0}, Vec2{0, 1}})
        if (std::abs(cross(axis, best)) * peaks.size().longerSide() < kHardly &&
            score(axis) > kAlmost * highest)
            return axis;
    return best;
}

/// The share of the line through the origin on which γ stays above half its mean: all of it where rows run
/// through the whole exemplar, less where it is high by chance.
double steadiness(const CorrelationPeaks& peaks, Vec2 along, double mean) {
    int steady = 0, all = 0;
    for (double at = 1; peaks.inside((at / kFarthest) * along, 1); ++at, ++all)
        steady += nearestTo(peaks, at * along) >= 0.5 * mean ? 1 : 0;
    return all == 0 ? 0 : static_cast<double>(steady) / all;
}

} // namespace

Lattice fittedRows(const CorrelationPeaks& peaks, const Lattice& rough) {
    const bool first = rough.v1.length() < rough.v2.length();
    const Vec2 step = first ? rough.v1 : rough.v2, other = first ? rough.v2 : rough.v1;
    const Vec2 normal = (1 / step.length()) * Vec2{-step.y, step.x};
    const double across = dot(other, normal);
    const Profile profile(peaks, normal, kFarthest);
    if (std::abs(across) < kShortestVector || profile.length() < 3)
        return rough;
    const double change = fittedDistance(profile, std::abs(across)) / std::abs(across);
    const Vec2 moved = other + (across * (change - 1)) * normal;
    return first ? Lattice{step, moved} : Lattice{moved, step};
}

std::optional<Rows> findOrderedRows(const CorrelationPeaks& peaks) {
    constexpr double kMiddle = 0.04, kNearest = 0.5, kFarthestApart = 0.65;
    const Vec2 along = straightestDirection(peaks), normal{-along.y, along.x};
    const double extent = std::abs(normal.x) * peaks.size().width + std::abs(normal.y) * peaks.size().height;
    const Profile profile(peaks, normal, kFarthest);
    const auto at = [&](double share) {
        return std::min(static_cast<int>(share * extent) + 1, profile.length() - 1);
    };
    const Row own = rowThrough(peaks, {}, along, kNearOrigin);
    if (own.mean <= 0 || profile.length() < 3)
        return {};
    double other = 0; // the highest line that is not the row itself
    for (int line = at(kMiddle); line < profile.length(); ++line)
        other = std::max(other, profile[line]);
    int apart = at(kNearest);
    for (int line = apart; line <= at(kFarthestApart); ++line)
        if (profile[line] > profile[apart])
            apart = line;
    constexpr double kVisible = 0.02, kSure = 8, kUnlike = 0.05, kWavering = 0.04;
    const double times = own.mean / std::max(1e-9, kSure * own.uncertainty);
    const double ahead = std::max(0.0, 1 - other / own.mean) / kUnlike;
    const double wavers = (1 - steadiness(peaks, along, own.mean)) / kWavering;
    Rows rows{{}, 0, along, double(apart)};
    rows.confidence = own.mean / (own.mean + kVisible) * (1 - std::exp(-times * times)) * ahead * ahead /
                      (1 + ahead * ahead) * std::exp(-wavers * wavers);
    rows.candidate.lattice = Lattice{along, rows.distance * normal}.reduced();
    rows.candidate.correlation = own.mean;
    rows.candidate.multiples = 1;
    rows.candidate.goodness = goodnessOf(own.mean, 1, peaks.criteria().alpha);
    return rows;
}

std::optional<Rows> findRows(const CorrelationPeaks& peaks) {
    const Vec2 straight = straightestDirection(peaks);
    const double angle = sharpestAngle(peaks, steepestAngle(peaks), std::atan2(straight.x, -straight.y));
    const Vec2 normal = unit(angle), along{-normal.y, normal.x};
    const double extent = std::abs(normal.x) * peaks.size().width + std::abs(normal.y) * peaks.size().height;
    const Profile profile(peaks, normal, kFarthest);
    const auto [rise, tried] = bestRise(profile, extent, peaks.criteria().alpha);
    if (tried == 0)
        return {};
    Rows rows{{}, confidenceInRows(peaks, normal, rise, tried), along, rise.distance};
    // γ along the rows is sampled as at the points of other lattices.
    constexpr double kApart = 4;
    rows.candidate = rated(peaks, {kApart * along, rise.distance * normal});
    rows.candidate.multiples =
        std::max(1, static_cast<int>(rows.candidate.multiples * kApart / rise.distance));
    rows.candidate.goodness =
        goodnessOf(rows.candidate.correlation, rows.candidate.multiples, peaks.criteria().alpha);
    rows.candidate.lattice = Lattice{along, rise.distance * normal}.reduced();
    return rows;
}

} // namespace texloom
