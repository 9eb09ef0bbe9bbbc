#include "ui/volume/volume_files.h"

#include "core/base/text.h"
#include "core/color/color_pipeline.h"
#include "core/io/image_file.h"
#include "core/volume/coloured_mesh.h"
#include "core/volume/volume_file.h"

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

namespace texloom::ui {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostTriangles = 2'000'000;

/// The depth that files of this name have first of all, and the colours that suit it.
std::pair<Depth, std::string> waysOf(const fs::path& path) {
    const std::vector<Depth> held = depthsFor(path);
    const bool deep = std::find(held.begin(), held.end(), Depth::Bits16) != held.end();
    const Depth depth = deep ? Depth::Bits16 : held.front();
    return {depth, depth == Depth::Half || depth == Depth::Float ? "linear" : "srgb"};
}

} // namespace

int writeSlice(const SourceWithRecipe& volume, const Plane& plane, Size size, const fs::path& path,
               JobContext& context) {
    context.stage(1, TR("Writing a slice"));
    WriteOptions options;
    std::tie(options.depth, options.space) = waysOf(path);
    options.recipe = volume.recipe;
    options.check = [&context] { context.check(); };
    Image picture = slice(*volume.source, plane, size, context);
    color::fromWorking(picture, options.space);
    writeImage(path, picture, options);
    return 1;
}

int writeBox(const SourceWithRecipe& volume, const Box& box, const fs::path& path, JobContext& context) {
    context.stage(1, TR("Writing a box"));
    checkFileBox(box);
    VolumeWriteOptions options;
    if (path.extension() != ".json")
        std::tie(options.depth, options.space) = waysOf(path);
    options.recipe = volume.recipe;
    options.repeats = volume.source->period() == box.size;
    writeVolume(path, *volume.source, box, options, context);
    return static_cast<int>(volumeFiles(path, box.size.depth).size());
}

int writeMeshColours(const SourceWithRecipe& volume, const PlacedMesh& placed, double fineness,
                     const fs::path& path, JobContext& context) {
    context.stage(1, TR("Colouring a mesh"));
    checkColouredMeshFile(path);
    const auto check = [&context] { context.check(); };
    if (fineness <= 0) {
        writeColouredMesh(path, *placed.mesh,
                          vertexColours(*placed.mesh, *volume.source, placed.placement, context), check,
                          volume.recipe);
        return 1;
    }
    const Mesh fine = refined(*placed.mesh, fineness / placed.placement.scale, kMostTriangles, context);
    writeColouredMesh(path, fine, vertexColours(fine, *volume.source, placed.placement, context), check,
                      volume.recipe);
    return 1;
}

} // namespace texloom::ui
