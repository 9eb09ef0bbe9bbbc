#pragma once

#include <cstdint>
#include <string>

namespace texloom {

/// Width, height and depth in voxels.
struct VolumeSize {
    int width = 0;
    int height = 0;
    int depth = 0;

    bool empty() const { return width <= 0 || height <= 0 || depth <= 0; }
    /// Number of voxels; the largest number there is where that does not fit.
    std::int64_t voxels() const;
    friend bool operator==(const VolumeSize&, const VolumeSize&) = default;
};

/// "64 × 64 × 32".
std::string sizeText(const VolumeSize& size);

/// Voxels in space: the one with the smallest coordinates, which may be negative, and how many there are
/// along x (to the right), y (down) and z (away).
struct Box {
    std::int64_t x = 0;
    std::int64_t y = 0;
    std::int64_t z = 0;
    VolumeSize size;

    /// No coordinate lies further from 0, so that sums never overflow and are exact as double, too.
    static constexpr std::int64_t kFarthest = std::int64_t{1} << 40;

    /// The coordinates behind the last voxel.
    std::int64_t endX() const { return x + size.width; }
    std::int64_t endY() const { return y + size.height; }
    std::int64_t endZ() const { return z + size.depth; }
    /// Whether it has voxels, all of them in `whole`.
    bool within(const Box& whole) const;
    /// @throws UsageError if it has no voxels or lies further from 0 than kFarthest.
    void check() const;
    friend bool operator==(const Box&, const Box&) = default;
};

/// The voxels that both have; an empty size if there are none.
Box intersection(const Box& a, const Box& b);

/// "x 0 to 63, y −8 to 55, z 0 to 0": the first and the last voxel along each axis.
std::string boxText(const Box& box);

} // namespace texloom
