#include "core/volume/point_blocks.h"

#include "core/base/at.h"
#include "core/base/error.h"

#include <algorithm>
#include <cmath>

namespace texloom {

Box boxOf(const BlockPlace& place) {
    constexpr int kSide = kBlockSide + 1;
    return {place[0] * kBlockSide, place[1] * kBlockSide, place[2] * kBlockSide, {kSide, kSide, kSide}};
}

std::map<BlockPlace, std::vector<std::size_t>> blocksOf(std::span<const Eigen::Vector3d> points) {
    std::map<BlockPlace, std::vector<std::size_t>> blocks;
    auto last = blocks.end(); // neighbours lie mostly in one block
    for (std::size_t i = 0; i < points.size(); ++i) {
        BlockPlace place{};
        for (int axis = 0; axis < 3; ++axis) {
            const double coordinate = points[i][axis];
            if (!(std::abs(coordinate) < static_cast<double>(Box::kFarthest)))
                failUsage("A point at {} lies too far out; coordinates go from −{} to {}.", coordinate,
                          Box::kFarthest, Box::kFarthest);
            place[at(axis)] = static_cast<std::int64_t>(std::floor(coordinate / kBlockSide));
        }
        if (last == blocks.end() || last->first != place)
            last = blocks.try_emplace(place).first;
        last->second.push_back(i);
    }
    return blocks;
}

Volume blockOf(const VolumeSource& source, const BlockPlace& place, JobContext& context) {
    const Box box = boxOf(place);
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

void interpolate(const Volume& block, const BlockPlace& place, const Eigen::Vector3d& point, float* to) {
    std::array<int, 3> first{};
    std::array<double, 3> share{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double coordinate = point[static_cast<int>(axis)], below = std::floor(coordinate);
        first[axis] = static_cast<int>(static_cast<std::int64_t>(below) - place[axis] * kBlockSide);
        share[axis] = coordinate - below;
    }
    for (int c = 0; c < block.channels(); ++c) {
        double sum = 0;
        for (int corner = 0; corner < 8; ++corner) {
            const int dx = corner & 1, dy = (corner >> 1) & 1, dz = corner >> 2;
            const double weight = (dx ? share[0] : 1 - share[0]) * (dy ? share[1] : 1 - share[1]) *
                                  (dz ? share[2] : 1 - share[2]);
            if (weight > 0)
                sum += weight * static_cast<double>(block(first[0] + dx, first[1] + dy, first[2] + dz, c));
        }
        to[c] = static_cast<float>(sum);
    }
}

} // namespace texloom
