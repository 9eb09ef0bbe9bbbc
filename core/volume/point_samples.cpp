#include "core/volume/point_samples.h"

#include "core/base/at.h"
#include "core/volume/point_blocks.h"

namespace texloom {

std::vector<float> sampledAt(const VolumeSource& source, std::span<const Eigen::Vector3d> points,
                             JobContext& context) {
    const auto blocks = blocksOf(points);
    const std::size_t channels = at(source.channels());
    std::vector<float> values(points.size() * channels);
    std::size_t done = 0;
    for (const auto& [place, members] : blocks) {
        context.check();
        const Volume block = blockOf(source, place, context);
        for (const std::size_t i : members)
            interpolate(block, place, points[i], values.data() + i * channels);
        context.progress(static_cast<double>(++done) / static_cast<double>(blocks.size()));
    }
    return values;
}

} // namespace texloom
