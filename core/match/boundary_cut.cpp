#include "core/match/boundary_cut.h"

#include <algorithm>
#include <array>
#include <limits>

namespace texloom {

namespace {

constexpr double kUnreachable = std::numeric_limits<double>::infinity();

/// One side of the overlap as seen from the patch's border: `along` runs with the side from the top or left,
/// `across` goes inwards. A corner is where two sides meet; there, both paths pass (i, i) from the corner.
class Band {
public:
    enum class Side { Left, Top, Right, Bottom };

    Band(const PlaneView& error, Side side, int width) : m_length(error.width), m_width(width), m_side(side) {
        m_error.reserve(static_cast<std::size_t>(m_length) * static_cast<std::size_t>(width));
        for (int along = 0; along < m_length; ++along)
            for (int across = 0; across < width; ++across) {
                const auto [x, y] = pixel(along, across);
                m_error.push_back(static_cast<double>(error(x, y)));
            }
    }

    bool present() const { return m_width > 0; }
    int width() const { return m_width; }
    double error(int along, int across) const { return m_error[index(along, across)]; }

    /// The error at corner pixel i of the far end.
    double errorAtEnd(int i) const { return error(m_length - 1 - i, i); }

    struct Pixel {
        int x, y;
    };
    Pixel pixel(int along, int across) const {
        const int last = m_length - 1;
        switch (m_side) {
        case Side::Left:
            return {across, along};
        case Side::Top:
            return {along, across};
        case Side::Right:
            return {last - across, along};
        case Side::Bottom:
            break;
        }
        return {along, last - across};
    }

    /// Smallest cumulative errors of paths from the start (from corner pixel `corner`, or from anywhere on
    /// the first line if it is negative) to each pixel: the recursion of eq. 3 in the opposite direction.
    std::vector<double> forward(int corner) const {
        std::vector<double> sums(m_error.size(), kUnreachable);
        const int first = std::max(0, corner);
        for (int across = 0; across < m_width; ++across)
            if (corner < 0 || across == corner)
                sums[index(first, across)] = error(first, across);
        for (int along = first + 1; along < m_length; ++along)
            addLine(sums, along, along - 1);
        return sums;
    }

    /// The same from anywhere on the last line backwards: the source's own E_v and E_h.
    std::vector<double> backward() const {
        std::vector<double> sums = m_error;
        for (int along = m_length - 2; along >= 0; --along)
            addLine(sums, along, along + 1);
        return sums;
    }

    /// The smallest sum of a path that ends in corner pixel `corner`, or anywhere on the last line if it is
    /// negative.
    double ending(const std::vector<double>& sums, int corner) const {
        if (corner >= 0)
            return sums[index(m_length - 1 - corner, corner)];
        const auto last = sums.end() - m_width;
        return *std::min_element(last, sums.end());
    }

    /// Smallest errors between every corner pixel at the start and every one at the end. @param starts, ends
    /// number of corner pixels, or 0 where there is no corner and the path may begin or end anywhere.
    std::vector<std::vector<double>> costs(int starts, int ends) const {
        std::vector<std::vector<double>> table;
        if (!present())
            return {{0}};
        if (starts > 0 && ends == 0) {
            const std::vector<double> sums = backward();
            for (int i = 0; i < starts; ++i)
                table.push_back({sums[index(i, i)]});
            return table;
        }
        for (int i = starts > 0 ? 0 : -1; i < starts; ++i) {
            const std::vector<double> sums = forward(i);
            std::vector<double>& row = table.emplace_back();
            for (int j = ends > 0 ? 0 : -1; j < ends; ++j)
                row.push_back(ending(sums, j));
        }
        return table;
    }

    /// Marks the pixels between the border and the best path from corner pixel `start` to `end` (negative:
    /// free).
    void keepBeyond(int start, int end, BoundaryCut& cut) const {
        if (!present())
            return;
        const std::vector<double> sums = forward(start);
        int along = m_length - 1 - std::max(0, end);
        std::size_t at =
            end >= 0
                ? index(along, end)
                : static_cast<std::size_t>(std::min_element(sums.end() - m_width, sums.end()) - sums.begin());
        for (; along >= std::max(0, start); --along) {
            const int path = static_cast<int>(at) % m_width;
            for (int across = 0; across < path; ++across)
                keep(along, across, cut);
            if (along > std::max(0, start))
                at = bestOnLine(sums, along - 1, path);
        }
    }

private:
    std::size_t index(int along, int across) const {
        return static_cast<std::size_t>(along) * static_cast<std::size_t>(m_width) +
               static_cast<std::size_t>(across);
    }

    /// The sums on one line from those on the line before: the smallest of up to three plus the pixel's own
    /// error. Written so that it vectorises.
    void addLine(std::vector<double>& sums, int along, int from) const {
        const double* error = &m_error[index(along, 0)];
        const double* before = &sums[index(from, 0)];
        double* to = &sums[index(along, 0)];
        const int last = m_width - 1;
        if (last == 0) {
            to[0] = error[0] + before[0];
            return;
        }
        to[0] = error[0] + std::min(before[0], before[1]);
        for (int across = 1; across < last; ++across)
            to[across] =
                error[across] + std::min(std::min(before[across - 1], before[across]), before[across + 1]);
        to[last] = error[last] + std::min(before[last - 1], before[last]);
    }

    /// Of the up to three pixels on a line that a path may come from, the one with the smallest sum.
    std::size_t bestOnLine(const std::vector<double>& sums, int line, int across) const {
        const std::size_t straight = index(line, across);
        std::size_t best = straight;
        if (across > 0 && sums[straight - 1] < sums[best])
            best = straight - 1;
        if (across + 1 < m_width && sums[straight + 1] < sums[best])
            best = straight + 1;
        return best;
    }

    void keep(int along, int across, BoundaryCut& cut) const {
        const auto [x, y] = pixel(along, across);
        cut.keep[static_cast<std::size_t>(y) * static_cast<std::size_t>(m_length) +
                 static_cast<std::size_t>(x)] = 1;
    }

    int m_length;
    int m_width;
    Side m_side;
    std::vector<double> m_error;
};

/// The pixels (i, i) at which the paths of two sides meet, one choice for each corner of the patch.
struct Corners {
    int topLeft = -1, topRight = -1, bottomRight = -1, bottomLeft = -1;
};

/// Number of corner pixels of two sides; 0 if they do not meet.
int cornerSize(const Band& a, const Band& b) {
    return std::min(a.width(), b.width());
}

/// For each end of a side, the smallest sum so far and the start that gave it.
struct Step {
    std::vector<double> sums;
    std::vector<int> from;
};

/// Goes along one side. @param costs of the side by start and end, or by end and start if `transposed`.
/// @param shared error at each start, which the side before has counted already.
Step advance(const std::vector<double>& before, const std::vector<std::vector<double>>& costs,
             bool transposed, const std::vector<double>& shared) {
    const std::size_t count = transposed ? costs.size() : costs.front().size();
    Step step{std::vector<double>(count, kUnreachable), std::vector<int>(count, 0)};
    for (std::size_t to = 0; to < count; ++to)
        for (std::size_t from = 0; from < before.size(); ++from) {
            const double sum = before[from] + (transposed ? costs[to][from] : costs[from][to]) - shared[from];
            if (sum < step.sums[to]) {
                step.sums[to] = sum;
                step.from[to] = static_cast<int>(from);
            }
        }
    return step;
}

/// Joins the four sides of the patch into the cheapest cut.
class Ring {
public:
    Ring(const PlaneView& error, const Overlap& overlap)
        : m_left(error, Band::Side::Left, overlap.left), m_top(error, Band::Side::Top, overlap.top),
          m_right(error, Band::Side::Right, overlap.right),
          m_bottom(error, Band::Side::Bottom, overlap.bottom) {}

    BoundaryCut solve(int patch) {
        const int tl = cornerSize(m_left, m_top), tr = cornerSize(m_top, m_right);
        const int br = cornerSize(m_right, m_bottom), bl = cornerSize(m_bottom, m_left);
        const auto leftCosts = m_left.costs(tl, bl), topCosts = m_top.costs(tl, tr);
        const auto rightCosts = m_right.costs(tr, br), bottomCosts = m_bottom.costs(bl, br);
        const auto sharedTl = cornerErrors(m_top, tl, false), sharedTr = cornerErrors(m_top, tr, true);
        const auto sharedBr = cornerErrors(m_bottom, br, true), sharedBl = cornerErrors(m_bottom, bl, false);

        double best = kUnreachable;
        Corners corners;
        for (std::size_t start = 0; start < sharedTl.size(); ++start) {
            std::vector<double> only(sharedTl.size(), kUnreachable);
            only[start] = 0;
            const Step right = advance(only, topCosts, false, sharedTl);
            const Step lower = advance(right.sums, rightCosts, false, sharedTr);
            const Step left = advance(lower.sums, bottomCosts, true, sharedBr);
            const Step closed = advance(left.sums, leftCosts, true, sharedBl);
            if (closed.sums[start] >= best)
                continue;
            best = closed.sums[start];
            const int atBl = closed.from[start], atBr = left.from[static_cast<std::size_t>(atBl)];
            const int atTr = lower.from[static_cast<std::size_t>(atBr)];
            corners = {tl ? static_cast<int>(start) : -1, tr ? atTr : -1, br ? atBr : -1, bl ? atBl : -1};
        }
        return trace(patch, best, corners);
    }

private:
    /// Errors at a corner's pixels, which the paths of both its sides count; {0} where there is no corner.
    static std::vector<double> cornerErrors(const Band& band, int count, bool atEnd) {
        std::vector<double> errors;
        for (int i = 0; i < count; ++i)
            errors.push_back(atEnd ? band.errorAtEnd(i) : band.error(i, i));
        return errors.empty() ? std::vector<double>{0} : errors;
    }

    BoundaryCut trace(int patch, double cost, const Corners& corners) const {
        BoundaryCut cut{
            cost, patch,
            std::vector<std::uint8_t>(static_cast<std::size_t>(patch) * static_cast<std::size_t>(patch), 0)};
        m_left.keepBeyond(corners.topLeft, corners.bottomLeft, cut);
        m_top.keepBeyond(corners.topLeft, corners.topRight, cut);
        m_right.keepBeyond(corners.topRight, corners.bottomRight, cut);
        m_bottom.keepBeyond(corners.bottomLeft, corners.bottomRight, cut);
        for (const auto& [size, fromRight, fromBottom] :
             {std::array{corners.topLeft, 0, 0}, std::array{corners.topRight, 1, 0},
              std::array{corners.bottomRight, 1, 1}, std::array{corners.bottomLeft, 0, 1}})
            for (int y = 0; y < size; ++y)
                for (int x = 0; x < size; ++x) {
                    const int column = fromRight ? patch - 1 - x : x;
                    const int row = fromBottom ? patch - 1 - y : y;
                    cut.keep[static_cast<std::size_t>(row) * static_cast<std::size_t>(patch) +
                             static_cast<std::size_t>(column)] = 1;
                }
        return cut;
    }

    Band m_left, m_top, m_right, m_bottom;
};

} // namespace

BoundaryCut minimumErrorCut(const PlaneView& error, const Overlap& overlap) {
    return Ring(error, overlap).solve(error.width);
}

} // namespace texloom
