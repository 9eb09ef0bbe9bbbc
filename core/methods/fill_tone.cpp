#include "core/methods/fill_tone.h"

#include "core/base/text.h"
#include "core/math/poisson.h"
#include "core/methods/fill_request.h"
#include "core/methods/patch_request.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace texloom {

namespace {

constexpr std::array<std::pair<int, int>, 4> kNeighbours{{{-1, 0}, {1, 0}, {0, -1}, {0, 1}}};
/// Of a hole's border so many per cent miss by tone alone; a miss of more than so many times the largest of
/// these is something else that lies there, which would stain all around if it were evened out.
constexpr std::size_t kUsualShare = 75;
constexpr float kUsualFactor = 2;
/// What is evened out in any case, as a share of the range.
constexpr float kLeastLimit = 4.0F / 255;

/// Steps between neighbours of which one at least is a copy.
class CopiedSteps {
public:
    CopiedSteps(const CopiedPixels& copied, const PositionMap& map, const ImageView& image)
        : m_copied(copied), m_map(map), m_image(image) {}

    /// A pixel and the direction to its neighbour.
    struct Edge {
        int x, y, dx, dy;
    };
    bool lies(const Edge& edge) const {
        const int x = edge.x + edge.dx, y = edge.y + edge.dy;
        return x >= 0 && y >= 0 && x < m_image.width && y < m_image.height;
    }
    bool known(int x, int y) const { return !m_copied.isMade(x, y, m_image.width); }
    /// The step as the exemplars have it: the mean where both pixels are copies.
    float wanted(const Edge& edge, int channel) const;
    /// How far the step in the picture is from that, over all channels.
    float miss(const Edge& edge) const;
    /// The step that the result is to have: as wanted, but no further from the picture's than the limit.
    float limited(const Edge& edge, int channel, float limit) const;
    /// A limit that misses of tone seldom exceed, unlike those where something else lies.
    float limit(const std::function<void()>& check) const;

private:
    float step(const Edge& edge, int channel) const {
        return m_image(edge.x + edge.dx, edge.y + edge.dy, channel) - m_image(edge.x, edge.y, channel);
    }

    const CopiedPixels& m_copied;
    const PositionMap& m_map;
    const ImageView m_image; ///< with the copies
};

float CopiedSteps::wanted(const Edge& edge, int channel) const {
    float sum = 0;
    int count = 0;
    const auto add = [&](int u, int v, int sign) {
        if (known(u, v))
            return;
        const Source& source = m_map.at(u, v);
        const ImageView& exemplar = m_copied.exemplars[source.exemplar].image;
        const int toX = source.x + sign * edge.dx, toY = source.y + sign * edge.dy;
        if (toX < 0 || toY < 0 || toX >= exemplar.width || toY >= exemplar.height)
            return;
        const PlaneView& mask = m_copied.exemplars[source.exemplar].mask;
        if (mask.data && mask(toX, toY) == 0) // a difference to what is not to be seen
            return;
        sum +=
            static_cast<float>(sign) * (exemplar(toX, toY, channel) - exemplar(source.x, source.y, channel));
        ++count;
    };
    add(edge.x, edge.y, 1);
    add(edge.x + edge.dx, edge.y + edge.dy, -1);
    return count > 0 ? sum / static_cast<float>(count) : 0;
}

float CopiedSteps::miss(const Edge& edge) const {
    float sum = 0;
    for (int c = 0; c < m_image.channels; ++c) {
        const float apart = step(edge, c) - wanted(edge, c);
        sum += apart * apart;
    }
    return std::sqrt(sum);
}

float CopiedSteps::limited(const Edge& edge, int channel, float limit) const {
    const float whole = miss(edge), goal = wanted(edge, channel);
    if (whole <= limit)
        return goal;
    const float now = step(edge, channel);
    return now + (goal - now) * limit / whole;
}

float CopiedSteps::limit(const std::function<void()>& check) const {
    std::vector<float> misses;
    for (int y = 0; y < m_image.height; ++y) {
        check();
        for (int x = 0; x < m_image.width; ++x)
            for (const auto& [dx, dy] : kNeighbours)
                if (const Edge edge{x, y, dx, dy}; !known(x, y) && lies(edge) && known(x + dx, y + dy))
                    misses.push_back(miss(edge));
    }
    if (misses.empty())
        return std::numeric_limits<float>::infinity();
    const auto usual = misses.begin() + static_cast<std::ptrdiff_t>(misses.size() * kUsualShare / 100);
    std::nth_element(misses.begin(), usual, misses.end());
    const ValueRange range = valueRange(m_image);
    return std::max(kUsualFactor * *usual, kLeastLimit * (range.largest - range.smallest));
}

} // namespace

void evenTone(const CopiedPixels& copied, const PositionMap& map, Image& image,
              const std::function<void(double)>& progress) {
    const CopiedSteps steps(copied, map, image);
    const float limit = steps.limit([&progress] { progress(0); });
    std::vector<float> divergence;
    for (int c = 0; c < image.channels(); ++c)
        for (int y = 0; y < image.height(); ++y) {
            progress(0);
            for (int x = 0; x < image.width(); ++x) {
                if (!copied.isMade(x, y, image.width()))
                    continue;
                float sum = 0;
                for (const auto& [dx, dy] : kNeighbours)
                    if (const CopiedSteps::Edge edge{x, y, dx, dy}; steps.lies(edge))
                        sum += steps.limited(edge, c, limit);
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
