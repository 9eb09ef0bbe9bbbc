// A method that gives a model: means and covariance of the exemplar's channels.

#include "core/base/text.h"
#include "core/io/model_file.h"
#include "core/methods/registry.h"

#include <Eigen/Eigenvalues>

#include <algorithm>

namespace texloom::learn_moments {

namespace {

constexpr const char* kModel = "moments";
constexpr int kRows = 16; ///< between two previews

struct Settings {
    double spread = 1; ///< by which the deviations are multiplied
};

Eigen::VectorXd meanOf(const ImageView& image) {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(image.channels);
    for (int c = 0; c < image.channels; ++c)
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x)
                sum[c] += static_cast<double>(image(x, y, c));
    return sum / (static_cast<double>(image.width) * image.height);
}

Eigen::MatrixXd covarianceOf(const ImageView& image, const Eigen::VectorXd& mean) {
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(image.channels, image.channels);
    Eigen::VectorXd pixel(image.channels);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            for (int c = 0; c < image.channels; ++c)
                pixel[c] = static_cast<double>(image(x, y, c)) - mean[c];
            sum += pixel * pixel.transpose();
        }
    return sum / (static_cast<double>(image.width) * image.height);
}

/// The matrix whose product with its transpose is the covariance.
Eigen::MatrixXd rootOf(const Eigen::MatrixXd& covariance) {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(covariance);
    return solver.eigenvectors() * solver.eigenvalues().cwiseMax(0).cwiseSqrt().asDiagonal();
}

std::shared_ptr<const Model> learned(const ImageView& image, double spread) {
    const Eigen::VectorXd mean = meanOf(image);
    const Eigen::MatrixXd root = spread * rootOf(covarianceOf(image, mean));
    auto model = std::make_shared<Model>();
    model->kind = kModel;
    const std::int64_t channels = image.channels;
    model->arrays["mean"] = {{channels}, std::vector<double>(mean.begin(), mean.end())};
    model->arrays["root"] = {{channels, channels},
                             std::vector<double>(root.data(), root.data() + root.size())};
    return model;
}

/// The exemplar, repeated, shows what was learned from.
Synthesis run(const Request& request, const Settings& settings, JobContext& context) {
    const ImageView exemplar = *request.exemplars.front().image;
    context.stage(1, TR("Measuring colours"));
    Synthesis made;
    made.outputs.add(kModel, learned(exemplar, settings.spread));
    made.image = Image(request.size, request.channels());
    for (int begin = 0; begin < request.size.height; begin += kRows) {
        const int end = std::min(request.size.height, begin + kRows);
        context.parallel(begin, end, [&](int y) {
            for (int c = 0; c < exemplar.channels; ++c)
                for (int x = 0; x < request.size.width; ++x)
                    made.image(x, y, c) = exemplar(x % exemplar.width, y % exemplar.height, c);
        });
        context.preview(made.image);
        context.progress(static_cast<double>(end) / request.size.height);
    }
    return made;
}

Estimate estimate(const Request& request, const Settings&, int) {
    return {Image::bytesFor(request.size, request.channels()) + (1U << 20U),
            1e-8 * static_cast<double>(request.size.area())};
}

} // namespace

const Method self = method<Settings>(
    {.title = TR("Learn colour moments"),
     .summary = TR("Measures means and covariance of the exemplar's colours, and repeats the exemplar."),
     .citation = "None: an example that gives a model",
     .category = Category::Statistics,
     .takes = {ports::exemplar()},
     .gives = {ports::image(),
               {.id = kModel,
                .title = TR("Colour moments"),
                .help = TR("Means and covariance of the exemplar's colours."),
                .kind = AssetKind::Model,
                .least = 1}},
     .usesSeed = false},
    {field(&Settings::spread, "spread", TR("Spread"))
         .range(0, 10)
         .help(TR("By how much deviations from the mean are multiplied: 0 leaves the mean alone."))},
    run, [](const Request&, const Settings&) {}, estimate);

namespace {
const Registration registered("learn-moments", self);
}

} // namespace texloom::learn_moments
