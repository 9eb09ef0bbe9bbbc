#include "core/match/patch_tree.h"

#include "core/math/pca.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace texloom {

namespace {

/// The axes are learnt from about this many patches and use at most this many values of each.
constexpr double kSamples = 1500;
constexpr int kDimensions = 150;
/// Larger sets are subsampled: the neighbours of the patches left out are found by propagation.
constexpr double kMostPatches = 1 << 18;

double pixelsOf(std::span<const Interleaved* const> images) {
    double pixels = 0;
    for (const Interleaved* image : images)
        pixels += static_cast<double>(image->size.area());
    return pixels;
}

/// Calls visit(source, pixels) for every `step`-th patch in both directions.
template <class Visit>
void everyPatch(std::span<const Interleaved* const> images, int patch, int step, const Visit& visit) {
    for (std::size_t e = 0; e < images.size(); ++e)
        for (int y = 0; y + patch <= images[e]->size.height; y += step)
            for (int x = 0; x + patch <= images[e]->size.width; x += step)
                visit(Source{static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y),
                             static_cast<std::uint16_t>(e)},
                      images[e]->at(x, y));
}

int stepFor(double patches, double most) {
    return std::max(1, static_cast<int>(std::ceil(std::sqrt(patches / most))));
}

} // namespace

PatchTree::PatchTree(std::span<const Interleaved* const> images, int channels, int patch,
                     const std::function<bool(const Source&)>& has, const std::function<void()>& check)
    : m_patch(patch), m_pixel(images.front()->pixel) {
    learnAxes(images, channels);
    check();
    std::vector<Entry> entries;
    int looked = 0;
    everyPatch(images, patch, stepFor(pixelsOf(images), kMostPatches),
               [&](const Source& source, const float* pixels) {
                   if (++looked % 4096 == 0)
                       check();
                   if (has(source))
                       entries.push_back({describe(pixels, images[source.exemplar]->stride()), source});
               });
    if (!entries.empty())
        divide(entries, 0, static_cast<int>(entries.size()), check);
    for (const Entry& entry : entries)
        m_sources.push_back(entry.source);
}

void PatchTree::learnAxes(std::span<const Interleaved* const> images, int channels) {
    const int used = std::clamp(kDimensions / (m_patch * m_patch), 1, channels);
    const int dimension = m_patch * m_patch * used;
    std::vector<double> samples;
    everyPatch(images, m_patch, stepFor(pixelsOf(images), kSamples),
               [&](const Source& source, const float* pixels) {
                   for (int y = 0; y < m_patch; ++y)
                       for (int x = 0; x < m_patch; ++x)
                           for (int c = 0; c < used; ++c)
                               samples.push_back(static_cast<double>(
                                   pixels[y * images[source.exemplar]->stride() + x * m_pixel + c]));
               });
    const PrincipalAxes principal = principalAxes(samples, dimension, std::min(kAxes, dimension));
    const auto row = static_cast<std::size_t>(m_patch) * static_cast<std::size_t>(m_pixel);
    m_weights.assign(row * 2 * static_cast<std::size_t>(m_patch), Vector{});
    for (int a = 0; a < principal.count(); ++a)
        for (int i = 0; i < dimension; ++i) {
            const int c = i % used, x = i / used % m_patch, y = i / used / m_patch;
            const auto at = static_cast<std::size_t>(y) * row + static_cast<std::size_t>(x * m_pixel + c);
            m_weights[2 * at + static_cast<std::size_t>(a / 4)][a % 4] =
                static_cast<float>(principal.axis(a)[static_cast<std::size_t>(i)]);
        }
}

PatchTree::Descriptor PatchTree::describe(const float* pixels, std::ptrdiff_t stride) const {
    Vector first{}, second{};
    const Vector* weight = m_weights.data();
    for (int y = 0; y < m_patch; ++y)
        for (int i = 0; i < m_patch * m_pixel; ++i, weight += 2) {
            const float value = pixels[y * stride + i];
            first += weight[0] * value;
            second += weight[1] * value;
        }
    return {first[0], first[1], first[2], first[3], second[0], second[1], second[2], second[3]};
}

int PatchTree::divide(std::vector<Entry>& entries, int begin, int end, const std::function<void()>& check) {
    if (end - begin > 2048)
        check();
    const int number = static_cast<int>(m_nodes.size());
    m_nodes.push_back({-1, 0, begin, end});
    if (end - begin <= kLeaf)
        return number;
    std::size_t widest = 0;
    float width = -1;
    for (std::size_t a = 0; a < kAxes; ++a) {
        float low = std::numeric_limits<float>::max(), high = std::numeric_limits<float>::lowest();
        for (int i = begin; i < end; ++i) {
            low = std::min(low, entries[static_cast<std::size_t>(i)].descriptor[a]);
            high = std::max(high, entries[static_cast<std::size_t>(i)].descriptor[a]);
        }
        if (high - low > width) {
            width = high - low;
            widest = a;
        }
    }
    const int middle = begin + (end - begin) / 2;
    const auto before = [widest](const Entry& a, const Entry& b) {
        return a.descriptor[widest] < b.descriptor[widest];
    };
    std::nth_element(entries.begin() + begin, entries.begin() + middle, entries.begin() + end, before);
    const float split = entries[static_cast<std::size_t>(middle)].descriptor[widest];
    const int first = divide(entries, begin, middle, check);
    const int second = divide(entries, middle, end, check);
    m_nodes[static_cast<std::size_t>(number)] = {static_cast<int>(widest), split, first, second};
    return number;
}

PatchTree::Lookup::Lookup(const PatchTree& tree, const float* pixels, std::ptrdiff_t stride) : m_tree(tree) {
    if (!tree.m_nodes.empty()) {
        m_descriptor = tree.describe(pixels, stride);
        m_next = 0;
    }
}

std::span<const Source> PatchTree::Lookup::next() {
    if (m_next < 0)
        return {};
    const Node* node = &m_tree.m_nodes[static_cast<std::size_t>(m_next)];
    while (node->axis >= 0) {
        const float gap = m_descriptor[static_cast<std::size_t>(node->axis)] - node->split;
        remember({std::abs(gap), gap >= 0 ? node->first : node->second});
        node = &m_tree.m_nodes[static_cast<std::size_t>(gap >= 0 ? node->second : node->first)];
    }
    m_next = m_others > 0 ? m_other[0].node : -1;
    if (m_others > 0)
        std::move(m_other.begin() + 1, m_other.begin() + m_others--, m_other.begin());
    return {m_tree.m_sources.data() + node->first, static_cast<std::size_t>(node->second - node->first)};
}

void PatchTree::Lookup::remember(const Branch& branch) {
    int at = std::min(m_others, kBranches - 1);
    if (m_others == kBranches && branch.gap >= m_other[static_cast<std::size_t>(at)].gap)
        return;
    for (; at > 0 && m_other[static_cast<std::size_t>(at) - 1].gap > branch.gap; --at)
        m_other[static_cast<std::size_t>(at)] = m_other[static_cast<std::size_t>(at) - 1];
    m_other[static_cast<std::size_t>(at)] = branch;
    m_others = std::min(m_others + 1, kBranches);
}

} // namespace texloom
