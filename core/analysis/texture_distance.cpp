#include "core/analysis/texture_distance.h"

#include "core/base/at.h"
#include "core/job/random.h"
#include "core/math/pca.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace texloom {

namespace {

constexpr int kPatch = 8;
constexpr int kPatches = 2048;
constexpr int kPixels = 1 << 16;
constexpr int kBins = 64;
constexpr int kSlices = 32;
/// Patches are compared in at most this many channels.
constexpr int kChannels = 4;
/// Patches that the principal axes are learnt from.
constexpr std::size_t kLearnt = 1024;
/// Samples that one thread takes at a time.
constexpr int kBlock = 128;
/// The same places for every run, so that a figure depends on the images alone.
constexpr std::uint64_t kSeed = 1;

/// One of several images, drawn by area, and a place in it where a square of `side` px begins.
struct DrawnPlace {
    const ImageView* image;
    int x, y;
};

class DrawnPlaces {
public:
    DrawnPlaces(std::span<const ImageView> images, std::uint32_t stream)
        : m_images(images), m_random(kSeed, stream) {
        for (const ImageView& image : images)
            m_pixels += image.size().area();
    }
    DrawnPlace place(int number, int side) const {
        auto n = static_cast<std::int64_t>(m_random.uniform(number, 0) * static_cast<double>(m_pixels));
        const ImageView* image = m_images.data();
        for (; n >= image->size().area(); ++image)
            n -= image->size().area();
        const auto draw = [&](int length, std::uint32_t which) {
            return static_cast<int>(
                m_random.below(static_cast<std::uint32_t>(length - side + 1), number, 1, which));
        };
        return {image, draw(image->width, 0), draw(image->height, 1)};
    }

private:
    std::span<const ImageView> m_images;
    Random m_random;
    std::int64_t m_pixels = 0;
};

/// Patches at random places, one after another, each sample the mean of `scale` × `scale` pixels.
struct Samples {
    int dimension = 0;
    std::vector<float> values;

    int count() const { return static_cast<int>(values.size()) / dimension; }
    const float* patch(int number) const { return values.data() + at(number) * at(dimension); }
};

void readPatch(const DrawnPlace& place, int patch, int scale, int channels, float* to) {
    for (int c = 0; c < channels; ++c)
        for (int y = 0; y < patch; ++y)
            for (int x = 0; x < patch; ++x, ++to) {
                float sum = 0;
                for (int v = 0; v < scale; ++v) {
                    const float* row =
                        place.image->plane(c).row(place.y + y * scale + v) + place.x + x * scale;
                    for (int u = 0; u < scale; ++u)
                        sum += row[u];
                }
                *to = sum / static_cast<float>(scale * scale);
            }
}

Samples samplePatches(std::span<const ImageView> images, int patch, int scale, JobContext& context) {
    const int channels = std::min(images.front().channels, kChannels);
    Samples samples{patch * patch * channels, {}};
    samples.values.resize(at(kPatches) * at(samples.dimension));
    const DrawnPlaces places(images, static_cast<std::uint32_t>(scale));
    context.parallel(0, kPatches / kBlock, [&](int block) {
        for (int n = block * kBlock; n < (block + 1) * kBlock; ++n)
            readPatch(places.place(n, patch * scale), patch, scale, channels,
                      samples.values.data() + at(n) * at(samples.dimension));
    });
    return samples;
}

std::vector<float> projected(const Samples& samples, std::span<const float> axis) {
    std::vector<float> values;
    values.reserve(at(samples.count()));
    for (int n = 0; n < samples.count(); ++n) {
        const float* patch = samples.patch(n);
        constexpr int kLanes = 8;
        float lanes[kLanes] = {};
        int i = 0;
        for (; i + kLanes <= samples.dimension; i += kLanes)
            for (int lane = 0; lane < kLanes; ++lane)
                lanes[lane] += patch[i + lane] * axis[at(i + lane)];
        float sum = 0;
        for (; i < samples.dimension; ++i)
            sum += patch[i] * axis[at(i)];
        for (const float lane : lanes)
            sum += lane;
        values.push_back(sum);
    }
    return values;
}

/// Half the L1 distance of two histograms whose bins are quantiles of the first set of values.
double histogramDistance(std::vector<float> exemplar, const std::vector<float>& result) {
    std::sort(exemplar.begin(), exemplar.end());
    std::vector<float> edges;
    for (int i = 1; i < kBins; ++i)
        edges.push_back(exemplar[exemplar.size() * at(i) / kBins]);
    std::array<double, kBins> difference{};
    const auto count = [&](const std::vector<float>& values, double sign) {
        for (const float value : values) {
            const auto bin = std::upper_bound(edges.begin(), edges.end(), value) - edges.begin();
            difference[static_cast<std::size_t>(bin)] += sign / static_cast<double>(values.size());
        }
    };
    count(exemplar, 1);
    count(result, -1);
    double sum = 0;
    for (const double share : difference)
        sum += std::abs(share);
    return sum / 2;
}

std::vector<float> samplePixels(std::span<const ImageView> images, int channel) {
    std::vector<float> values;
    values.reserve(kPixels);
    const DrawnPlaces places(images, 0);
    for (int n = 0; n < kPixels; ++n) {
        const DrawnPlace place = places.place(n, 1);
        values.push_back((*place.image)(place.x, place.y, channel));
    }
    return values;
}

double colorDistance(std::span<const ImageView> result, std::span<const ImageView> exemplars,
                     JobContext& context) {
    const int channels = result.front().channels;
    std::vector<double> distances(at(channels));
    context.parallel(0, channels, [&](int c) {
        distances[at(c)] = histogramDistance(samplePixels(exemplars, c), samplePixels(result, c));
    });
    double sum = 0;
    for (const double distance : distances)
        sum += distance;
    return sum / channels;
}

std::array<double, 2> componentDistances(const Samples& exemplar, const Samples& result) {
    const std::vector<double> learnt(exemplar.values.begin(),
                                     exemplar.values.begin() +
                                         static_cast<std::ptrdiff_t>(kLearnt * at(exemplar.dimension)));
    const PrincipalAxes principal =
        principalAxes(learnt, exemplar.dimension, std::min(2, exemplar.dimension));
    std::array<double, 2> distances{};
    for (int a = 0; a < principal.count(); ++a) {
        const std::vector<float> axis(principal.axis(a).begin(), principal.axis(a).end());
        distances[at(a)] = histogramDistance(projected(exemplar, axis), projected(result, axis));
    }
    return distances;
}

/// A random direction of length 1.
std::vector<float> direction(int number, int dimension) {
    const Random random(kSeed, 1000);
    std::vector<float> axis;
    double square = 0;
    for (int i = 0; i < dimension; ++i) {
        axis.push_back(static_cast<float>(random.normal(i, number)));
        square += static_cast<double>(axis.back() * axis.back());
    }
    for (float& value : axis)
        value /= static_cast<float>(std::sqrt(square));
    return axis;
}

double slicedWasserstein(const Samples& a, const Samples& b, JobContext& context) {
    std::vector<double> distances(kSlices);
    context.parallel(0, kSlices, [&](int number) {
        const std::vector<float> axis = direction(number, a.dimension);
        std::vector<float> first = projected(a, axis), second = projected(b, axis);
        std::sort(first.begin(), first.end());
        std::sort(second.begin(), second.end());
        double sum = 0;
        for (std::size_t i = 0; i < first.size(); ++i)
            sum += static_cast<double>(std::abs(first[i] - second[i]));
        distances[at(number)] = sum / static_cast<double>(first.size());
    });
    double sum = 0;
    for (const double distance : distances)
        sum += distance;
    return sum / kSlices;
}

double deviation(const Samples& samples) {
    double sum = 0, square = 0;
    for (const float value : samples.values) {
        sum += static_cast<double>(value);
        square += static_cast<double>(value) * static_cast<double>(value);
    }
    const auto count = static_cast<double>(samples.values.size());
    return std::sqrt(std::max(0.0, square / count - sum / count * (sum / count)));
}

} // namespace

TextureDistance textureDistance(const ImageView& result, std::span<const ImageView> exemplars,
                                JobContext& context) {
    const std::span<const ImageView> results(&result, 1);
    int shortest = result.size().shorterSide();
    for (const ImageView& exemplar : exemplars)
        shortest = std::min(shortest, exemplar.size().shorterSide());
    const int patch = std::min(kPatch, shortest);
    TextureDistance distance;
    distance.color = colorDistance(results, exemplars, context);
    double unit = 0;
    for (int s = 0; s < TextureDistance::kScales && (patch << s) <= shortest; ++s) {
        const Samples ours = samplePatches(results, patch, 1 << s, context);
        const Samples theirs = samplePatches(exemplars, patch, 1 << s, context);
        if (s == 0) {
            distance.components = componentDistances(theirs, ours);
            unit = deviation(theirs);
        }
        const double moved = slicedWasserstein(ours, theirs, context);
        distance.wasserstein[at(s)] = unit > 0 ? moved / unit : moved;
    }
    return distance;
}

} // namespace texloom
