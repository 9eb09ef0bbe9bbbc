#include "core/session/run/companion_stack.h"

#include "core/session/run/run.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>

namespace texloom {

namespace {

/// What was set of the last method's parameter, or its default.
double weightSet(const RecipeStep& step) {
    const Param& param = findMethod(step.method).param(kCompanionWeight);
    const auto found = step.parameters.find(param.name());
    return std::get<double>(
        param.checked(found == step.parameters.end() ? param.defaultFor(0) : found->second));
}

/// Sums over pixels of several images' channels, and of their squares.
struct Moments {
    std::vector<double> sums, squares; ///< by channel
    double pixels = 0;

    void add(const Image& image) {
        sums.resize(static_cast<std::size_t>(image.channels()), 0.0);
        squares.resize(sums.size(), 0.0);
        pixels += static_cast<double>(image.size().area());
        for (int c = 0; c < image.channels(); ++c)
            for (int y = 0; y < image.height(); ++y)
                for (int x = 0; x < image.width(); ++x) {
                    const auto value = static_cast<double>(image(x, y, c));
                    sums[static_cast<std::size_t>(c)] += value;
                    squares[static_cast<std::size_t>(c)] += value * value;
                }
    }

    /// Of the channels together; 0 where all that is left is rounding.
    double variance() const {
        constexpr double kRounding = 1e-9;
        double all = 0;
        for (std::size_t c = 0; c < sums.size(); ++c) {
            const double mean = sums[c] / pixels, own = squares[c] / pixels - mean * mean;
            all += own > kRounding * mean * mean ? own : 0;
        }
        return all;
    }
};

double varianceOf(const std::vector<RunExemplar>& exemplars,
                  const std::function<const Image&(const RunExemplar&)>& picture) {
    Moments moments;
    for (const RunExemplar& exemplar : exemplars)
        moments.add(picture(exemplar));
    return moments.variance();
}

/// By what each companion's values are multiplied.
std::vector<double> factorsOf(const std::vector<RunExemplar>& exemplars, double weight) {
    std::vector<double> variances;
    for (std::size_t i = 0; i < exemplars.front().companions.size(); ++i)
        variances.push_back(varianceOf(exemplars, [i](const RunExemplar& exemplar) -> const Image& {
            return *exemplar.companions[i].image;
        }));
    const double image = varianceOf(
        exemplars, [](const RunExemplar& exemplar) -> const Image& { return *exemplar.image.image; });
    const auto varying = static_cast<double>(
        std::count_if(variances.begin(), variances.end(), [](double variance) { return variance > 0; }));
    std::vector<double> factors;
    for (const double variance : variances)
        factors.push_back(variance > 0 ? std::sqrt(weight * (image > 0 ? image : 1) / (varying * variance))
                                       : 1);
    return factors;
}

Image scaled(const Image& image, double factor) {
    Image made = image;
    for (int c = 0; c < made.channels(); ++c)
        for (int y = 0; y < made.height(); ++y)
            for (int x = 0; x < made.width(); ++x)
                made(x, y, c) *= static_cast<float>(factor);
    return made;
}

} // namespace

CompanionUse companionUse(const RunInput& input) {
    if (input.exemplars.empty() || input.exemplars.front().companions.empty())
        return {};
    const RecipeStep& last = input.steps.back();
    const MethodInfo& info = findMethod(last.method).info();
    if (!info.copiesPixels() || !info.takesExemplars())
        return {.stacked = !info.copiesPixels()};
    const double weight = weightSet(last);
    const bool starts = input.inputs.contains(std::string(kInitialPort)) ||
                        std::any_of(input.steps.begin(), input.steps.end(), [](const RecipeStep& step) {
                            return !findMethod(step.method).info().takesExemplars();
                        });
    if (starts || !(weight > 0))
        return {.inVain = weight > 0};
    return {.stacked = true, .weight = weight};
}

std::vector<std::shared_ptr<const Image>> stackedExemplars(const std::vector<RunExemplar>& exemplars,
                                                           const CompanionUse& use) {
    std::vector<double> factors;
    if (use.weight > 0)
        factors = factorsOf(exemplars, use.weight);
    std::vector<std::shared_ptr<const Image>> stacks;
    for (const RunExemplar& exemplar : exemplars) {
        std::vector<Image> weighed;
        std::vector<ImageView> images = {*exemplar.image.image};
        for (std::size_t i = 0; i < factors.size(); ++i)
            weighed.push_back(scaled(*exemplar.companions[i].image, factors[i]));
        for (std::size_t i = 0; i < exemplar.companions.size(); ++i)
            images.emplace_back(weighed.empty() ? *exemplar.companions[i].image : weighed[i]);
        stacks.push_back(std::make_shared<const Image>(stacked(images)));
    }
    return stacks;
}

std::shared_ptr<const Image> withMeans(const Image& initial, const Image& exemplar) {
    if (initial.channels() >= exemplar.channels())
        return std::make_shared<const Image>(initial);
    Image missing(initial.size(), exemplar.channels() - initial.channels());
    const std::vector<double> means =
        channelMeans(exemplar.view().channelRange(initial.channels(), missing.channels()));
    for (int c = 0; c < missing.channels(); ++c)
        for (int y = 0; y < missing.height(); ++y)
            std::fill_n(missing.plane(c).row(y), missing.width(),
                        static_cast<float>(means[static_cast<std::size_t>(c)]));
    const std::array<ImageView, 2> parts = {initial, missing};
    return std::make_shared<const Image>(stacked(parts));
}

} // namespace texloom
