#pragma once

#include <cstdint>
#include <functional>
#include <vector>

namespace texloom {

/// Minimum cut between two terminals of a graph whose nodes have up to four links, as pixels have: by maximum
/// flow with search trees from both terminals (Boykov & Kolmogorov, "An experimental comparison of
/// min-cut/max-flow algorithms", IEEE PAMI 26, 2004). Capacities are integers, and nodes are processed in a
/// fixed order, so the cut is deterministic.
class GridFlow {
public:
    /// The four links of a node; opposite ones differ in the last bit.
    enum Side { Left, Right, Up, Down };
    /// A capacity that no cut crosses if there is any other.
    static constexpr std::int32_t kForbidden = 1 << 29;

    /// @param nodes number of nodes to reserve memory for.
    explicit GridFlow(std::size_t nodes);

    int add();
    int count() const { return static_cast<int>(m_nodes.size()); }
    /// Links node a to node b on this side of a, and b to a on the opposite one, with a capacity for flow
    /// from a to b and one back. Each side of a node may be linked once.
    void link(int a, Side side, int b, std::int32_t forth, std::int32_t back);
    /// Adds to the capacity between the first terminal and a node, or a node and the second.
    void tieToFirst(int node, std::int32_t capacity);
    void tieToSecond(int node, std::int32_t capacity);

    /// The value of the minimum cut. @param check called every few milliseconds; may throw.
    std::int64_t solve(const std::function<void()>& check = [] {});
    /// After solve(): whether a node is on the first terminal's side of the minimum cut nearest to that
    /// terminal.
    bool first(int node) const { return m_nodes[static_cast<std::size_t>(node)].tree == Tree::First; }

    static std::uint64_t bytesFor(std::size_t nodes) { return nodes * (sizeof(Node) + 2 * sizeof(int)); }

private:
    enum class Tree : std::uint8_t { None, First, Second };
    /// What a node can be attached to, apart from its four sides.
    static constexpr std::uint8_t kTerminal = 4, kOrphan = 5, kNone = 6;

    struct Node {
        int to[4] = {-1, -1, -1, -1};
        std::int32_t capacity[4] = {0, 0, 0, 0}; ///< residual, for flow away from the node
        std::int32_t terminal = 0;               ///< residual, from the first or, negative, to the second
        Tree tree = Tree::None;
        std::uint8_t parent = kNone;
        bool waiting = false;    ///< in the queue
        std::uint32_t stamp = 0; ///< of the round in which the distance was known
        int distance = 0;        ///< to the terminal
    };

    Node& at(int node) { return m_nodes[static_cast<std::size_t>(node)]; }
    static int opposite(int side) { return side ^ 1; }
    /// The residual capacity, in the tree's direction, of the link between a parent and its child.
    std::int32_t fromParent(const Node& parent, const Node& child, int childSide) const {
        return child.tree == Tree::First ? parent.capacity[opposite(childSide)] : child.capacity[childSide];
    }
    void begin();
    void wait(int node);
    int nextWaiting();
    void adopt(int node, int parent, int side);
    bool grow(int node, int& from, int& side);
    std::int32_t narrowest(int node);
    void push(int node, std::int32_t flow);
    std::int32_t augment(int from, int side);
    int distanceToTerminal(int node);
    void rehang(int node);
    void release(int node, Tree tree);

    std::vector<Node> m_nodes;
    std::vector<int> m_queue;
    std::size_t m_head = 0;
    std::vector<int> m_orphans;
    std::uint32_t m_round = 0;
    std::int64_t m_flow = 0;
};

} // namespace texloom
