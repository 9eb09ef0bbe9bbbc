#include "app/cli/sample_command.h"

#include "app/cli/commands.h"
#include "app/cli/console.h"
#include "app/cli/option_forms.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/color/color_pipeline.h"
#include "core/generator/generator_source.h"
#include "core/io/image_file.h"
#include "core/job/job.h"
#include "core/session/run/asset_file.h"
#include "core/volume/coloured_mesh.h"
#include "core/volume/mesh_file.h"
#include "core/volume/slice.h"
#include "core/volume/solid_placement.h"
#include "core/volume/volume_file.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <numbers>

namespace texloom::cli {

namespace {

namespace fs = std::filesystem;

struct SampleCommand {
    fs::path solid, output, mesh;
    std::string box, plane, depth, space = "srgb", offset, rotate;
    std::optional<Size> size;
    double turn = 0, tilt = 0, scale = 0;
    std::uint64_t seed = 0;
    int tile = 0, threads = 0;
    bool overwrite = false, quiet = false;
};

/// A solid of a file, and the recipe that made it.
struct Solid {
    std::shared_ptr<const VolumeSource> source;
    std::string recipe;
};

/// Numbers with commas between them.
std::vector<double> numbersIn(const std::string& option, const std::string& text, std::size_t count) {
    std::vector<double> numbers;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        double number = 0;
        if (!parseNumber(text.substr(begin, end - begin), number))
            failUsage("{} {}: {} is not a number.", option, text, text.substr(begin, end - begin));
        numbers.push_back(number);
        begin = end + 1;
    }
    if (numbers.size() != count)
        failUsage("{} {}: it has {} numbers and needs {}.", option, text, numbers.size(), count);
    return numbers;
}

Box boxOf(const std::string& text) {
    const std::vector<double> numbers = numbersIn("--box", text, 6);
    constexpr double kMost = 1 << 30;
    for (std::size_t i = 0; i < numbers.size(); ++i)
        if (numbers[i] != std::floor(numbers[i]) ||
            std::abs(numbers[i]) > (i < 3 ? static_cast<double>(Box::kFarthest) : kMost))
            failUsage("--box {}: {} is no whole number that a box may have.", text, numbers[i]);
    const auto whole = [&](std::size_t i) { return static_cast<std::int64_t>(numbers[i]); };
    const auto side = [&](std::size_t i) { return static_cast<int>(numbers[i]); };
    const Box box{whole(0), whole(1), whole(2), {side(3), side(4), side(5)}};
    checkFileBox(box);
    return box;
}

Plane planeOf(const SampleCommand& command, Size size) {
    const double radians = std::numbers::pi / 180;
    Plane plane;
    const bool axis = command.plane.size() > 2 && command.plane[1] == '=' &&
                      std::string("xyz").find(command.plane[0]) != std::string::npos;
    if (axis) {
        const int number = command.plane[0] - 'x';
        Eigen::Vector3d origin = Eigen::Vector3d::Zero();
        origin[number] = numbersIn("--plane", command.plane.substr(2), 1).front();
        plane = axisPlane(static_cast<Axis>(number), origin);
    } else {
        const std::vector<double> n = numbersIn("--plane", command.plane, 9);
        plane = {{n[0], n[1], n[2]}, {n[3], n[4], n[5]}, {n[6], n[7], n[8]}};
    }
    if (command.turn == 0 && command.tilt == 0)
        return plane;
    return turned(plane, plane.at(size.width / 2.0, size.height / 2.0), command.turn * radians,
                  command.tilt * radians);
}

Solid solidFrom(const SampleCommand& command) {
    if (command.solid.extension() == usualExtension(AssetKind::Model)) {
        const Model model = readModel(command.solid);
        const VolumeSize period{command.tile, command.tile, command.tile};
        return {solidOf(model, command.seed, period), model.recipe};
    }
    return {std::get<std::shared_ptr<const VolumeSource>>(
                readAsset(AssetKind::Volume, command.solid, checkInterrupt)),
            {}};
}

Depth depthOf(const SampleCommand& command) {
    if (command.depth.empty())
        return depthsFor(command.output).front();
    for (const Depth depth : depthsFor(command.output))
        if (depthName(depth) == command.depth || depthName(depth) == command.depth + "-bit")
            return depth;
    failUsage("--depth {}: {} files do not hold it.", command.depth, command.output.extension().string());
}

void writeBox(const SampleCommand& command, const Solid& solid, JobContext& context) {
    VolumeWriteOptions options;
    if (command.output.extension() != ".json")
        options.depth = depthOf(command);
    options.space = command.space;
    options.recipe = solid.recipe;
    const Box box = boxOf(command.box);
    options.repeats = solid.source->period() == box.size;
    writeVolume(command.output, *solid.source, box, options, context);
}

void writePlane(const SampleCommand& command, const Solid& solid, JobContext& context) {
    const Size size = command.size.value_or(Size{512, 512});
    Image picture = slice(*solid.source, planeOf(command, size), size, context);
    color::fromWorking(picture, command.space);
    WriteOptions options;
    options.depth = depthOf(command);
    options.space = command.space;
    options.recipe = solid.recipe;
    options.check = [&context] { context.check(); };
    writeImage(command.output, picture, options);
}

/// Each vertex gets the colour of the solid at its place: what is longest of the mesh is as long as 128
/// voxels unless someone wants another scale.
void writeMeshColours(const SampleCommand& command, const Solid& solid, JobContext& context) {
    const Mesh mesh = readMesh(command.mesh, context);
    const Mesh::Bounds bounds = mesh.bounds();
    const double longest = static_cast<double>((bounds.highest - bounds.lowest).maxCoeff());
    constexpr double kUsual = 128;
    const double scale = command.scale > 0 ? command.scale : kUsual / std::max(longest, 1e-12);
    SolidPlacement placement;
    placement.scale = scale;
    const auto three = [](const std::string& option, const std::string& text) -> Eigen::Vector3d {
        if (text.empty())
            return Eigen::Vector3d::Zero();
        const std::vector<double> numbers = numbersIn(option, text, 3);
        return {numbers[0], numbers[1], numbers[2]};
    };
    placement.offset = three("--offset", command.offset);
    placement.angles = three("--rotate", command.rotate) * (std::numbers::pi / 180);
    writeColouredMesh(
        command.output, mesh, vertexColours(mesh, *solid.source, placement, context),
        [&context] { context.check(); }, solid.recipe);
}

void checkOutputs(const SampleCommand& command) {
    const int wanted = static_cast<int>(!command.box.empty()) + static_cast<int>(!command.plane.empty()) +
                       static_cast<int>(!command.mesh.empty());
    if (wanted != 1)
        failUsage("sample needs one of --box, --plane and --mesh, and {} are given.", wanted);
    if (command.tile % 32 != 0)
        failUsage("--tile {}: a generator repeats after a multiple of 32 voxels.", command.tile);
    std::vector<fs::path> read = filesOf(AssetKind::Volume, command.solid);
    if (!command.mesh.empty()) {
        checkColouredMeshFile(command.output);
        read.push_back(command.mesh);
    }
    checkFolder(command.output);
    if (command.box.empty()) {
        checkOnlyOutput(read, command.output, command.overwrite);
        return;
    }
    for (const fs::path& file : volumeFiles(command.output, boxOf(command.box).size.depth))
        checkOnlyOutput(read, file, command.overwrite);
}

void run(const SampleCommand& command) {
    checkOutputs(command);
    const Solid solid = solidFrom(command);
    JobOptions options;
    options.threads = command.threads;
    Job<bool> job(options, [&](JobContext& context) {
        context.stage(1, TR("Sampling"));
        if (!command.box.empty())
            writeBox(command, solid, context);
        else if (!command.plane.empty())
            writePlane(command, solid, context);
        else
            writeMeshColours(command, solid, context);
        return true;
    });
    followed(job, command.quiet);
    if (!command.quiet)
        fmt::print("{}\n", command.output.string());
}

} // namespace

void addSample(CLI::App& app) {
    const auto options = std::make_shared<SampleCommand>();
    CLI::App* command = app.add_subcommand("sample", "Make boxes, slices and coloured meshes of a solid");
    command
        ->add_option("solid", options->solid,
                     "A generator (.safetensors), or a volume (.json, or one of its slices)")
        ->required();
    command->add_option("--box", options->box,
                        "Voxels to make, as x,y,z,width,height,depth; x, y and z may be negative");
    command->add_option(
        "--plane", options->plane,
        "Slice to make: x=N, y=N or z=N, or nine numbers: its first pixel's place, and the steps to the "
        "next pixel to the right and down, in voxels");
    command->add_option("--mesh", options->mesh, "Mesh to colour at its vertices: .obj, .ply, .gltf or .glb");
    command
        ->add_option("-o,--output", options->output,
                     "File to write: of a box .json (with .raw) or numbered slices .png .tif .exr, of a "
                     "slice an image, of "
                     "a mesh .ply, .obj or .glb")
        ->required();
    addSize(*command, options->size, "Size of a slice, as 512x256 or 512; 512 if not given");
    command->add_option("--turn", options->turn,
                        "Degrees by which a slice is turned about its vertical axis");
    command->add_option("--tilt", options->tilt,
                        "Degrees by which it is then tilted about its horizontal one");
    command->add_option("--scale", options->scale,
                        "Voxels for one unit of a mesh; 128 for its longest side if not given");
    command->add_option("--offset", options->offset, "Voxel at a mesh's origin, as x,y,z");
    command->add_option("--rotate", options->rotate,
                        "Degrees by which a solid is turned in a mesh about x, then y, then z, as x,y,z");
    addSeed(*command, options->seed, "Of a generator: whole number from 0; another seed gives another solid");
    command->add_option(
        "--tile", options->tile,
        "Of a generator: voxels after which it repeats along every axis, a multiple of 32; 0 for never");
    command->add_option("--depth", options->depth, "Depth of images: 8, 16, half or float");
    command->add_option("--out-space", options->space,
                        "Colour space of the output: srgb, linear, acescg or raw");
    command->add_option("--threads", options->threads, "Number of threads; one per core if not given")
        ->check(CLI::Range(1, 1024));
    addMemory(*command);
    addReproducible(*command, false);
    addOverwrite(*command, options->overwrite);
    command->add_flag("--quiet", options->quiet, "Print nothing but errors");
    command->callback([options] { run(*options); });
}

} // namespace texloom::cli
