#pragma once

#include "core/generator/field.h"
#include "core/job/job_context.h"

#include <cstdint>

namespace texloom {

/// The noise of a generator: independent uniform numbers in [0, 1), a pure function of seed, scale, channel
/// and coordinates at that scale.
class GeneratorNoise {
public:
    /// @param period after how many voxels the output repeats along each axis, and its noise with it, see
    /// periodAt(); 0: never.
    explicit GeneratorNoise(std::uint64_t seed, const VolumeSize& period = {})
        : m_seed(seed), m_period(period) {}

    /// Of the output along each axis; 0: none.
    const VolumeSize& period() const { return m_period; }
    /// The same at a scale.
    VolumeSize period(int scale) const;
    /// Fills `field`, which gets the size of the box. @param box at the scale.
    void fill(const Box& box, int scale, int channels, Field& field, JobContext& context) const;
    /// One number.
    float at(std::int64_t x, std::int64_t y, std::int64_t z, int scale, int channel) const;

private:
    std::uint64_t m_seed;
    VolumeSize m_period;
};

} // namespace texloom
