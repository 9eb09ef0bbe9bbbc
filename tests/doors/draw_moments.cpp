// A method that takes a model and no exemplar: pixels drawn independently with the means and covariance that
// were learned.

#include "core/base/text.h"
#include "core/io/model_file.h"
#include "core/methods/registry.h"

#include <algorithm>

namespace texloom::draw_moments {

namespace {

constexpr const char* kModel = "moments";
constexpr int kRows = 16; ///< between two previews
constexpr std::int64_t kMostChannels = 64;

struct Settings {
    double blend = 0; ///< share of the mean, which evens the result out
};

/// What the model holds for images of so many channels.
struct Moments {
    Moments(const Model& model, std::int64_t channels)
        : mean(model.values<double>("mean", {channels})),
          root(model.values<double>("root", {channels, channels})) {}
    const std::vector<double>& mean;
    const std::vector<double>& root; ///< column by column
};

/// As many as the model has means; 0 where it is still to be made, or cannot say.
int channels(const Request& request, const Settings&) {
    const auto model = request.inputs.first<Model>(kModel);
    if (!model || !model->arrays.contains("mean") || model->arrays.at("mean").shape.size() != 1)
        return 0;
    return static_cast<int>(std::min(model->arrays.at("mean").shape.front(), kMostChannels));
}

void check(const Request& request, const Settings&) {
    // Where another method makes the model, it is not there before the run.
    if (const auto model = request.inputs.first<Model>(kModel))
        Moments(*model, request.channels());
}

void drawRow(const Moments& moments, const Random& random, double share, int y, Image& image) {
    const auto channels = static_cast<std::size_t>(image.channels());
    std::vector<double> normals(channels);
    for (int x = 0; x < image.width(); ++x) {
        for (std::size_t c = 0; c < channels; ++c)
            normals[c] = random.normal(x, y, static_cast<std::uint32_t>(c));
        for (std::size_t c = 0; c < channels; ++c) {
            double value = moments.mean[c];
            for (std::size_t k = 0; k < channels; ++k)
                value += share * moments.root[k * channels + c] * normals[k];
            image(x, y, static_cast<int>(c)) = static_cast<float>(value);
        }
    }
}

Synthesis run(const Request& request, const Settings& settings, JobContext& context) {
    const std::shared_ptr<const Model> model = request.inputs.first<Model>(kModel);
    const Moments moments(*model, request.channels());
    context.stage(1, TR("Drawing colours"));
    Synthesis made;
    made.image = Image(request.size, request.channels());
    for (int begin = 0; begin < request.size.height; begin += kRows) {
        const int end = std::min(request.size.height, begin + kRows);
        context.parallel(begin, end, [&](int y) {
            drawRow(moments, context.random(), 1 - settings.blend, y, made.image);
        });
        context.preview(made.image);
        context.progress(static_cast<double>(end) / request.size.height);
    }
    return made;
}

Estimate estimate(const Request& request, const Settings&, int) {
    return {Image::bytesFor(request.size, request.channels()) + (1U << 20U),
            5e-8 * static_cast<double>(request.size.area()) * request.channels()};
}

} // namespace

const Method self = method<Settings>(
    {.title = TR("Draw colour moments"),
     .summary = TR("Draws each pixel for itself with the means and covariance of a model."),
     .citation = "None: an example that takes a model",
     .category = Category::Statistics,
     .takes = {{.id = kModel,
                .title = TR("Colour moments"),
                .help = TR("Means and covariance of colours, as Learn colour moments gives them."),
                .kind = AssetKind::Model,
                .least = 1}},
     .gives = {ports::image()}},
    {field(&Settings::blend, "blend", TR("Blend"))
         .range(0, 1)
         .help(TR("Share of the mean in every pixel: 0 draws as learned, 1 gives one even colour."))},
    run, check, estimate, channels);

namespace {
const Registration registered("draw-moments", self);
}

} // namespace texloom::draw_moments
