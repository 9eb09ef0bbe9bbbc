#include "core/generator/generator_noise.h"

#include "core/job/voxel_random.h"

namespace texloom {

namespace {

/// Streams of numbers that nothing else draws from: one for each scale.
constexpr std::uint32_t kFirstStream = 0x67656E00;

std::int64_t wrapped(std::int64_t place, int period, int scale) {
    const std::int64_t length = period >> scale;
    if (length <= 0)
        return place;
    const std::int64_t rest = place % length;
    return rest < 0 ? rest + length : rest;
}

} // namespace

float GeneratorNoise::at(std::int64_t x, std::int64_t y, std::int64_t z, int scale, int channel) const {
    const VoxelRandom random(m_seed, kFirstStream + static_cast<std::uint32_t>(scale));
    const Voxel voxel{wrapped(x, m_period.width, scale), wrapped(y, m_period.height, scale),
                      wrapped(z, m_period.depth, scale)};
    // 24 bits are all that a float in [0, 1) can hold without being rounded up to 1.
    return static_cast<float>(random.bits(voxel, static_cast<std::uint32_t>(channel)) >> 8) * 0x1p-24F;
}

void GeneratorNoise::fill(const Box& box, int scale, int channels, Field& field, JobContext& context) const {
    field.resize(channels, box.size, box.size.width);
    context.parallel(0, box.size.depth, [&](int z) {
        for (int y = 0; y < box.size.height; ++y) {
            if (y % 16 == 0)
                context.check();
            for (int c = 0; c < channels; ++c) {
                float* row = field.row(c, y, z);
                for (int x = 0; x < box.size.width; ++x)
                    row[x] = at(box.x + x, box.y + y, box.z + z, scale, c);
            }
        }
    });
}

} // namespace texloom
