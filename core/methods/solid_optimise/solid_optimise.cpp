#include "core/base/error.h"
#include "core/base/text.h"
#include "core/math/histogram.h"
#include "core/methods/method.h"
#include "core/methods/solid_optimise/problem.h"
#include "core/volume/volume_source.h"

#include <algorithm>
#include <memory>

namespace texloom::solid_optimise {

namespace {

constexpr const char* kVolume = "volume";
constexpr int kSmallestExemplar = 16;

void check(const Request& request, const Settings& settings) {
    checkSliceGoals(request, settings, std::max(kSmallestExemplar, settings.patch));
    if (settings.side < settings.patch)
        failUsage("A solid of {} voxels a side holds no neighbourhood of {}.", settings.side, settings.patch);
}

bool worksInPrincipalColours(Model model) {
    return model == Model::PatchDistribution || model == Model::HeegerBergen;
}

Volume solved(const Problem& problem, int scales) {
    switch (problem.settings().model) {
    case Model::HeegerBergen:
        return matchPyramids(problem, problem.settings().scales);
    case Model::Kopf:
        return matchNeighbourhoods(problem, scales);
    case Model::Wei:
        return scanned(problem, scales);
    default:
        return matchPatches(problem, scales);
    }
}

Synthesis run(const Request& request, const Settings& settings, JobContext& context) {
    context.stage(0.05, TR("Preparing the exemplar"));
    const Problem problem(request, settings, worksInPrincipalColours(settings.model), context);
    Synthesis made;
    Volume solid;
    if (problem.channels() == 0) {
        context.stage(0.9, TR("Matching patches"));
        solid = Volume({settings.side, settings.side, settings.side}, 1);
    } else {
        solid = solved(problem, scalesFor(request, settings));
    }
    context.stage(0.05, TR("Cutting a slice"));
    made.image = problem.picture(solid, request.size, 1);
    made.outputs.add(
        kVolume, std::make_shared<const DenseSource>(problem.coloured(solid), DenseSource::Edge::Repeats));
    context.progress(1);
    return made;
}

Estimate estimate(const Request& request, const Settings& settings, int threads) {
    const VolumeSize size{settings.side, settings.side, settings.side};
    const int channels = request.channels();
    const double voxels = static_cast<double>(size.voxels());
    const double goals =
        static_cast<double>(std::max<std::size_t>(1, sliceGoalSizes(request, settings).size()));
    Estimate need;
    need.bytes = 4 * Volume::bytesFor(size, channels) + 8 * Volume::bytesFor(size, 1) +
                 static_cast<std::uint64_t>(threads) * 7 * Volume::bytesFor(size, 1) +
                 3 * Image::bytesFor(request.size, channels) + (32U << 20);
    const double length = channels * settings.patch * settings.patch;
    const double each = settings.model == Model::PatchDistribution
                            ? settings.directions * (4e-10 * length + 6e-8)
                        : settings.model == Model::HeegerBergen ? 4e-6 * channels
                                                                : 4e-6;
    need.seconds = 1.2 * settings.iterations * goals * voxels * each;
    return need;
}

std::vector<Param> fields() {
    std::vector<Param> all = {
        field(&Settings::model, "model", TR("Model"))
            .choices({{"patch-distribution", TR("Patch distribution")},
                      {"heeger-bergen", TR("Pyramid histograms")},
                      {"kopf", TR("Neighbourhoods")},
                      {"wei", TR("Scan")}})
            .help(TR(
                "Distributes the patches of all slices as the exemplar's are, which is sharpest; or matches "
                "histograms of pyramids, quick, for grain without shapes; or copies neighbourhoods (Kopf), "
                "soft "
                "where directions disagree; or makes one voxel after another (Wei).")),
        field(&Settings::side, "side", TR("Side of the solid"))
            .range(16, 256)
            .unit("voxels")
            .help(TR("Voxels along each axis, after which the solid repeats: twice as many take eight times "
                     "as long.")),
        field(&Settings::patch, "patch", TR("Patch size"))
            .range(3, 15)
            .unit("px")
            .help(TR("Side of the neighbourhoods compared in slices at each scale: larger keeps larger "
                     "structures whole and takes longer.")),
        field(&Settings::scales, "scales", TR("Scales"))
            .range(1, 6)
            .help(TR("Most scales, each half the size of the one before: more keep larger structures.")),
        field(&Settings::iterations, "iterations", TR("Iterations"))
            .range(1, 200)
            .help(TR("Rounds at each scale: more bring the slices closer to the exemplar.")),
        field(&Settings::directions, "directions", TR("Directions"))
            .range(1, 64)
            .group(TR("Advanced"))
            .when("model", std::string("patch-distribution"))
            .help(TR("Random directions along which patches are compared in one iteration: more make each "
                     "iteration surer and longer."))};
    for (Param& one : sliceFields<Settings>())
        all.push_back(std::move(one));
    return all;
}

} // namespace

extern const Method self;
const Method self = method<Settings>(
    {.title = TR("Optimised solid"),
     .summary =
         TR("Makes a solid block that repeats in all directions and whose slices look like the exemplar, "
            "or like one exemplar for each direction. The picture is its slice at z = 0."),
     .citation = "Elnekave & Weiss, ECCV 2022; Heeger & Bergen, SIGGRAPH 1995; Kopf, Fu, Cohen-Or, Deussen, "
                 "Lischinski & Wong, SIGGRAPH 2007; Wei, SIGGRAPH Sketches 2003",
     .category = Category::Solids,
     .takes = {solidExemplars()},
     .gives = {ports::image(),
               {.id = kVolume,
                .title = TR("Volume"),
                .help = TR("The solid, which repeats after its side along every axis."),
                .kind = AssetKind::Volume,
                .least = 1}},
     .keepsCheckpoints = true},
    fields(), run, check, estimate);

} // namespace texloom::solid_optimise
