#include "core/generator/generator_noise.h"

#include "core/generator/intervals.h"
#include "core/job/voxel_random.h"

#include <algorithm>

namespace texloom {

namespace {

/// Streams of numbers that nothing else draws from: one for each scale.
constexpr std::uint32_t kFirstStream = 0x67656E00;

std::int64_t wrapped(std::int64_t place, int period) {
    if (period <= 0)
        return place;
    const std::int64_t rest = place % period;
    return rest < 0 ? rest + period : rest;
}

} // namespace

VolumeSize GeneratorNoise::period(int scale) const {
    return {periodAt(m_period.width, scale), periodAt(m_period.height, scale),
            periodAt(m_period.depth, scale)};
}

float GeneratorNoise::at(std::int64_t x, std::int64_t y, std::int64_t z, int scale, int channel) const {
    const VoxelRandom random(m_seed, kFirstStream + static_cast<std::uint32_t>(scale));
    const VolumeSize around = period(scale);
    const Voxel voxel{wrapped(x, around.width), wrapped(y, around.height), wrapped(z, around.depth)};
    // 24 bits are all that a float in [0, 1) can hold without being rounded up to 1.
    return static_cast<float>(random.bits(voxel, static_cast<std::uint32_t>(channel)) >> 8) * 0x1p-24F;
}

void GeneratorNoise::fill(const Box& box, int scale, int channels, Field& field, JobContext& context) const {
    field.resize(channels, box.size, box.size.width);
    constexpr int kRows = 16;
    const int bands = (box.size.height + kRows - 1) / kRows;
    context.parallel(0, box.size.depth * bands, [&](int task) {
        context.check();
        const int z = task / bands, first = task % bands * kRows;
        for (int y = first; y < std::min(first + kRows, box.size.height); ++y)
            for (int c = 0; c < channels; ++c) {
                float* row = field.row(c, y, z);
                for (int x = 0; x < box.size.width; ++x)
                    row[x] = at(box.x + x, box.y + y, box.z + z, scale, c);
            }
    });
}

} // namespace texloom
