#pragma once

#include "core/job/job_context.h"
#include "core/volume/volume.h"

#include <memory>
#include <optional>

namespace texloom {

/// A solid that answers for any box of voxels: a volume in memory, or a rule that makes what is asked for.
/// What two boxes have in common is the same in both, bit for bit. May be used from several threads at once.
class VolumeSource {
public:
    VolumeSource() = default;
    virtual ~VolumeSource() = default;
    VolumeSource(const VolumeSource&) = delete;
    VolumeSource& operator=(const VolumeSource&) = delete;

    virtual int channels() const = 0;
    /// Where it ends; nothing if it goes on in all directions.
    virtual std::optional<Box> bounds() const { return std::nullopt; }
    /// After how many voxels along each axis it repeats; 0 where it does not.
    virtual VolumeSize period() const { return {}; }

    /// The voxels of a box.
    /// @throws UsageError if the box is empty, too far out, or not within the bounds; Error if it takes more
    /// memory than is free; Cancelled
    Volume sample(const Box& box, JobContext& context) const;

private:
    /// Fills `volume`, of box.size and all 0, with the voxels of `box`, which lies within the bounds. Checks
    /// for cancellation at least every 50 ms.
    virtual void fill(const Box& box, Volume& volume, JobContext& context) const = 0;
};

/// A volume in memory, its first voxel at (0, 0, 0) or elsewhere: what it holds and nothing else, or repeated
/// without end.
class DenseSource : public VolumeSource {
public:
    enum class Edge { Ends, Repeats };
    /// @param x, y, z place of the volume's first voxel.
    DenseSource(Volume volume, Edge edge, std::int64_t x = 0, std::int64_t y = 0, std::int64_t z = 0);

    const Volume& volume() const { return m_volume; }
    int channels() const override { return m_volume.channels(); }
    std::optional<Box> bounds() const override;
    VolumeSize period() const override;

private:
    void fill(const Box& box, Volume& volume, JobContext& context) const override;

    Volume m_volume;
    Edge m_edge;
    Box m_box;
};

} // namespace texloom
