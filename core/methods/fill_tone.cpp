#include "core/methods/fill_tone.h"

#include "core/base/text.h"
#include "core/math/poisson.h"
#include "core/methods/fill_request.h"
#include "core/methods/patch_request.h"

#include <array>
#include <utility>

namespace texloom {

namespace {

/// From a pixel to its neighbour, as the exemplars have it where one or both are copies: the mean of both.
float copiedGradient(const CopiedPixels& copied, const PositionMap& map, std::array<int, 2> from,
                     std::array<int, 2> step, int channel) {
    float sum = 0;
    int count = 0;
    const auto add = [&](int u, int v, int sign) {
        if (!copied.isMade(u, v, map.width()))
            return;
        const Source& source = map.at(u, v);
        const ImageView& exemplar = copied.exemplars[source.exemplar].image;
        const int toX = source.x + sign * step[0], toY = source.y + sign * step[1];
        if (toX < 0 || toY < 0 || toX >= exemplar.width || toY >= exemplar.height)
            return;
        const PlaneView& mask = copied.exemplars[source.exemplar].mask;
        if (mask.data && mask(toX, toY) == 0) // a difference to what is not to be seen
            return;
        sum +=
            static_cast<float>(sign) * (exemplar(toX, toY, channel) - exemplar(source.x, source.y, channel));
        ++count;
    };
    add(from[0], from[1], 1);
    add(from[0] + step[0], from[1] + step[1], -1);
    return count > 0 ? sum / static_cast<float>(count) : 0;
}

} // namespace

void evenTone(const CopiedPixels& copied, const PositionMap& map, Image& image,
              const std::function<void(double)>& progress) {
    std::vector<float> divergence;
    for (int c = 0; c < image.channels(); ++c)
        for (int y = 0; y < image.height(); ++y) {
            progress(0);
            for (int x = 0; x < image.width(); ++x) {
                if (!copied.isMade(x, y, image.width()))
                    continue;
                float sum = 0;
                for (const auto& [dx, dy] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}})
                    if (x + dx >= 0 && y + dy >= 0 && x + dx < image.width() && y + dy < image.height())
                        sum += copiedGradient(copied, map, {x, y}, {dx, dy}, c);
                divergence.push_back(sum);
            }
        }
    solvePoisson(copied.made, divergence, image, progress);
}

void evenFilledTone(const Request& hidden, double weight, JobContext& context, Synthesis& result) {
    context.stage(weight, TR("Evening tone"));
    const std::vector<PatchSource> sources = patchSources(hidden);
    const std::vector<std::uint8_t> made = madeOf(*knownOf(hidden));
    evenTone({sources, made, hidden.wrap}, result.map, result.image, [&context](double share) {
        context.check();
        context.progress(share);
    });
    result.mapKind = MapKind::Dominant;
}

std::uint64_t toneBytes(const Request& request) {
    return regionPoissonBytes(static_cast<std::uint64_t>(unknownPixels(request)), request.channels()) +
           static_cast<std::uint64_t>(request.size.area());
}

} // namespace texloom
