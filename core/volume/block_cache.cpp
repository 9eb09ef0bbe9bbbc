#include "core/volume/block_cache.h"

#include "core/base/at.h"

#include <algorithm>
#include <limits>

namespace texloom {

namespace {

/// Thinner boxes are slices: of the blocks that they lie in they need little.
constexpr int kThin = 2;

/// The blocks that a stretch of voxels needs along one axis: from the first to the last of these.
std::pair<std::int64_t, std::int64_t> blocksAlong(std::int64_t begin, int length) {
    const auto block = [](std::int64_t voxel) {
        const std::int64_t below = voxel % kBlockSide < 0 ? 1 : 0;
        return voxel / kBlockSide - below;
    };
    const std::int64_t first = block(begin), end = begin + length - 1;
    // A block holds the first voxels of the next one, too.
    return {first, std::max(first, block(end - 1))};
}

/// Copies what two boxes have in common.
void copyCommon(const Volume& from, const Box& fromBox, Volume& to, const Box& toBox) {
    const Box common = intersection(fromBox, toBox);
    for (int c = 0; c < to.channels(); ++c)
        for (int z = 0; z < common.size.depth; ++z)
            for (int y = 0; y < common.size.height; ++y) {
                const auto row = [&](const Box& box) {
                    return std::pair(static_cast<int>(common.y - box.y) + y,
                                     static_cast<int>(common.z - box.z) + z);
                };
                const auto [fromY, fromZ] = row(fromBox);
                const auto [toY, toZ] = row(toBox);
                std::copy_n(from.row(fromY, fromZ, c) + (common.x - fromBox.x), common.size.width,
                            to.row(toY, toZ, c) + (common.x - toBox.x));
            }
}

} // namespace

BlockCache::BlockCache(std::shared_ptr<const VolumeSource> source, std::uint64_t bytes)
    : m_source(std::move(source)),
      m_most(std::max<std::uint64_t>(1, bytes / Volume::bytesFor(boxOf({}).size, m_source->channels()))) {}

std::size_t BlockCache::blocks() const {
    const std::lock_guard lock(m_mutex);
    return m_kept.size();
}

BlockCache::Shared BlockCache::kept(const BlockPlace& place) const {
    const std::lock_guard lock(m_mutex);
    const auto found = m_index.find(place);
    if (found == m_index.end())
        return nullptr;
    m_kept.splice(m_kept.begin(), m_kept, found->second);
    return found->second->second;
}

BlockCache::Shared BlockCache::block(const BlockPlace& place, JobContext& context) const {
    if (Shared here = kept(place))
        return here;
    auto made = std::make_shared<const Volume>(blockOf(*m_source, place, context));
    const std::lock_guard lock(m_mutex);
    if (m_index.contains(place)) // somebody else made it meanwhile
        return m_index[place]->second;
    m_kept.emplace_front(place, made);
    m_index[place] = m_kept.begin();
    for (; m_kept.size() > m_most; m_kept.pop_back())
        m_index.erase(m_kept.back().first);
    return made;
}

void BlockCache::fill(const Box& box, Volume& volume, JobContext& context) const {
    if (std::min({box.size.width, box.size.height, box.size.depth}) <= kThin) {
        volume = m_source->sample(box, context);
        return;
    }
    const auto x = blocksAlong(box.x, box.size.width), y = blocksAlong(box.y, box.size.height),
               z = blocksAlong(box.z, box.size.depth);
    for (std::int64_t k = z.first; k <= z.second; ++k)
        for (std::int64_t j = y.first; j <= y.second; ++j)
            for (std::int64_t i = x.first; i <= x.second; ++i) {
                context.check();
                copyCommon(*block({i, j, k}, context), boxOf({i, j, k}), volume, box);
            }
}

BlockCache::Samples BlockCache::at(std::span<const Eigen::Vector3d> points,
                                   std::optional<std::chrono::milliseconds> patience,
                                   JobContext& context) const {
    const auto began = std::chrono::steady_clock::now();
    const auto wanted = blocksOf(points);
    const std::size_t channels = texloom::at(m_source->channels());
    const bool hurried = patience && wanted.size() <= m_most;
    Samples samples;
    samples.values.assign(points.size() * channels, std::numeric_limits<float>::quiet_NaN());
    std::size_t done = 0;
    for (const auto& wantedBlock : wanted) {
        const BlockPlace& place = wantedBlock.first;
        const std::vector<std::size_t>& members = wantedBlock.second;
        context.check();
        const bool late = hurried && std::chrono::steady_clock::now() - began > *patience;
        const Shared here = late ? kept(place) : block(place, context);
        samples.whole = samples.whole && here;
        context.progress(static_cast<double>(++done) / static_cast<double>(wanted.size()));
        if (!here)
            continue;
        constexpr std::size_t kPart = 4096; ///< points for one thread at a time
        const auto parts = static_cast<int>((members.size() + kPart - 1) / kPart);
        context.parallel(0, parts, [&](int part) {
            const std::size_t begin = static_cast<std::size_t>(part) * kPart;
            for (std::size_t n = begin; n < std::min(begin + kPart, members.size()); ++n)
                interpolate(*here, place, points[members[n]], samples.values.data() + members[n] * channels);
        });
    }
    return samples;
}

} // namespace texloom
