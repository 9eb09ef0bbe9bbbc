#pragma once

#include <cstdint>

namespace texloom {

/// A place in space with whole coordinates.
struct Voxel {
    std::int64_t x = 0, y = 0, z = 0;
};

/// Random numbers by voxel: a pure function of (seed, stream, x, y, z, n), as Random is of a pixel. Philox
/// 4x64-10 of the same paper, whose coordinates have 64 bits, so that endless volumes have numbers
/// everywhere. Its draws and those of Random are independent, for the same seed, too.
class VoxelRandom {
public:
    /// @param stream numbers of one seed in different streams are independent.
    explicit VoxelRandom(std::uint64_t seed, std::uint32_t stream = 0) : m_seed(seed), m_stream(stream) {}

    /// 32 independent bits for draw `n` at a voxel.
    std::uint32_t bits(const Voxel& voxel, std::uint32_t n = 0) const;
    /// A real number in [0, 1), in steps of 2^-32.
    double uniform(const Voxel& voxel, std::uint32_t n = 0) const;
    /// A whole number in [0, count), every one equally likely to within 2^-32 × count. `count` is at least 1.
    std::uint32_t below(std::uint32_t count, const Voxel& voxel, std::uint32_t n = 0) const;
    /// A real number of the normal distribution with mean 0 and variance 1 (Box & Muller 1958), within ±6.8.
    double normal(const Voxel& voxel, std::uint32_t n = 0) const;

private:
    std::uint64_t m_seed;
    std::uint32_t m_stream;
};

} // namespace texloom
