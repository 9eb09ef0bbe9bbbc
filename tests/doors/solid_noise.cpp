// A method that gives a volume without end, which is made where someone looks.

#include "core/base/text.h"
#include "core/job/voxel_random.h"
#include "core/methods/registry.h"
#include "core/volume/volume_source.h"

#include <algorithm>
#include <cmath>

namespace texloom::solid_noise {

namespace {

constexpr const char* kVolume = "volume";
constexpr int kRows = 16; ///< between two previews

struct Settings {
    double strength = 1; ///< by which the exemplar's deviations are multiplied
};

/// Independent numbers with each channel's mean and deviation, by place alone.
class Noise : public VolumeSource {
public:
    Noise(const ImageView& exemplar, double strength, std::uint64_t seed)
        : m_means(channelMeans(exemplar)), m_random(seed) {
        for (int c = 0; c < exemplar.channels; ++c)
            m_deviations.push_back(strength * deviation(exemplar, c));
    }
    int channels() const override { return static_cast<int>(m_means.size()); }

private:
    double deviation(const ImageView& image, int c) const {
        double sum = 0;
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x)
                sum +=
                    std::pow(static_cast<double>(image(x, y, c)) - m_means[static_cast<std::size_t>(c)], 2);
        return std::sqrt(sum / (static_cast<double>(image.width) * image.height));
    }

    void fill(const Box& box, Volume& volume, JobContext& context) const override {
        context.parallel(0, box.size.depth * box.size.height, [&](int row) {
            const int y = row % box.size.height, z = row / box.size.height;
            for (int c = 0; c < volume.channels(); ++c)
                for (int x = 0; x < box.size.width; ++x)
                    volume(x, y, z, c) = at({box.x + x, box.y + y, box.z + z}, c);
        });
    }

    float at(const Voxel& voxel, int c) const {
        const auto channel = static_cast<std::size_t>(c);
        return static_cast<float>(
            m_means[channel] + m_deviations[channel] * m_random.normal(voxel, static_cast<std::uint32_t>(c)));
    }

    std::vector<double> m_means, m_deviations;
    VoxelRandom m_random;
};

/// The result's picture is the slice at z = 0.
Synthesis run(const Request& request, const Settings& settings, JobContext& context) {
    const auto source = std::make_shared<const Noise>(request.exemplars.front().image->view(),
                                                      settings.strength, request.seed);
    context.stage(1, TR("Cutting a slice"));
    Synthesis made;
    made.outputs.add(kVolume, source);
    made.image = Image(request.size, request.channels());
    for (int begin = 0; begin < request.size.height; begin += kRows) {
        const int rows = std::min(kRows, request.size.height - begin);
        const Volume slab = source->sample({0, begin, 0, {request.size.width, rows, 1}}, context);
        for (int c = 0; c < slab.channels(); ++c)
            for (int y = 0; y < rows; ++y)
                std::copy_n(slab.row(y, 0, c), slab.width(), made.image.plane(c).row(begin + y));
        context.preview(made.image);
        context.progress(static_cast<double>(begin + rows) / request.size.height);
    }
    return made;
}

Estimate estimate(const Request& request, const Settings&, int) {
    return {Image::bytesFor(request.size, request.channels()) +
                Volume::bytesFor({request.size.width, kRows, 1}, request.channels()) + (1U << 20U),
            1e-7 * static_cast<double>(request.size.area()) * request.channels()};
}

} // namespace

const Method self = method<Settings>(
    {.title = TR("Solid noise"),
     .summary = TR("Fills space with independent colours, as bright and as varied as the exemplar's."),
     .citation = "None: an example that gives a volume",
     .category = Category::Solids,
     .takes = {ports::exemplar()},
     .gives = {ports::image(),
               {.id = kVolume,
                .title = TR("Volume"),
                .help = TR("The noise in space, without end; the picture is its slice at z = 0."),
                .kind = AssetKind::Volume,
                .least = 1}}},
    {field(&Settings::strength, "strength", TR("Strength"))
         .range(0, 10)
         .help(TR("By how much deviations from the mean are multiplied: 0 leaves the mean alone."))},
    run, [](const Request&, const Settings&) {}, estimate);

namespace {
const Registration registered("solid-noise", self);
}

} // namespace texloom::solid_noise
