#include "core/job/voxel_random.h"

#include <Random123/philox.h>

#include <cmath>
#include <numbers>

namespace texloom {

std::uint32_t VoxelRandom::bits(const Voxel& voxel, std::uint32_t n) const {
    using Generator = r123::Philox4x64;
    const Generator::ctr_type counter = {{static_cast<std::uint64_t>(voxel.x),
                                          static_cast<std::uint64_t>(voxel.y),
                                          static_cast<std::uint64_t>(voxel.z), n / 8}};
    const Generator::key_type key = {{m_seed, m_stream}};
    const std::uint64_t word = Generator{}(counter, key)[n / 2 % 4];
    return static_cast<std::uint32_t>(n % 2 == 0 ? word : word >> 32);
}

double VoxelRandom::uniform(const Voxel& voxel, std::uint32_t n) const {
    return bits(voxel, n) * 0x1p-32;
}

std::uint32_t VoxelRandom::below(std::uint32_t count, const Voxel& voxel, std::uint32_t n) const {
    return static_cast<std::uint32_t>((static_cast<std::uint64_t>(bits(voxel, n)) * count) >> 32);
}

double VoxelRandom::normal(const Voxel& voxel, std::uint32_t n) const {
    const double radius = std::sqrt(-2 * std::log((bits(voxel, 2 * n) + 0.5) * 0x1p-32));
    return radius * std::cos(2 * std::numbers::pi * uniform(voxel, 2 * n + 1));
}

} // namespace texloom
