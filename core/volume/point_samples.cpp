#include "core/volume/point_samples.h"

#include "core/base/at.h"
#include "core/base/error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace texloom {

namespace {

constexpr int kBlockShift = 5; ///< blocks of 32³ points, one voxel more along each axis for what lies between

using BlockPlace = std::array<std::int64_t, 3>;

/// The voxels of a block that lie within the source; the others are 0.
Volume blockOf(const VolumeSource& source, const BlockPlace& place, JobContext& context) {
    constexpr int kSide = (1 << kBlockShift) + 1;
    const Box box{
        place[0] << kBlockShift, place[1] << kBlockShift, place[2] << kBlockShift, {kSide, kSide, kSide}};
    const Box there = source.bounds() ? intersection(box, *source.bounds()) : box;
    if (there == box)
        return source.sample(box, context);
    Volume block(box.size, source.channels());
    if (there.size.empty())
        return block;
    const Volume part = source.sample(there, context);
    for (int c = 0; c < part.channels(); ++c)
        for (int z = 0; z < part.depth(); ++z)
            for (int y = 0; y < part.height(); ++y)
                std::copy_n(part.row(y, z, c), part.width(),
                            block.row(y + static_cast<int>(there.y - box.y),
                                      z + static_cast<int>(there.z - box.z), c) +
                                (there.x - box.x));
    return block;
}

} // namespace

std::vector<float> sampledAt(const VolumeSource& source, std::span<const Eigen::Vector3d> points,
                             JobContext& context) {
    std::map<BlockPlace, std::vector<std::size_t>> blocks;
    for (std::size_t i = 0; i < points.size(); ++i) {
        BlockPlace place{};
        for (int axis = 0; axis < 3; ++axis) {
            const double coordinate = points[i][axis];
            if (!(std::abs(coordinate) < static_cast<double>(Box::kFarthest)))
                failUsage("A point at {} lies too far out; coordinates go from −{} to {}.", coordinate,
                          Box::kFarthest, Box::kFarthest);
            place[at(axis)] = static_cast<std::int64_t>(std::floor(coordinate)) >> kBlockShift;
        }
        blocks[place].push_back(i);
    }
    const int channels = source.channels();
    std::vector<float> values(points.size() * at(channels));
    std::size_t done = 0;
    for (const auto& [place, members] : blocks) {
        context.check();
        const Volume block = blockOf(source, place, context);
        for (const std::size_t i : members) {
            std::array<int, 3> first{};
            std::array<double, 3> share{};
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const double coordinate = points[i][static_cast<int>(axis)], below = std::floor(coordinate);
                first[axis] =
                    static_cast<int>(static_cast<std::int64_t>(below) - (place[axis] << kBlockShift));
                share[axis] = coordinate - below;
            }
            for (int c = 0; c < channels; ++c) {
                double sum = 0;
                for (int corner = 0; corner < 8; ++corner) {
                    const int dx = corner & 1, dy = (corner >> 1) & 1, dz = corner >> 2;
                    const double weight = (dx ? share[0] : 1 - share[0]) * (dy ? share[1] : 1 - share[1]) *
                                          (dz ? share[2] : 1 - share[2]);
                    if (weight > 0)
                        sum += weight *
                               static_cast<double>(block(first[0] + dx, first[1] + dy, first[2] + dz, c));
                }
                values[i * at(channels) + at(c)] = static_cast<float>(sum);
            }
        }
        context.progress(static_cast<double>(++done) / static_cast<double>(blocks.size()));
    }
    return values;
}

} // namespace texloom
