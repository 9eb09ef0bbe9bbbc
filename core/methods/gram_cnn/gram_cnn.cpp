#include "core/base/error.h"
#include "core/base/text.h"
#include "core/match/exemplar_pyramid.h"
#include "core/methods/gram_cnn/minimiser.h"
#include "core/methods/gram_cnn/synthesizer.h"
#include "core/methods/patch_request.h"
#include "core/network/descriptor_learning.h"

#include <algorithm>
#include <cmath>

namespace texloom::gram_cnn {

TextureLossOptions Settings::lossOptions(const Descriptor& used) const {
    TextureLossOptions options;
    options.statistic = statistic;
    options.levels = levels > 0 ? levels : used.levels;
    options.pooling = poolingOf(pooling);
    options.firstTap = firstTap - 1;
    options.lastTap = lastTap - 1;
    options.colours = colours;
    options.variation = variation;
    return options;
}

namespace {

void check(const Request& request, const Settings& settings) {
    checkDescriptor(request, settings.descriptor);
    const Descriptor descriptor = plannedDescriptor(request, settings.descriptor);
    const int taps = static_cast<int>(descriptor.taps().size());
    if (settings.firstTap > taps)
        failUsage(TR("The first tap is {}, and the descriptor has {}: {}."), settings.firstTap, taps,
                  listOf(descriptor.taps()));
    if (settings.firstTap > settings.lastTap)
        failUsage(TR("The first tap is {}, which comes after the last, {}."), settings.firstTap,
                  settings.lastTap);
    const int least = TextureLoss::leastSide(descriptor, settings.lossOptions(descriptor).levels);
    for (const Size& size : request.exemplarSizes())
        if (std::min(size.width, size.height) < least)
            failUsage(TR("An exemplar of {}×{} px is too small for the network, which needs {} px a side."),
                      size.width, size.height, least);
}

Estimate estimate(const Request& request, const Settings& settings, int threads) {
    const Descriptor descriptor = plannedDescriptor(request, settings.descriptor);
    const TextureLossOptions options = settings.lossOptions(descriptor);
    const Size canvas = canvasAt(request, 0);
    auto area = static_cast<std::uint64_t>(canvas.area());
    std::uint64_t pixels = area, exemplarPixels = 0;
    for (const Size& size : request.exemplarSizes()) {
        pixels = std::max(pixels, static_cast<std::uint64_t>(size.area()));
        exemplarPixels += static_cast<std::uint64_t>(size.area());
    }
    const auto channels = static_cast<std::uint64_t>(request.channels());
    Estimate need;
    need.bytes = TextureLoss::bytesFor(descriptor, options, pixels, threads) +
                 4 * 8 * channels * exemplarPixels + 4 * channels * area * 12 + 16 * pixels + (16U << 20U);
    if (settings.optimiser == Optimiser::Lbfgs)
        need.bytes += Lbfgs::bytesFor(channels * area, std::min(Minimiser::kHistory, settings.iterations));
    if (learnsDescriptor(request, settings.descriptor)) {
        need.bytes += learningBytes(quickLearning(), request.channels());
        need.seconds += learningSeconds(quickLearning(), request.channels());
    }
    constexpr double kEvaluations = 1.15;
    for (int scale = 0; scale < scalesFor(request, settings); ++scale)
        need.seconds += kEvaluations * settings.iterations *
                        TextureLoss::secondsFor(descriptor, options,
                                                static_cast<double>(canvasAt(request, scale).area()));
    addEstimatedMap(request, need);
    return need;
}

Synthesis run(const Request& request, const Settings& settings, JobContext& context) {
    return Synthesizer(request, settings, context).run();
}

} // namespace

extern const Method self;
const Method self = method<Settings>(
    {.title = TR("Gram matrices of a network"),
     .summary =
         TR("Changes noise, or an initial image, until the feature maps of a network vary together as the "
            "exemplar's do. New pixels rather than copies; long straight structures may bend or break."),
     .citation = "Gatys, Ecker & Bethge, NIPS 2015; Ustyuzhaninov et al., ICLR 2017",
     .category = Category::Networks,
     .suits = {.regular = 1, .grain = 4, .objects = 2, .large = 1},
     .takes = {ports::weighedExemplars(), ports::initial(), descriptorInput()},
     .gives = {ports::wrappingImage()},
     .keepsCheckpoints = true},
    {descriptorField(&Settings::descriptor),
     field(&Settings::scales, "scales", TR("Scales"))
         .range(1, 8)
         .symbol("S")
         .help(TR("Most scales, each half the size of the one before: more keep larger structures.")),
     field(&Settings::iterations, "iterations", TR("Iterations"))
         .range(1, 2000)
         .help(TR("At each scale: more come closer to the exemplar and take longer.")),
     networkLevelsField(&Settings::levels), coloursField(&Settings::colours),
     field(&Settings::histogram, "histogram", TR("Match histograms"))
         .help(TR("Gives the result the exemplar's distribution of colours at the end.")),
     field(&Settings::variation, "total-variation", TR("Total variation"))
         .range(0, 1)
         .help(TR("How much rough pixels are avoided: more smooths noise and fine detail alike.")),
     statisticField(&Settings::statistic), poolingField(&Settings::pooling),
     field(&Settings::firstTap, "first-tap", TR("First tap"))
         .range(1, 16)
         .group(TR("Advanced"))
         .help(
             TR("The first layer of the network that is compared; a larger number leaves fine detail free.")),
     field(&Settings::lastTap, "last-tap", TR("Last tap"))
         .range(1, 16)
         .group(TR("Advanced"))
         .help(TR("The last layer that is compared, or all that there are; a smaller number leaves large "
                  "structures free and is faster.")),
     field(&Settings::optimiser, "optimiser", TR("Optimiser"))
         .choices({{"l-bfgs", TR("L-BFGS")}, {"adam", TR("Adam")}})
         .group(TR("Advanced"))
         .help(
             TR("L-BFGS learns the curvature of the loss and comes further in as many iterations; Adam takes "
                "steps of one length.")),
     field(&Settings::rate, "rate", TR("Rate"))
         .range(0.0001, 1)
         .group(TR("Advanced"))
         .when("optimiser", "adam")
         .help(TR(
             "How far Adam moves in one step, in deviations of the exemplar's colours: larger is faster and "
             "less exact."))},
    run, check, estimate);

} // namespace texloom::gram_cnn
