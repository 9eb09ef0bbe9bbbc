#include "core/math/grid_flow.h"

#include <algorithm>
#include <limits>

namespace texloom {

GridFlow::GridFlow(std::size_t nodes) {
    m_nodes.reserve(nodes);
}

int GridFlow::add() {
    m_nodes.emplace_back();
    return count() - 1;
}

void GridFlow::link(int a, Side side, int b, std::int32_t forth, std::int32_t back) {
    at(a).to[side] = b;
    at(a).capacity[side] = forth;
    at(b).to[opposite(side)] = a;
    at(b).capacity[opposite(side)] = back;
}

/// Flow passes straight through a node that is tied to both terminals, which leaves a tie to one of them.
void GridFlow::tieToFirst(int node, std::int32_t capacity) {
    if (at(node).terminal < 0)
        m_flow += std::min(capacity, -at(node).terminal);
    at(node).terminal += capacity;
}

void GridFlow::tieToSecond(int node, std::int32_t capacity) {
    if (at(node).terminal > 0)
        m_flow += std::min(capacity, at(node).terminal);
    at(node).terminal -= capacity;
}

void GridFlow::wait(int node) {
    if (at(node).waiting)
        return;
    at(node).waiting = true;
    m_queue.push_back(node);
}

/// The next node in the queue that is still in a tree, or −1.
int GridFlow::nextWaiting() {
    while (m_head < m_queue.size()) {
        const int node = m_queue[m_head++];
        at(node).waiting = false;
        if (m_head > 4096 && 2 * m_head > m_queue.size()) {
            m_queue.erase(m_queue.begin(), m_queue.begin() + static_cast<std::ptrdiff_t>(m_head));
            m_head = 0;
        }
        if (at(node).tree != Tree::None)
            return node;
    }
    return -1;
}

void GridFlow::begin() {
    for (int node = 0; node < count(); ++node) {
        Node& n = at(node);
        if (n.terminal == 0)
            continue;
        n.tree = n.terminal > 0 ? Tree::First : Tree::Second;
        n.parent = kTerminal;
        n.distance = 1;
        wait(node);
    }
}

/// Attaches a node to the parent on this side of it.
void GridFlow::adopt(int node, int parent, int side) {
    Node& child = at(node);
    child.tree = at(parent).tree;
    child.parent = static_cast<std::uint8_t>(side);
    child.stamp = at(parent).stamp;
    child.distance = at(parent).distance + 1;
}

/// Visits the neighbours of a node in a tree and adopts those that are free.
/// @return whether a node of the other tree was found: flow can then go from node `from` through its `side`.
bool GridFlow::grow(int node, int& from, int& side) {
    const Tree tree = at(node).tree;
    for (int s = 0; s < 4; ++s) {
        const int other = at(node).to[s];
        if (other < 0)
            continue;
        const std::int32_t left =
            tree == Tree::First ? at(node).capacity[s] : at(other).capacity[opposite(s)];
        if (left == 0)
            continue;
        Node& neighbour = at(other);
        if (neighbour.tree == Tree::None) {
            adopt(other, node, opposite(s));
            wait(other);
        } else if (neighbour.tree != tree) {
            from = tree == Tree::First ? node : other;
            side = tree == Tree::First ? s : opposite(s);
            return true;
        } else if (neighbour.parent < kTerminal && neighbour.stamp <= at(node).stamp &&
                   neighbour.distance > at(node).distance + 1) {
            // A shorter path to the terminal.
            adopt(other, node, opposite(s));
        }
    }
    return false;
}

/// The least residual capacity between a node and its tree's terminal.
std::int32_t GridFlow::narrowest(int node) {
    std::int32_t least = std::numeric_limits<std::int32_t>::max();
    while (at(node).parent != kTerminal) {
        const Node& child = at(node);
        const int parent = child.to[child.parent];
        least = std::min(least, fromParent(at(parent), child, child.parent));
        node = parent;
    }
    return std::min(least, std::abs(at(node).terminal));
}

/// Sends flow along the tree; nodes whose link is then saturated become orphans.
void GridFlow::push(int node, std::int32_t flow) {
    const Tree tree = at(node).tree;
    while (at(node).parent != kTerminal) {
        Node& child = at(node);
        const int side = child.parent, parent = child.to[side];
        Node& above = at(parent);
        const std::int32_t down = tree == Tree::First ? -flow : flow;
        above.capacity[opposite(side)] += down;
        child.capacity[side] -= down;
        if (fromParent(above, child, side) == 0) {
            child.parent = kOrphan;
            m_orphans.push_back(node);
        }
        node = parent;
    }
    Node& top = at(node);
    top.terminal += tree == Tree::First ? -flow : flow;
    if (top.terminal == 0) {
        top.parent = kOrphan;
        m_orphans.push_back(node);
    }
}

/// Sends as much flow as fits through the link between the trees.
std::int32_t GridFlow::augment(int from, int side) {
    const int to = at(from).to[side];
    const std::int32_t flow = std::min({at(from).capacity[side], narrowest(from), narrowest(to)});
    at(from).capacity[side] -= flow;
    at(to).capacity[opposite(side)] += flow;
    push(from, flow);
    push(to, flow);
    return flow;
}

/// The distance of a node from its tree's terminal, or −1 if it descends from an orphan. Distances found are
/// kept for the round.
int GridFlow::distanceToTerminal(int node) {
    int steps = 0, current = node;
    while (at(current).stamp != m_round) {
        if (at(current).parent == kTerminal) {
            at(current).stamp = m_round;
            at(current).distance = 1;
            break;
        }
        if (at(current).parent >= kOrphan)
            return -1;
        ++steps;
        current = at(current).to[at(current).parent];
    }
    int distance = at(current).distance + steps;
    const int found = distance;
    for (current = node; at(current).stamp != m_round; current = at(current).to[at(current).parent]) {
        at(current).stamp = m_round;
        at(current).distance = distance--;
    }
    return found;
}

/// Gives an orphan the parent nearest to the terminal, or frees it.
void GridFlow::rehang(int node) {
    Node& orphan = at(node);
    int best = -1, bestDistance = std::numeric_limits<int>::max();
    for (int s = 0; s < 4; ++s) {
        const int other = orphan.to[s];
        if (other < 0 || at(other).tree != orphan.tree || fromParent(at(other), orphan, s) == 0)
            continue;
        const int distance = distanceToTerminal(other);
        if (distance >= 0 && distance < bestDistance) {
            best = s;
            bestDistance = distance;
        }
    }
    if (best < 0)
        return release(node, orphan.tree);
    orphan.parent = static_cast<std::uint8_t>(best);
    orphan.stamp = m_round;
    orphan.distance = bestDistance + 1;
}

/// Removes a node from its tree: its children become orphans, and neighbours may adopt it again.
void GridFlow::release(int node, Tree tree) {
    Node& freed = at(node);
    for (int s = 0; s < 4; ++s) {
        const int other = freed.to[s];
        if (other < 0 || at(other).tree != tree)
            continue;
        if (fromParent(at(other), freed, s) > 0)
            wait(other);
        if (at(other).parent == opposite(s)) {
            at(other).parent = kOrphan;
            m_orphans.push_back(other);
        }
    }
    freed.tree = Tree::None;
    freed.parent = kNone;
}

std::int64_t GridFlow::solve(const std::function<void()>& check) {
    begin();
    int current = -1;
    for (std::uint32_t step = 0;; ++step) {
        if (step % 512 == 0)
            check();
        if (current < 0 || at(current).tree == Tree::None)
            current = nextWaiting();
        if (current < 0)
            return m_flow;
        int from = 0, side = 0;
        if (!grow(current, from, side)) {
            current = -1;
            continue;
        }
        ++m_round;
        m_flow += augment(from, side);
        // More orphans may be added meanwhile.
        for (std::size_t i = 0; i < m_orphans.size(); ++i) {
            if (i % 4096 == 4095)
                check();
            rehang(m_orphans[i]);
        }
        m_orphans.clear();
    }
}

} // namespace texloom
