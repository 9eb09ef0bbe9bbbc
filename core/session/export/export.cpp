#include "core/session/export/export.h"

#include "core/base/error.h"
#include "core/base/folder_of.h"
#include "core/base/text.h"
#include "core/color/color_pipeline.h"
#include "core/io/map_file.h"
#include "core/io/own_file.h"
#include "core/session/export/companion_files.h"
#include "core/session/export/output_files.h"
#include "core/volume/volume_file.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <functional>
#include <set>

namespace texloom {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

/// What messages call a file that a recipe names.
const char* const kSource = TR("a source of the result");

using Step = ExportStep;

/// The files that a volume may replace. How many slices it will have is known only when it is there: those
/// that another volume of this name left all count.
std::vector<fs::path> filesForVolume(const fs::path& path) {
    std::vector<fs::path> files = volumeFiles(path, 1);
    if (files.size() == 1)
        for (const fs::path& slice : filesOfVolume(files.front()))
            if (slice.filename() != files.front().filename())
                files.push_back(slice);
    return files;
}

/// The space to write in: as asked, or what the format's users expect.
std::string spaceFor(const Result& result, const ExportOptions& options) {
    if (!options.space.empty())
        return options.space;
    const bool floating = options.depth == Depth::Half || options.depth == Depth::Float;
    const std::string source = result.plan.recipe.space();
    if (floating)
        return source == "srgb" || source == color::kFileSpace ? "linear" : source;
    return source == "raw" ? source : "srgb";
}

bool hasMap(const Result& result) {
    return result.synthesis.mapKind != MapKind::None;
}

WriteOptions writeOptions(const Result& result, const ExportOptions& options) {
    WriteOptions write;
    write.check = options.check;
    write.depth = options.depth;
    write.space = spaceFor(result, options);
    write.channelNames = result.plan.exemplarInfo.channelNames;
    write.recipe = result.plan.recipe.toJson(folderOf(options.image));
    return write;
}

/// To a file's space; "raw" is the numbers as the exemplar's own file has them.
void fromWorking(Image& image, const Result& result, const std::string& space,
                 const std::function<void()>& check) {
    const std::string own = result.plan.recipe.space();
    if (space != "raw")
        color::fromWorking(image, space, check);
    else if (own != color::kFileSpace)
        color::fromWorking(image, own, check);
    else if (result.plan.exemplarInfo.color)
        color::fromWorking(image, *result.plan.exemplarInfo.color, check);
}

void writeResult(const Result& result, const ExportOptions& options) {
    const WriteOptions write = writeOptions(result, options);
    const std::string own = result.plan.recipe.space();
    if (write.space == "srgb" || (write.space == "raw" && (own == "srgb" || own == "raw"))) {
        writeImage(options.image, result.synthesis.image, write);
        return;
    }
    Image converted = result.synthesis.image;
    fromWorking(converted, result, write.space, options.check);
    writeImage(options.image, converted, write);
}

void addOutputSteps(const Result& result, const ExportOptions& options, std::vector<Step>& steps) {
    for (const OutputFile& output : outputFiles(result, options.outputs)) {
        const AssetKind kind = output.port->kind;
        AssetWriteOptions write = outputOptions(result, output, options.depth);
        write.check = options.check;
        checkAssetFile(kind, output.path);
        for (const fs::path& file : filesFor(kind, *output.asset, output.path, write))
            steps.push_back({{file, Message(output.port->title), false}, {}});
        steps.back().write = [output, kind, write] { writeAsset(kind, *output.asset, output.path, write); };
    }
}

void writeSidecar(const Result& result, const ExportOptions& options, const fs::path& path) {
    Json json = Json::parse(result.plan.recipe.toJson(folderOf(path)));
    Json& outputs = json["outputs"];
    outputs.push_back({{"file", options.image.filename().string()},
                       {"content", "result"},
                       {"space", spaceFor(result, options)},
                       {"depth", depthName(options.depth)}});
    if (result.stoppedAt) // run again, the recipe makes all of it
        outputs.back()["stoppedAt"] = *result.stoppedAt;
    if (hasMap(result))
        for (const fs::path& map : options.maps)
            outputs.push_back(
                {{"file",
                  fs::absolute(map).lexically_relative(fs::absolute(folderOf(path))).generic_string()},
                 {"content", "position map"},
                 {"convention", mapConvention(map)}});
    for (const OutputFile& output : outputFiles(result, options.outputs))
        outputs.push_back(
            {{"file",
              fs::absolute(output.path).lexically_relative(fs::absolute(folderOf(path))).generic_string()},
             {"content", kindId(output.port->kind)},
             {"output", output.port->id}});
    writeText(path, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

/// @param made whether there is a result; before that its further outputs are unknown, and left out.
std::vector<Step> stepsFor(const Result& result, const ExportOptions& options, bool made) {
    std::vector<Step> steps;
    steps.push_back(
        {{options.image, TR("result"), false, "", options.depth}, [&] { writeResult(result, options); }});
    for (const fs::path& map : options.maps)
        steps.push_back(
            {{map, map.extension() == ".exr" ? TR("position map (STMap)") : TR("position map (16-bit)"),
              false},
             [&result, &options, map] {
                 writePositionMap(map, result.synthesis.map, result.plan.recipe.toJson(folderOf(map)),
                                  options.check);
             }});
    for (Step& step : companionSteps(result, options))
        steps.push_back(std::move(step));
    if (made)
        addOutputSteps(result, options, steps);
    if (options.sidecar) {
        const fs::path path = beside(options.image, "", ".json");
        steps.push_back({{path, TR("recipe"), false},
                         [&result, &options, path] { writeSidecar(result, options, path); }});
    }
    return steps;
}

/// The same once there is a result: with what is on the disk now, and nothing lost by it.
std::vector<Step> checkedSteps(const Result& result, const ExportOptions& options) {
    if (!options.maps.empty() && !hasMap(result))
        failUsage("{} copies no pixels, so it has no position map.",
                  Message(result.plan.lastMethod().info().title));
    std::vector<Step> steps = stepsFor(result, options, true);
    OutputGuard guard;
    guard.reads(sourcesOf(result.plan.recipe), kSource);
    for (Step& step : steps) {
        std::error_code error;
        step.entry.exists = fs::exists(step.entry.path, error);
        guard.writes(step.entry.path, Message(step.entry.content));
    }
    guard.check(true);
    return steps;
}

} // namespace

std::vector<fs::path> sourcesOf(const Recipe& recipe) {
    std::vector<fs::path> sources;
    for (const RecipeFile* file : recipe.files())
        sources.push_back(file->path);
    return sources;
}

void announce(const RunPlan& plan, const ExportOptions& options, OutputGuard& guard) {
    guard.reads(sourcesOf(plan.recipe), kSource);
    Result planned;
    planned.plan = plan;
    for (const Step& step : stepsFor(planned, options, false))
        guard.writes(step.entry.path, Message(step.entry.content));
    for (const auto& [id, path] : options.outputs) {
        const Port* const port = outputPort(plan, id);
        const Message content = port != nullptr ? Message(port->title) : Message::verbatim(id);
        for (const fs::path& file :
             port != nullptr && port->kind == AssetKind::Volume ? filesForVolume(path) : std::vector{path})
            guard.writes(file, content);
    }
}

std::vector<ExportEntry> exportEntries(const Result& result, const ExportOptions& options) {
    std::vector<ExportEntry> entries;
    for (Step& step : checkedSteps(result, options)) {
        step.entry.foreign = isForeignFile(step.entry.path);
        entries.push_back(std::move(step.entry));
    }
    return entries;
}

std::uint64_t clippedSamples(const ImageView& image, const std::function<void()>& check) {
    std::uint64_t count = 0;
    for (int c = 0; c < image.channels; ++c)
        for (int y = 0; y < image.height; ++y) {
            check();
            const float* const row = image.plane(c).row(y);
            for (int x = 0; x < image.width; ++x)
                count += row[x] < 0 || row[x] > 1 ? 1 : 0;
        }
    return count;
}

void exportPicture(const fs::path& path, const ImageView& picture, const ExemplarFile& source,
                   const std::function<void()>& check) {
    WriteOptions write;
    write.depth = depthLike(source.info, path);
    const bool floating = write.depth == Depth::Half || write.depth == Depth::Float;
    write.space = source.space == "raw" ? "raw" : floating ? "linear" : "srgb";
    write.check = check;
    write.channelNames = source.info.channelNames;
    if (write.space != "linear")
        return writeImage(path, picture, write);
    Image converted(picture);
    color::fromWorking(converted, write.space, check);
    writeImage(path, converted, write);
}

std::vector<ExportEntry> exportResult(const Result& result, const ExportOptions& options) {
    std::vector<ExportEntry> written;
    try {
        for (Step& step : checkedSteps(result, options)) {
            if (options.mayReplace && step.entry.exists && !options.mayReplace->contains(step.entry.path))
                fail("{} was not there before; export again to see what would be replaced.",
                     step.entry.path.string());
            if (step.write)
                step.write();
            written.push_back(std::move(step.entry));
        }
    } catch (...) {
        std::error_code ignored;
        for (const ExportEntry& entry : written)
            if (!entry.exists)
                fs::remove(entry.path, ignored);
        throw;
    }
    return written;
}

Result exportStrips(const RunPlan& plan, const ExportOptions& options,
                    const std::function<Result(RunPlan)>& make) {
    const bool companions = options.companions && plan.hasCompanions();
    if (!options.maps.empty() || companions || !options.outputs.empty())
        failUsage("An output of {} × {} px is made in strips of {} rows, without position maps, companion "
                  "maps or anything else beside it; choose a region or a smaller size to get those.",
                  plan.request.part().size.width, plan.request.part().size.height, plan.stripRows);
    Result whole;
    whole.plan = plan;
    const Region part = plan.request.part();
    Result strip;
    Assets learned;
    const RowSource rows = [&](int y, float* row) {
        if (y % plan.stripRows == 0) {
            strip = {}; // frees the one before
            strip = make(plan.strip(part.y + y, y == 0 ? nullptr : &learned));
            whole.seconds += strip.seconds;
            if (y == 0) {
                learned = learnedBy(plan.lastMethod().info(), strip.synthesis.outputs);
                whole.figures = strip.synthesis.figures;
                whole.synthesis.notes = strip.synthesis.notes;
            }
            fromWorking(strip.synthesis.image, whole, spaceFor(whole, options), options.check);
        }
        const Image& image = strip.synthesis.image;
        for (int x = 0; x < image.width(); ++x)
            for (int c = 0; c < image.channels(); ++c)
                row[x * image.channels() + c] = image(x, y % plan.stripRows, c);
    };
    writeImage(options.image, part.size, plan.resultChannels(), rows, writeOptions(whole, options));
    if (options.sidecar)
        writeSidecar(whole, options, beside(options.image, "", ".json"));
    return whole;
}

} // namespace texloom
