#include "core/match/seam_path.h"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace texloom {

namespace {

/// What it costs to part the neighbours in the overlap.
class SeamCosts {
public:
    SeamCosts(const SeamOverlap& overlap, float delta)
        : m_overlap(overlap), m_delta(delta), m_across(count()), m_along(count()) {
        std::vector<float> apart(count());
        for (int y = 0; y < overlap.along; ++y)
            for (int x = 0; x < overlap.across; ++x)
                apart[index(y, x)] =
                    distance(overlap.first, overlap.at(y, x), overlap.second, overlap.at(y, x));
        for (int y = 0; y < overlap.along; ++y) {
            const int next = (y + 1) % overlap.along;
            for (int x = 0; x < overlap.across; ++x) {
                m_along[index(y, x)] = (apart[index(y, x)] + apart[index(next, x)]) / steps(y, x, next, x);
                if (x > 0)
                    m_across[index(y, x)] =
                        (apart[index(y, x - 1)] + apart[index(y, x)]) / steps(y, x - 1, y, x);
            }
        }
    }

    /// Of the pair (x − 1, x) in step y.
    float across(int y, int x) const { return m_across[index(y, x)]; }
    /// Of the pair of pixel x in step y and in the step after it.
    float along(int y, int x) const { return m_along[index(y, x)]; }

private:
    std::size_t count() const {
        return static_cast<std::size_t>(m_overlap.along) * static_cast<std::size_t>(m_overlap.across);
    }
    std::size_t index(int y, int x) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(m_overlap.across) +
               static_cast<std::size_t>(x);
    }
    float distance(const std::vector<float>& a, std::size_t i, const std::vector<float>& b,
                   std::size_t j) const {
        float sum = 0;
        for (int c = 0; c < m_overlap.channels; ++c, ++i, ++j)
            sum += (a[i] - b[j]) * (a[i] - b[j]);
        return sum;
    }
    float steps(int y, int x, int toY, int toX) const {
        const std::size_t a = m_overlap.at(y, x), b = m_overlap.at(toY, toX);
        return distance(m_overlap.first, a, m_overlap.first, b) +
               distance(m_overlap.second, a, m_overlap.second, b) + m_delta;
    }

    const SeamOverlap& m_overlap;
    float m_delta;
    std::vector<float> m_across, m_along;
};

/// Dynamic programming over the steps from `begin` on, around the end. From one step to the next a path may
/// go any way aside, which parts the pairs that it passes.
class SeamSearch {
public:
    SeamSearch(const SeamCosts& costs, int along, int across)
        : m_costs(costs), m_steps(along), m_across(across),
          m_from(static_cast<std::size_t>(along) * static_cast<std::size_t>(across)) {}

    /// @param fixed the pixel at `begin`, to which the path comes back, or 0 for any and an open path.
    std::vector<int> best(int begin, int fixed) {
        constexpr float kNever = std::numeric_limits<float>::infinity();
        m_cost.assign(static_cast<std::size_t>(m_across), kNever);
        for (int x = 1; x < m_across; ++x)
            if (fixed == 0 || x == fixed)
                m_cost[static_cast<std::size_t>(x)] = m_costs.across(begin, x);
        for (int i = 1; i < m_steps; ++i) {
            spread((begin + i - 1) % m_steps, i);
            for (int x = 1; x < m_across; ++x)
                m_cost[static_cast<std::size_t>(x)] += m_costs.across((begin + i) % m_steps, x);
        }
        int last = fixed;
        if (fixed != 0) {
            spread((begin + m_steps - 1) % m_steps, 0);
            last = m_from[static_cast<std::size_t>(fixed)];
        } else {
            last = static_cast<int>(std::min_element(m_cost.begin() + 1, m_cost.end()) - m_cost.begin());
        }
        std::vector<int> path(static_cast<std::size_t>(m_steps));
        for (int i = m_steps - 1; i >= 0; --i) {
            path[static_cast<std::size_t>((begin + i) % m_steps)] = last;
            if (i > 0)
                last = from(i, last);
        }
        return path;
    }

private:
    int& from(int i, int x) {
        return m_from[static_cast<std::size_t>(i) * static_cast<std::size_t>(m_across) +
                      static_cast<std::size_t>(x)];
    }

    /// The least cost of being at each pixel in the step after `step`, before that step's own; noted as the
    /// way to the `i`-th step of the path.
    void spread(int step, int i) {
        for (int x = 1; x < m_across; ++x)
            from(i, x) = x;
        for (int x = 2; x < m_across; ++x)
            relax(i, x - 1, x, m_costs.along(step, x - 1));
        for (int x = m_across - 2; x >= 1; --x)
            relax(i, x + 1, x, m_costs.along(step, x));
    }

    void relax(int i, int near, int x, float cost) {
        const float other = m_cost[static_cast<std::size_t>(near)] + cost;
        if (other < m_cost[static_cast<std::size_t>(x)]) {
            m_cost[static_cast<std::size_t>(x)] = other;
            from(i, x) = from(i, near);
        }
    }

    const SeamCosts& m_costs;
    int m_steps, m_across;
    std::vector<int> m_from;
    std::vector<float> m_cost;
};

} // namespace

std::vector<int> seamPath(const SeamOverlap& overlap, float delta, bool closes) {
    if (overlap.across < 3)
        return std::vector<int>(static_cast<std::size_t>(overlap.along), 1);
    const SeamCosts costs(overlap, delta);
    SeamSearch search(costs, overlap.along, overlap.across);
    std::vector<int> path = search.best(0, 0);
    if (closes) {
        // Half-way around, the open path knows least of its ends: a closed one may well go through there.
        const int middle = overlap.along / 2;
        path = search.best(middle, path[static_cast<std::size_t>(middle)]);
    }
    return path;
}

double seamCost(const SeamOverlap& overlap, float delta, bool closes, const std::vector<int>& path) {
    const SeamCosts costs(overlap, delta);
    double sum = 0;
    for (int y = 0; y < overlap.along; ++y) {
        const int here = path[static_cast<std::size_t>(y)];
        sum += static_cast<double>(costs.across(y, here));
        if (y + 1 == overlap.along && !closes)
            break;
        const int next = path[static_cast<std::size_t>((y + 1) % overlap.along)];
        for (int x = std::min(here, next); x < std::max(here, next); ++x)
            sum += static_cast<double>(costs.along(y, x));
    }
    return sum;
}

} // namespace texloom
