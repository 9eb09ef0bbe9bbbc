#include "core/job/random.h"
#include "core/math/grid_flow.h"

#include <gtest/gtest.h>
#include <lemon/preflow.h>
#include <lemon/smart_graph.h>

#include <vector>

namespace texloom::test {
namespace {

/// A grid with random capacities, as GridFlow and as LEMON's graph.
class Grid {
public:
    Grid(int width, int height, std::uint64_t seed, int largest)
        : m_flow(static_cast<std::size_t>(width * height)), m_capacity(m_graph), m_random(seed),
          m_largest(largest) {
        m_first = m_graph.addNode();
        m_second = m_graph.addNode();
        for (int i = 0; i < width * height; ++i) {
            m_flow.add();
            m_nodes.push_back(m_graph.addNode());
        }
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const int node = y * width + x;
                if (x + 1 < width)
                    link(node, GridFlow::Right, node + 1);
                if (y + 1 < height)
                    link(node, GridFlow::Down, node + width);
                tie(node, draw(), draw());
            }
    }

    GridFlow& flow() { return m_flow; }
    std::int64_t oracle() {
        lemon::Preflow<lemon::SmartDigraph, lemon::SmartDigraph::ArcMap<std::int64_t>> preflow(
            m_graph, m_capacity, m_first, m_second);
        preflow.runMinCut();
        return preflow.flowValue();
    }
    /// What the cut that GridFlow tells of costs.
    std::int64_t costOfCut() {
        std::int64_t sum = 0;
        const auto first = [&](lemon::SmartDigraph::Node node) {
            if (node == m_first || node == m_second)
                return node == m_first;
            return m_flow.first(lemon::SmartDigraph::id(node) - 2);
        };
        for (lemon::SmartDigraph::ArcIt arc(m_graph); arc != lemon::INVALID; ++arc)
            if (first(m_graph.source(arc)) && !first(m_graph.target(arc)))
                sum += m_capacity[arc];
        return sum;
    }

private:
    /// Nothing for a third of all.
    int draw() {
        const int n = m_draws++;
        return m_random.below(3, n, 0) == 0
                   ? 0
                   : static_cast<int>(m_random.below(static_cast<std::uint32_t>(m_largest), n, 1));
    }
    void arc(lemon::SmartDigraph::Node from, lemon::SmartDigraph::Node to, int capacity) {
        m_capacity[m_graph.addArc(from, to)] = capacity;
    }
    void link(int a, GridFlow::Side side, int b) {
        const int forth = draw(), back = draw();
        m_flow.link(a, side, b, forth, back);
        arc(m_nodes[static_cast<std::size_t>(a)], m_nodes[static_cast<std::size_t>(b)], forth);
        arc(m_nodes[static_cast<std::size_t>(b)], m_nodes[static_cast<std::size_t>(a)], back);
    }
    void tie(int node, int first, int second) {
        m_flow.tieToFirst(node, first);
        m_flow.tieToSecond(node, second);
        arc(m_first, m_nodes[static_cast<std::size_t>(node)], first);
        arc(m_nodes[static_cast<std::size_t>(node)], m_second, second);
    }

    GridFlow m_flow;
    lemon::SmartDigraph m_graph;
    lemon::SmartDigraph::ArcMap<std::int64_t> m_capacity;
    lemon::SmartDigraph::Node m_first, m_second;
    std::vector<lemon::SmartDigraph::Node> m_nodes;
    Random m_random;
    int m_largest;
    int m_draws = 0;
};

TEST(GridFlow, agreesWithAnotherSolver) {
    std::uint64_t seed = 1;
    for (const auto& [width, height] : {std::pair(1, 1), {2, 2}, {3, 4}, {17, 9}, {40, 31}})
        for (const int largest : {2, 9, 1000000})
            for (int n = 0; n < 20; ++n) {
                Grid grid(width, height, seed++, largest);
                const std::int64_t value = grid.flow().solve();
                EXPECT_EQ(value, grid.oracle()) << width << " × " << height << ", " << seed;
                EXPECT_EQ(value, grid.costOfCut()) << width << " × " << height << ", " << seed;
            }
}

TEST(GridFlow, cutsTheNarrowestOfAChain) {
    GridFlow flow(5);
    for (int i = 0; i < 5; ++i)
        flow.add();
    const int capacities[] = {7, 3, 5, 4};
    for (int i = 0; i < 4; ++i)
        flow.link(i, GridFlow::Right, i + 1, capacities[i], capacities[i]);
    flow.tieToFirst(0, GridFlow::kForbidden);
    flow.tieToSecond(4, GridFlow::kForbidden);
    EXPECT_EQ(flow.solve(), 3);
    for (int i = 0; i < 5; ++i)
        EXPECT_EQ(flow.first(i), i < 2) << i;
}

} // namespace
} // namespace texloom::test
