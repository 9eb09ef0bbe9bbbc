#pragma once

#include "core/volume/point_blocks.h"

#include <chrono>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

namespace texloom {

/// A source that is looked at again and again: the blocks that were made for it are kept, up to some memory,
/// those used last longest. Has the voxels of the source itself, bit for bit.
class BlockCache : public VolumeSource {
public:
    static constexpr std::uint64_t kUsualBytes = 256U << 20U;

    explicit BlockCache(std::shared_ptr<const VolumeSource> source, std::uint64_t bytes = kUsualBytes);

    int channels() const override { return m_source->channels(); }
    std::optional<Box> bounds() const override { return m_source->bounds(); }
    VolumeSize period() const override { return m_source->period(); }

    /// Values at points, as sampledAt() gives them.
    struct Samples {
        std::vector<float>
            values;        ///< channels numbers for each point; no numbers (NaN) where `whole` is false
        bool whole = true; ///< whether all were found in time
    };
    /// @param patience no further block is made after this time; blocks that are here are used all the same.
    /// Without it, and where the cache cannot hold all blocks at once, all are made.
    /// @throws as sampledAt()
    Samples at(std::span<const Eigen::Vector3d> points, std::optional<std::chrono::milliseconds> patience,
               JobContext& context) const;
    /// How many blocks are kept now.
    std::size_t blocks() const;

private:
    using Shared = std::shared_ptr<const Volume>;
    using Kept = std::list<std::pair<BlockPlace, Shared>>; ///< the one used last in front

    void fill(const Box& box, Volume& volume, JobContext& context) const override;
    Shared kept(const BlockPlace& place) const;
    Shared block(const BlockPlace& place, JobContext& context) const;

    std::shared_ptr<const VolumeSource> m_source;
    std::size_t m_most; ///< blocks that are kept
    mutable std::mutex m_mutex;
    mutable Kept m_kept;
    mutable std::map<BlockPlace, Kept::iterator> m_index;
};

} // namespace texloom
