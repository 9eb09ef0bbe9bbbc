// A method that takes a map and a surface, and gives both: the exemplar laid out by the map, and the surface
// with texture coordinates that lay the output over it from above.

#include "core/base/error.h"
#include "core/methods/registry.h"
#include "core/volume/mesh.h"

#include <algorithm>
#include <memory>
#include <utility>

namespace texloom::drape {

namespace {

constexpr const char* kLayout = "layout";
constexpr const char* kSurface = "surface";

struct Settings {
    bool mirrored = false; ///< left and right of the output change places
};

void check(const Request& request, const Settings&) {
    const auto layout = request.inputs.first<PositionMap>(kLayout);
    if (layout && layout->exemplarSizes() != request.exemplarSizes())
        failUsage("The layout is of other exemplars than the ones given.");
}

/// (0, 0) is the top left of the output, so y turns round.
std::shared_ptr<const Mesh> laidOver(const Mesh& surface) {
    auto covered = std::make_shared<Mesh>(surface);
    const Mesh::Bounds bounds = surface.bounds();
    const Eigen::Vector3f extent = (bounds.highest - bounds.lowest).cwiseMax(1e-6F);
    covered->uvs.clear();
    for (const Eigen::Vector3f& position : surface.positions) {
        const Eigen::Vector3f share = (position - bounds.lowest).cwiseQuotient(extent);
        covered->uvs.emplace_back(share.x(), 1 - share.y());
    }
    return covered;
}

Synthesis run(const Request& request, const Settings& settings, JobContext& context) {
    const ImageView exemplar = *request.exemplars.front().image;
    const std::shared_ptr<const PositionMap> layout = request.inputs.first<PositionMap>(kLayout);
    context.stage(1, TR("Laying out"));
    Synthesis made;
    made.image = Image(request.size, request.channels());
    made.map = PositionMap(request.size, request.exemplarSizes());
    constexpr int kRows = 16; // between two previews
    for (int begin = 0; begin < request.size.height; begin += kRows) {
        const int end = std::min(begin + kRows, request.size.height);
        context.parallel(begin, end, [&](int y) {
            for (int x = 0; x < request.size.width; ++x) {
                const Source from = layout->at(settings.mirrored ? request.size.width - 1 - x : x, y);
                made.map.at(x, y) = from;
                for (int c = 0; from.valid() && c < exemplar.channels; ++c)
                    made.image(x, y, c) = (*request.exemplars[from.exemplar].image)(from.x, from.y, c);
            }
        });
        context.preview(made.image, &made.map);
        context.progress(static_cast<double>(end) / request.size.height);
    }
    made.mapKind = MapKind::Exact;
    made.outputs.set(kSurface, laidOver(*request.inputs.first<Mesh>(kSurface)));
    return made;
}

Estimate estimate(const Request& request, const Settings&, int) {
    return {Image::bytesFor(request.size, request.channels()) + PositionMap::bytesFor(request.size) +
                (1U << 20U),
            1e-8 * static_cast<double>(request.size.area())};
}

} // namespace

const Method self =
    method<Settings>({.title = TR("Drape"),
                      .summary = TR("Lays the exemplar out as a map says, and over a surface from above."),
                      .citation = "None: an example that takes and gives maps and surfaces",
                      .category = Category::Tools,
                      .takes = {ports::exemplar(),
                                {.id = kLayout,
                                 .title = TR("Layout"),
                                 .help = TR("Where each pixel comes from."),
                                 .kind = AssetKind::Map,
                                 .least = 1,
                                 .extent = Extent::Output},
                                {.id = kSurface,
                                 .title = TR("Surface"),
                                 .help = TR("What the output is laid over."),
                                 .kind = AssetKind::Mesh,
                                 .least = 1}},
                      .gives = {ports::image(),
                                ports::map(),
                                {.id = kSurface,
                                 .title = TR("Covered surface"),
                                 .help = TR("The surface with texture coordinates."),
                                 .kind = AssetKind::Mesh,
                                 .least = 1}},
                      .usesSeed = false},
                     {field(&Settings::mirrored, "mirrored", TR("Mirrored"))
                          .help(TR("Whether left and right change places."))},
                     run, check, estimate);

namespace {
const Registration registered("drape", self);
}

} // namespace texloom::drape
