#include "core/methods/jump_map/jump_lists.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace texloom::jump_map {

namespace {

/// Leaves of the tree that likenesses are looked for in, for each that is wanted.
constexpr int kLeaves = 3;
/// Places less alike than this share of the best are not kept.
constexpr float kLeastLikeness = 0.5F;
/// Pairs from which it is learnt how unlike two places are.
constexpr int kPairs = 512;
/// Pixels that are looked at between two checks.
constexpr int kBlock = 256;
/// Random numbers of pairs are drawn here, away from those of places.
constexpr std::uint32_t kDraw = 8;

} // namespace

JumpLists::JumpLists(const NeighbourhoodSet& set, int count, int apart, JobContext& context)
    : m_set(set), m_count(count), m_apart(apart) {
    const NeighbourhoodTree tree(set, {}, context);
    const std::vector<Source>& sources = set.sources();
    for (const NeighbourhoodSource& exemplar : set.exemplars())
        m_numbers.emplace_back(static_cast<std::size_t>(exemplar.pictures.front()->size.area()), -1);
    for (std::size_t i = 0; i < sources.size(); ++i) {
        const int width = set.exemplars()[sources[i].exemplar].pictures.front()->size.width;
        m_numbers[sources[i].exemplar][static_cast<std::size_t>(sources[i].y) * width + sources[i].x] =
            static_cast<int>(i);
    }
    m_jumps.resize(sources.size() * static_cast<std::size_t>(count));
    const double unlike = meanDistance(context.random());
    const int blocks = static_cast<int>((sources.size() + kBlock - 1) / kBlock);
    constexpr int kParts = 32;
    for (int part = 0; part < kParts; ++part) {
        context.parallel(blocks * part / kParts, blocks * (part + 1) / kParts, [&](int block) {
            const std::size_t end = std::min(sources.size(), (static_cast<std::size_t>(block) + 1) * kBlock);
            for (auto i = static_cast<std::size_t>(block) * kBlock; i < end; ++i)
                find(i, tree, unlike);
        });
        context.progress((part + 1.0) / kParts);
    }
}

double JumpLists::meanDistance(const Random& random) const {
    std::vector<float> vector(static_cast<std::size_t>(m_set.neighbourhood().length()));
    double sum = 0;
    for (int i = 0; i < kPairs; ++i) {
        const Source& one = m_set.drawn(random.uniform(i, 0, kDraw));
        const Source& other = m_set.drawn(random.uniform(i, 1, kDraw));
        m_set.neighbourhood().gather(m_set.exemplars()[one.exemplar].pictures, one.x, one.y, vector.data());
        sum +=
            static_cast<double>(m_set.distance(vector.data(), other, std::numeric_limits<float>::infinity()));
    }
    return sum / kPairs;
}

bool JumpLists::farFrom(const Source& one, const Source& other) const {
    const int dx = one.x - other.x, dy = one.y - other.y;
    return one.exemplar != other.exemplar || dx * dx + dy * dy >= m_apart * m_apart;
}

void JumpLists::find(std::size_t number, const NeighbourhoodTree& tree, double unlike) {
    const Source& from = m_set.sources()[number];
    std::vector<float> vector(static_cast<std::size_t>(m_set.neighbourhood().length()));
    m_set.neighbourhood().gather(m_set.exemplars()[from.exemplar].pictures, from.x, from.y, vector.data());
    std::vector<PatchMatch> likely;
    NeighbourhoodTree::Lookup lookup(tree, vector.data());
    for (int i = 0; i < kLeaves * m_count; ++i)
        for (const Source& source : lookup.next())
            if (farFrom(source, from))
                likely.push_back({source, m_set.distance(vector.data(), source, HUGE_VALF)});
    std::stable_sort(likely.begin(), likely.end(),
                     [](const PatchMatch& a, const PatchMatch& b) { return a.distance < b.distance; });
    Jump* const jumps = m_jumps.data() + number * static_cast<std::size_t>(m_count);
    int kept = 0;
    for (std::size_t i = 0; i < likely.size() && kept < m_count; ++i) {
        const bool far = std::all_of(jumps, jumps + kept,
                                     [&](const Jump& jump) { return farFrom(jump.to, likely[i].source); });
        if (!far)
            continue;
        const double apart = unlike > 0 ? static_cast<double>(likely[i].distance) / unlike : 0;
        const auto likeness = static_cast<float>(std::max(0.0, 1 - apart));
        // What is far less alike than the best was only met because the tree showed nothing better.
        if (kept > 0 && likeness < kLeastLikeness * jumps[0].likeness)
            break;
        jumps[kept++] = {likely[i].source, likeness};
    }
}

std::span<const Jump> JumpLists::of(const Source& source) const {
    const int width = m_set.exemplars()[source.exemplar].pictures.front()->size.width;
    const int number = m_numbers[source.exemplar][static_cast<std::size_t>(source.y) * width + source.x];
    const Jump* const begin =
        m_jumps.data() + static_cast<std::size_t>(number) * static_cast<std::size_t>(m_count);
    const Jump* const end =
        std::find_if(begin, begin + m_count, [](const Jump& jump) { return !jump.to.valid(); });
    return {begin, end};
}

std::uint64_t JumpLists::bytesFor(std::span<const Size> exemplars, int count) {
    std::uint64_t bytes = NeighbourhoodTree::bytesFor(exemplars, {});
    for (const Size& size : exemplars)
        bytes += static_cast<std::uint64_t>(size.area()) *
                 (sizeof(int) + sizeof(Jump) * static_cast<std::uint64_t>(count));
    return bytes;
}

} // namespace texloom::jump_map
