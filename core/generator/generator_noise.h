#pragma once

#include "core/generator/field.h"
#include "core/job/job_context.h"

#include <cstdint>

namespace texloom {

/// The noise of a generator: independent uniform numbers in [0, 1), a pure function of seed, scale, channel
/// and coordinates at that scale.
class GeneratorNoise {
public:
    /// @param period after how many voxels of the output noise repeats along each axis, and with it the
    /// output; 0: never. Multiples of 2 to the power of the coarsest scale.
    explicit GeneratorNoise(std::uint64_t seed, const VolumeSize& period = {})
        : m_seed(seed), m_period(period) {}

    /// Fills `field`, which gets the size of the box. @param box at the scale.
    void fill(const Box& box, int scale, int channels, Field& field, JobContext& context) const;
    /// One number.
    float at(std::int64_t x, std::int64_t y, std::int64_t z, int scale, int channel) const;

private:
    std::uint64_t m_seed;
    VolumeSize m_period;
};

} // namespace texloom
