#include "core/base/error.h"
#include "core/base/text.h"
#include "core/methods/method.h"
#include "core/methods/patch_assignment/optimizer.h"
#include "core/methods/patch_request.h"

namespace texloom::patch_assignment {

namespace {

/// The approximate time that costs and assignments take.
double secondsFor(const Settings& settings, double rows, double perRow, int channels, bool narrowed) {
    const double pairs = rows * perRow;
    const double costs = pairs * settings.patch * settings.patch * 1e-10 * (1 + channels);
    if (narrowed)
        return 2.5 * settings.fineIterations * (5 * costs + rows * 4e-6);
    // Later iterations change less and less.
    return settings.epsilon > 0 || settings.relaxed ? 1.5 * costs + 3e-8 * pairs
                                                    : (1.5 + 0.2 * settings.fineIterations) * costs +
                                                          (4e-8 + 6e-9 * settings.fineIterations) * pairs;
}

Estimate estimate(const Request& request, const Settings& settings, int threads) {
    const Size canvas = Optimizer::canvasFor(request.size, request.wrap, settings.patch);
    const Size padded{canvas.width + settings.patch, canvas.height + settings.patch};
    const std::vector<Size> exemplars = request.exemplarSizes();
    const int channels = request.channels();
    const auto pixel = static_cast<std::uint64_t>(Interleaved({1, 1}, channels).pixel) * sizeof(float);
    const double columns = Optimizer::exemplarPatches(request, settings);
    const double rows = static_cast<double>(canvas.area()) / (settings.stride() * settings.stride());
    const bool narrowed = Optimizer::narrows(rows, columns, settings.fineIterations, settings.solve);
    const double perRow = narrowed ? Optimizer::kChoices : columns;
    // One band holds at least a row of the lattice; rows that share a patch are summed up beside the costs.
    const double most = settings.solve == Solve::Whole
                            ? rows * perRow
                            : std::max(Optimizer::kMostCosts, columns * canvas.width);
    const double finest = std::min(rows * perRow, most) * (narrowed ? 8 : 5);
    // The next coarser scale may have all its choices where the finest has few.
    const double coarser =
        5 * (settings.solve == Solve::Whole
                 ? rows * columns / 16
                 : std::min(rows * columns / 16, Optimizer::kMostWork / settings.coarseIterations));
    const double costs = std::max(finest, coarser);
    const double floats = static_cast<double>(settings.patch * settings.patch + 8) * channels;
    Estimate need;
    need.bytes =
        static_cast<std::uint64_t>(padded.area()) * pixel + Image::bytesFor(canvas, channels) * 3 / 2 +
        PositionMap::bytesFor(canvas) + static_cast<std::uint64_t>(costs) +
        static_cast<std::uint64_t>(rows * (96 + 4 * floats)) +
        static_cast<std::uint64_t>(columns * (4 * floats + 256)) +
        ExemplarPyramid::bytesFor(exemplars, channels) +
        static_cast<std::uint64_t>(threads) * static_cast<std::uint64_t>(canvas.width) * 20 * (pixel + 4) +
        (8U << 20U);
    for (const Size& size : exemplars)
        need.bytes += static_cast<std::uint64_t>(size.area() + 65536) * pixel;
    if (request.initial())
        need.bytes += Image::bytesFor(request.size, channels) * 3 / 2;
    need.seconds = secondsFor(settings, rows, perRow, channels, narrowed);
    return need;
}

Synthesis run(const Request& request, const Settings& settings, JobContext& context) {
    return Optimizer(request, settings, context).run();
}

} // namespace

extern const Method self;
const Method self = method<Settings>(
    {.title = TR("Patch assignment"),
     .summary =
         TR("Uses every patch of the exemplar as often as every other, so that nothing gets lost and nothing "
            "takes over. Keeps the exemplar's mix of colours and details; slow for large outputs."),
     .citation = "Gutierrez, thesis 2020, chapter 3; Gutierrez, Rabin, Galerne & Hurtut, SSVM 2017",
     .category = Category::Optimisation,
     .suits = {.regular = 2, .grain = 4, .objects = 3, .large = 2},
     .takes = {ports::weighedExemplars(), ports::mask(), ports::initial()},
     .gives = {ports::wrappingImage(), ports::map()}},
    {field(&Settings::patch, "patch", TR("Patch size"))
         .range(4, 32)
         .unit("px")
         .symbol("w")
         .help(TR(
             "Side of the patches, which lie a quarter of it apart: larger keeps larger structures, smaller "
             "varies more.")),
     scalesField(&Settings::scales),
     field(&Settings::coarseIterations, "coarse-iterations", TR("Coarse iterations"))
         .range(1, 500)
         .help(TR("Most rounds on each scale but the finest: more join better, but take longer.")),
     field(&Settings::fineIterations, "fine-iterations", TR("Fine iterations"))
         .range(1, 500)
         .help(TR("Most rounds on the finest scale, where most of the time is spent.")),
     field(&Settings::grid, "grid", TR("Grid"))
         .choices({{"regular", TR("Regular")}, {"random", TR("Random")}, {"hybrid", TR("Hybrid")}})
         .help(TR("Where the exemplar's patches lie: a regular grid is sharp and copies larger pieces, a "
                  "random one varies more and blurs, the hybrid is random but on the finest scale.")),
     field(&Settings::solve, "solve", TR("Solved"))
         .choices({{"automatic", TR("Automatic")}, {"whole", TR("Whole")}, {"narrowed", TR("Narrowed")}})
         .help(TR(
             "How patches are assigned: whole, as published, uses every patch as often as it should be and "
             "may take hours and gigabytes for large outputs; narrowed lets each patch choose among a few; "
             "automatic is whole up to some minutes.")),
     field(&Settings::epsilon, "epsilon", TR("Tolerance"))
         .range(0, 100)
         .symbol("ε")
         .help(
             TR("How much worse than the best an assignment may be for each patch: 0 for the best, 1 or 2 is "
                "faster and looks as good.")),
     field(&Settings::relaxed, "relaxed", TR("Relaxed"))
         .help(TR("Lets patches be used more or less often, so that what fits nowhere may be left out.")),
     field(&Settings::rho, "rho", TR("Relaxation"))
         .range(0, 1000)
         .symbol("ρ")
         .when("relaxed", true)
         .help(TR(
             "What each use too many or too few costs: 0 takes the nearest patches, a large value uses all "
             "alike.")),
     field(&Settings::constantEpsilon, "constant-epsilon", TR("Constant tolerance"))
         .group(TR("Advanced"))
         .help(TR(
             "Keeps the tolerance as it is on the finest scale, as published, where it otherwise falls from "
             "round to round.")),
     field(&Settings::settle, "settle", TR("Settled at"))
         .range(0, 1)
         .group(TR("Advanced"))
         .help(TR(
             "With a tolerance or relaxed: rounds end when the cost falls by less than this share; 0 goes on "
             "to the last round, as published.")),
     field(&Settings::supply, "supply", TR("Supply"))
         .choices({{"duplicate", TR("Duplicate")}, {"bootstrap", TR("Bootstrap")}})
         .group(TR("Advanced"))
         .help(TR("For outputs of another size than the exemplar's: all patches equally often, or patches "
                  "drawn at random.")),
     field(&Settings::aggregation, "aggregation", TR("Aggregation"))
         .choices({{"median", TR("Geometric median")},
                   {"mean", TR("Mean")},
                   {"robust", TR("Robust")},
                   {"robust-falloff", TR("Robust, Gaussian falloff")}})
         .symbol("r")
         .group(TR("Advanced"))
         .help(TR("How overlapping patches are joined: the geometric median (r = 1) as published, the mean "
                  "(r = 2), which blurs, or robust weights (r = 0.8).")),
     field(&Settings::median, "median", TR("Median"))
         .choices({{"weiszfeld", TR("Weiszfeld")}, {"douglas-rachford", TR("Douglas–Rachford")}})
         .when("aggregation", std::string("median"))
         .group(TR("Advanced"))
         .help(TR("How the geometric median of overlapping patches is found; the result is the same to four "
                  "digits.")),
     finishField(&Settings::finish)},
    run, checkPatch, estimate);

} // namespace texloom::patch_assignment
