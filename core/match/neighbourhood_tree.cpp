#include "core/match/neighbourhood_tree.h"

#include "core/base/wide_vectors.h"
#include "core/math/pca.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace texloom {

namespace {

/// The axes are learnt from about this many vectors, and look at no more floats of each, those nearest to the
/// centre.
constexpr std::size_t kMostSamples = 1200;
constexpr int kMostFloats = 160;
/// Centroids are found by so many rounds on about so many vectors.
constexpr int kRounds = 4;
constexpr int kRoundSample = 4096;
/// A division that leaves less than this share on one side is made in the middle instead.
constexpr int kLeastShare = 16;
constexpr int kTreeLanes = 8;
/// Neighbourhoods that one thread describes at a time.
constexpr std::size_t kDescribed = 1024;
/// Neighbourhoods that one thread divides at a time, where parts are smaller.
constexpr std::size_t kDivided = 4096;

TEXLOOM_WIDE_VECTORS float squares(const float* a, const float* b, int count) {
    float lanes[kTreeLanes] = {};
    for (int i = 0; i < count; i += kTreeLanes)
        for (int lane = 0; lane < kTreeLanes; ++lane)
            lanes[lane] += (a[i + lane] - b[i + lane]) * (a[i + lane] - b[i + lane]);
    return ((lanes[0] + lanes[4]) + (lanes[1] + lanes[5])) + ((lanes[2] + lanes[6]) + (lanes[3] + lanes[7]));
}

TEXLOOM_WIDE_VECTORS void project(const float* vector, const std::vector<int>& chosen, const float* weights,
                                  int axes, float* to) {
    for (int first = 0; first < axes; first += kTreeLanes) {
        float lanes[kTreeLanes] = {};
        const float* weight = weights + first;
        for (const int at : chosen) {
            const float value = vector[at];
            for (int lane = 0; lane < kTreeLanes; ++lane)
                lanes[lane] += weight[lane] * value;
            weight += axes;
        }
        std::copy_n(lanes, kTreeLanes, to + first);
    }
}

/// The first source that is nearest of a leaf; `best` and `limit` are those so far.
TEXLOOM_WIDE_VECTORS void consider(const NeighbourhoodSet& set, std::span<const Source> leaf,
                                   const float* wanted, Source& best, float& limit) {
    const auto before = [](const Source& a, const Source& b) {
        return a.exemplar != b.exemplar ? a.exemplar < b.exemplar : a.y != b.y ? a.y < b.y : a.x < b.x;
    };
    for (const Source& source : leaf) {
        const float found = set.distance(wanted, source, limit);
        if (found < limit || (found == limit && (!best.valid() || before(source, best)))) {
            limit = found;
            best = source;
        }
    }
}

} // namespace

void NeighbourhoodTree::inTurn(int count, const std::function<void(int)>& body) {
    for (int i = 0; i < count; ++i)
        body(i);
}

NeighbourhoodTree::NeighbourhoodTree(const NeighbourhoodSet& set, const Options& options, const Check& check,
                                     const Each& each)
    : m_set(set) {
    learnAxes(options, check);
    const std::vector<Source>& sources = set.sources();
    const Neighbourhood& neighbourhood = set.neighbourhood();
    std::vector<int> order(sources.size());
    std::iota(order.begin(), order.end(), 0);
    m_descriptors.resize(sources.size() * static_cast<std::size_t>(m_axes));
    each(static_cast<int>((sources.size() + kDescribed - 1) / kDescribed), [&](int share) {
        check();
        std::vector<float> vector(static_cast<std::size_t>(neighbourhood.length()));
        const std::size_t begin = static_cast<std::size_t>(share) * kDescribed;
        for (std::size_t i = begin; i < std::min(sources.size(), begin + kDescribed); ++i) {
            neighbourhood.gather(set.exemplars()[sources[i].exemplar].pictures, sources[i].x, sources[i].y,
                                 vector.data());
            describe(vector.data(), m_descriptors.data() + i * static_cast<std::size_t>(m_axes));
        }
    });
    divide(order, options.leaf, check, each);
    m_sources.reserve(order.size());
    for (const int entry : order)
        m_sources.push_back(sources[static_cast<std::size_t>(entry)]);
    m_descriptors = {};
}

NeighbourhoodTree::NeighbourhoodTree(const NeighbourhoodSet& set, const Options& options, JobContext& context)
    : NeighbourhoodTree(
          set, options, [&context] { context.check(); },
          [&context](int count, const std::function<void(int)>& body) { context.parallel(0, count, body); }) {
}

void NeighbourhoodTree::learnAxes(const Options& options, const Check& check) {
    const Neighbourhood& neighbourhood = m_set.neighbourhood();
    m_chosen = neighbourhood.nearestFloats(kMostFloats);
    const std::vector<Source>& sources = m_set.sources();
    const std::size_t step = std::max<std::size_t>(1, sources.size() / kMostSamples);
    std::vector<float> vector(static_cast<std::size_t>(neighbourhood.length()));
    // What weighs more is made longer, so that distances of descriptors are weighed too.
    const auto length = [&](int at) {
        const std::vector<float>& weights = neighbourhood.weights();
        return weights.empty() ? 1.0 : std::sqrt(static_cast<double>(weights[static_cast<std::size_t>(at)]));
    };
    std::vector<double> samples;
    for (std::size_t i = step / 2; i < sources.size(); i += step) {
        neighbourhood.gather(m_set.exemplars()[sources[i].exemplar].pictures, sources[i].x, sources[i].y,
                             vector.data());
        for (const int at : m_chosen)
            samples.push_back(length(at) * static_cast<double>(vector[static_cast<std::size_t>(at)]));
    }
    check();
    const int dimension = static_cast<int>(m_chosen.size());
    const PrincipalAxes principal = principalAxes(samples, dimension, dimension);
    check();
    double whole = 0, held = 0;
    for (const double variance : principal.variances)
        whole += std::max(0.0, variance);
    int used = 0;
    while (used < std::min(options.axes, dimension) && (used == 0 || held < options.variance * whole))
        held += std::max(0.0, principal.variances[static_cast<std::size_t>(used++)]);
    m_axes = (used + kTreeLanes - 1) / kTreeLanes * kTreeLanes;
    m_weights.assign(m_chosen.size() * static_cast<std::size_t>(m_axes), 0.0F);
    for (int a = 0; a < used; ++a)
        for (std::size_t i = 0; i < m_chosen.size(); ++i)
            m_weights[i * static_cast<std::size_t>(m_axes) + static_cast<std::size_t>(a)] =
                static_cast<float>(length(m_chosen[i]) * principal.axis(a)[i]);
}

void NeighbourhoodTree::describe(const float* vector, float* descriptor) const {
    project(vector, m_chosen, m_weights.data(), m_axes, descriptor);
}

bool NeighbourhoodTree::nearerFirst(const float* descriptor, const float* centroids) const {
    return squares(descriptor, centroids, m_axes) <= squares(descriptor, centroids + m_axes, m_axes);
}

/// The axis along which the vectors are spread most, and the two that lie furthest apart on it.
void NeighbourhoodTree::spread(const std::vector<int>& order, int begin, int end, int step, float* centroids,
                               int& axis) const {
    const auto axes = static_cast<std::size_t>(m_axes);
    std::vector<double> sums(axes, 0.0), squared(axes, 0.0);
    for (int i = begin; i < end; i += step) {
        const float* one = descriptorOf(order[static_cast<std::size_t>(i)]);
        for (std::size_t a = 0; a < axes; ++a) {
            const auto value = static_cast<double>(one[a]);
            sums[a] += value;
            squared[a] += value * value;
        }
    }
    const int count = (end - begin + step - 1) / step;
    double most = -1;
    for (std::size_t a = 0; a < axes; ++a) {
        const double variance = squared[a] - sums[a] * sums[a] / count;
        if (variance > most) {
            most = variance;
            axis = static_cast<int>(a);
        }
    }
    int low = order[static_cast<std::size_t>(begin)], high = low;
    for (int i = begin; i < end; i += step) {
        const int one = order[static_cast<std::size_t>(i)];
        low = descriptorOf(one)[axis] < descriptorOf(low)[axis] ? one : low;
        high = descriptorOf(one)[axis] > descriptorOf(high)[axis] ? one : high;
    }
    std::copy_n(descriptorOf(low), m_axes, centroids);
    std::copy_n(descriptorOf(high), m_axes, centroids + m_axes);
}

void NeighbourhoodTree::twoMeans(const std::vector<int>& order, int begin, int end, int step,
                                 float* centroids) const {
    const auto axes = static_cast<std::size_t>(m_axes);
    for (int round = 0; round < kRounds; ++round) {
        std::vector<double> sums(2 * axes, 0.0);
        int counts[2] = {};
        for (int i = begin; i < end; i += step) {
            const float* one = descriptorOf(order[static_cast<std::size_t>(i)]);
            const std::size_t side = nearerFirst(one, centroids) ? 0 : 1;
            ++counts[side];
            for (std::size_t a = 0; a < axes; ++a)
                sums[side * axes + a] += static_cast<double>(one[a]);
        }
        for (std::size_t side = 0; side < 2; ++side)
            for (std::size_t a = 0; a < axes && counts[side] > 0; ++a)
                centroids[side * axes + a] = static_cast<float>(sums[side * axes + a] / counts[side]);
    }
}

/// Sorts the range by the nearer of two centroids, which it finds. @return where the second part begins.
int NeighbourhoodTree::partition(std::vector<int>& order, int begin, int end, float* centroids) const {
    const int step = std::max(1, (end - begin) / kRoundSample);
    int axis = 0;
    spread(order, begin, end, step, centroids, axis);
    twoMeans(order, begin, end, step, centroids);
    const auto middle = std::stable_partition(order.begin() + begin, order.begin() + end, [&](int one) {
        return nearerFirst(descriptorOf(one), centroids);
    });
    const int found = static_cast<int>(middle - order.begin());
    const int least = std::max(1, (end - begin) / kLeastShare);
    if (found - begin >= least && end - found >= least)
        return found;
    const int half = begin + (end - begin) / 2;
    std::sort(order.begin() + begin, order.begin() + end, [&](int a, int b) {
        const float first = descriptorOf(a)[axis], second = descriptorOf(b)[axis];
        return first != second ? first < second : a < b;
    });
    for (int side = 0; side < 2; ++side) {
        const int from = side == 0 ? begin : half, to = side == 0 ? half : end;
        for (int a = 0; a < m_axes; ++a) {
            double sum = 0;
            for (int i = from; i < to; ++i)
                sum += static_cast<double>(descriptorOf(order[static_cast<std::size_t>(i)])[a]);
            centroids[side * m_axes + a] = static_cast<float>(sum / (to - from));
        }
    }
    return half;
}

/// Level by level, since what is divided on one level lies apart.
void NeighbourhoodTree::divide(std::vector<int>& order, int leaf, const Check& check, const Each& each) {
    m_nodes.push_back({-1, -1, 0, static_cast<int>(order.size()), 0});
    for (std::size_t first = 0; first < m_nodes.size();) {
        const std::size_t end = m_nodes.size();
        std::vector<int> divided;
        for (std::size_t i = first; i < end; ++i)
            if (m_nodes[i].end - m_nodes[i].begin > leaf)
                divided.push_back(static_cast<int>(i));
        if (!divided.empty())
            divideLevel(order, divided, check, each);
        first = end;
    }
}

void NeighbourhoodTree::divideLevel(std::vector<int>& order, std::span<const int> nodes, const Check& check,
                                    const Each& each) {
    for (const int number : nodes) {
        m_nodes[static_cast<std::size_t>(number)].centroids = m_centroids.size();
        m_centroids.resize(m_centroids.size() + 2 * static_cast<std::size_t>(m_axes));
    }
    std::vector<int> middles(nodes.size());
    const std::size_t atOnce = std::max<std::size_t>(1, nodes.size() * kDivided / order.size());
    each(static_cast<int>((nodes.size() + atOnce - 1) / atOnce), [&](int share) {
        check();
        const std::size_t begin = static_cast<std::size_t>(share) * atOnce;
        for (std::size_t i = begin; i < std::min(nodes.size(), begin + atOnce); ++i) {
            const Node& node = m_nodes[static_cast<std::size_t>(nodes[i])];
            middles[i] = partition(order, node.begin, node.end, m_centroids.data() + node.centroids);
        }
    });
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        Node& node = m_nodes[static_cast<std::size_t>(nodes[i])];
        const Node left{-1, -1, node.begin, middles[i], 0}, right{-1, -1, middles[i], node.end, 0};
        node.left = static_cast<int>(m_nodes.size());
        node.right = node.left + 1;
        m_nodes.push_back(left);
        m_nodes.push_back(right);
    }
}

NeighbourhoodTree::Lookup::Lookup(const NeighbourhoodTree& tree, const float* wanted)
    : m_tree(tree), m_descriptor(static_cast<std::size_t>(tree.m_axes)) {
    tree.describe(wanted, m_descriptor.data());
}

std::span<const Source> NeighbourhoodTree::Lookup::next() {
    if (m_next < 0)
        return {};
    const int axes = m_tree.m_axes;
    const Node* node = &m_tree.m_nodes[static_cast<std::size_t>(m_next)];
    while (node->left >= 0) {
        const float* centroids = m_tree.m_centroids.data() + node->centroids;
        const float first = squares(m_descriptor.data(), centroids, axes);
        const float second = squares(m_descriptor.data(), centroids + axes, axes);
        remember({std::abs(first - second), first <= second ? node->right : node->left});
        node = &m_tree.m_nodes[static_cast<std::size_t>(first <= second ? node->left : node->right)];
    }
    m_next = m_count > 0 ? m_others[0].node : -1;
    if (m_count > 0)
        std::move(m_others.begin() + 1, m_others.begin() + static_cast<std::ptrdiff_t>(m_count--),
                  m_others.begin());
    return {m_tree.m_sources.data() + node->begin, static_cast<std::size_t>(node->end - node->begin)};
}

void NeighbourhoodTree::Lookup::remember(const Branch& branch) {
    if (m_count == kBranches && branch.doubt >= m_others[kBranches - 1].doubt)
        return;
    std::size_t at = std::min(m_count, kBranches - 1);
    for (; at > 0 && m_others[at - 1].doubt > branch.doubt; --at)
        m_others[at] = m_others[at - 1];
    m_others[at] = branch;
    m_count = std::min(m_count + 1, kBranches);
}

Source NeighbourhoodTree::nearest(const float* wanted, int leaves) const {
    Lookup lookup(*this, wanted);
    Source best;
    float limit = std::numeric_limits<float>::infinity();
    for (int i = 0; i < leaves; ++i) {
        const std::span<const Source> leaf = lookup.next();
        if (leaf.empty())
            break;
        consider(m_set, leaf, wanted, best, limit);
    }
    return best;
}

std::uint64_t NeighbourhoodTree::bytesFor(std::span<const Size> exemplars, const Options& options) {
    const auto floats = (static_cast<std::uint64_t>(options.axes) + kTreeLanes - 1) / kTreeLanes * kTreeLanes;
    std::uint64_t bytes = 0;
    for (const Size& size : exemplars) {
        const auto count = static_cast<std::uint64_t>(size.area());
        // Leaves may hold a single one, and a list that grows may take twice its room.
        const std::uint64_t nodes = 2 * count;
        bytes += count * (floats * sizeof(float) + sizeof(int) + sizeof(Source)) +
                 nodes * 2 / static_cast<std::uint64_t>(std::max(1, options.leaf / 4)) *
                     (sizeof(Node) + 2 * floats * sizeof(float));
    }
    return bytes;
}

} // namespace texloom
