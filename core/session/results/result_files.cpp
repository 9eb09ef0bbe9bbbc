#include "core/session/results/result_files.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/io/curve_json.h"
#include "core/io/image_file.h"
#include "core/io/json_field.h"
#include "core/io/map_file.h"
#include "core/io/message_json.h"
#include "core/session/run/asset_file.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <limits>
#include <utility>

namespace texloom {

namespace fs = std::filesystem;
using Json = JsonField::Json;

namespace {

constexpr int kFormat = 1;
constexpr const char* kEntry = "entry.json";
/// An entry for a folder that is about to move; takes the entry's place once it has.
constexpr const char* kMovedEntry = "entry.moved.json";
constexpr const char* kPart = ".part"; ///< of folders that are not yet whole
constexpr const char* kImage = "image.tif";
constexpr const char* kMap = "map.png";
constexpr std::array kMapKinds = {"none", "exact", "dominant", "estimated"};
/// After this time what has no entry will not get one any more.
constexpr std::chrono::hours kBrokenOff{24};

std::string numbered(const char* name, std::size_t index) {
    return fmt::format("{}-{}.tif", name, index + 1);
}

/// The name of a further output's file, or that by which its files are read.
std::string outputName(AssetKind kind, std::size_t index) {
    const bool image = kind == AssetKind::Image || kind == AssetKind::Mask; // floats, as the result's
    return fmt::format("output-{}{}", index + 1, image ? ".tif" : usualExtension(kind));
}

std::int64_t now() {
    using namespace std::chrono;
    return duration_cast<milliseconds>(system_clock::now().time_since_epoch()).count();
}

/// Never the same twice in one process; another process has another suffix.
std::string newKey(std::int64_t time) {
    static std::atomic<std::int64_t> last = 0;
    std::int64_t before = last;
    std::int64_t next = 0;
    do
        next = std::max(before + 1, time);
    while (!last.compare_exchange_weak(before, next));
    return fmt::format("{:013}-{}", next, getpid());
}

void writePixels(const fs::path& path, const ImageView& image) {
    WriteOptions options;
    options.depth = Depth::Float;
    options.space = "raw";
    options.compressed = false;
    writeImage(path, image, options);
}

Json figuresJson(const std::vector<Figure>& figures) {
    Json json = Json::array();
    for (const Figure& figure : figures)
        json.push_back({{"name", toJson(figure.name)}, {"value", figure.value}});
    return json;
}

Json stagesJson(const std::vector<StageTime>& stages) {
    Json json = Json::array();
    for (const StageTime& stage : stages)
        json.push_back({{"name", toJson(stage.name)}, {"seconds", stage.seconds}});
    return json;
}

Json outputsJson(const std::vector<KeptOutput>& outputs) {
    Json json = Json::array();
    for (const KeptOutput& output : outputs)
        json.push_back({{"port", output.port}, {"kind", kindId(output.kind)}, {"size", toJson(output.size)}});
    return json;
}

std::string entryText(const ResultEntry& entry, const fs::path& folder) {
    Json json = {{"texloomResult", kFormat},
                 {"title", entry.title},
                 {"pinned", entry.pinned},
                 {"quick", entry.quick},
                 {"finished", entry.finished},
                 {"recipe", Json::parse(entry.recipe.toJson(folder))},
                 {"seconds", entry.seconds},
                 {"estimateSeconds", entry.estimateSeconds},
                 {"threads", entry.threads},
                 {"bytes", entry.bytes},
                 {"mapKind", kMapKinds.at(static_cast<std::size_t>(entry.mapKind))},
                 {"figures", figuresJson(entry.figures)},
                 {"curves", toJson(entry.curves)},
                 {"notes", toJson(entry.notes)},
                 {"stages", stagesJson(entry.stages)},
                 {"pictures", toJson(entry.pictures)},
                 {"companions", entry.companions},
                 {"outputs", outputsJson(entry.outputs)}};
    if (entry.stoppedAt)
        json["stoppedAt"] = *entry.stoppedAt;
    if (entry.stars > 0)
        json["stars"] = entry.stars;
    if (!entry.varied.empty())
        json["varied"] = toJson(entry.varied);
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::vector<Figure> figuresIn(const Json& json) {
    std::vector<Figure> figures;
    for (const Json& figure : json)
        figures.push_back({messageFrom(figure.at("name")), numberFrom(figure.at("value"))});
    return figures;
}

std::vector<KeptOutput> outputsIn(const Json& json) {
    std::vector<KeptOutput> outputs;
    for (const Json& output : json)
        outputs.push_back({output.at("port").get<std::string>(),
                           kindFrom(output.at("kind").get<std::string>()), messageFrom(output.at("size"))});
    return outputs;
}

MapKind mapKindIn(const Json& json) {
    const auto found = std::find(kMapKinds.begin(), kMapKinds.end(), json.get<std::string>());
    if (found == kMapKinds.end())
        fail("its kind of map is not known.");
    return static_cast<MapKind>(found - kMapKinds.begin());
}

ResultEntry entryIn(const Json& json, const fs::path& folder) {
    if (json.at("texloomResult").get<int>() != kFormat)
        fail("it was made by another version.");
    ResultEntry entry;
    entry.key = folder.filename().string();
    entry.title = json.at("title").get<std::string>();
    entry.pinned = json.at("pinned").get<bool>();
    entry.quick = json.at("quick").get<bool>();
    entry.finished = json.at("finished").get<std::int64_t>();
    entry.recipe = Recipe::fromJson(json.at("recipe").dump(), folder);
    entry.seconds = json.at("seconds").get<double>();
    entry.estimateSeconds = json.at("estimateSeconds").get<double>();
    entry.threads = json.at("threads").get<int>();
    if (json.contains("stoppedAt"))
        entry.stoppedAt = json.at("stoppedAt").get<double>();
    if (json.contains("stars"))
        entry.stars = std::clamp(json.at("stars").get<int>(), 0, ResultEntry::kMostStars);
    if (json.contains("varied"))
        entry.varied = messagesFrom(json.at("varied"));
    entry.bytes = json.at("bytes").get<std::uint64_t>();
    entry.mapKind = mapKindIn(json.at("mapKind"));
    entry.figures = figuresIn(json.at("figures"));
    entry.curves = curvesFrom(json.at("curves"));
    entry.notes = messagesFrom(json.at("notes"));
    for (const Json& stage : json.at("stages"))
        entry.stages.push_back({messageFrom(stage.at("name")), stage.at("seconds").get<double>()});
    entry.pictures = messagesFrom(json.at("pictures"));
    entry.companions = json.at("companions").get<std::size_t>();
    if (json.contains("outputs"))
        entry.outputs = outputsIn(json.at("outputs"));
    return entry;
}

ResultEntry readEntry(const fs::path& folder) {
    try {
        return entryIn(parseJson(TR("entry"), readText(folder / kEntry)), folder);
    } catch (const Json::exception&) {
        fail("its entry is damaged.");
    }
}

/// To another disk, too, if need be.
void moveFolder(const fs::path& from, const fs::path& to) {
    std::error_code error;
    fs::rename(from, to, error);
    if (!error)
        return;
    const fs::path part = fs::path(to).concat(kPart);
    fs::remove_all(part, error);
    fs::copy(from, part, fs::copy_options::recursive, error);
    if (!error)
        fs::rename(part, to, error);
    std::error_code ignored;
    fs::remove_all(error ? part : from, ignored);
}

bool brokeOffLongAgo(const fs::path& folder) {
    std::error_code error;
    const auto changed = fs::last_write_time(folder, error);
    return !error && fs::file_time_type::clock::now() - changed > kBrokenOff;
}

/// The plan as far as the recipe alone tells it, for a result whose exemplars are gone: they are there by
/// name with one pixel each.
RunPlan planWithoutExemplars(const ResultEntry& entry, int channels) {
    RunPlan plan;
    for (const RecipeStep& step : entry.recipe.steps) {
        const Method& method = findMethod(step.method);
        plan.steps.push_back({&method, step.parameters, {}, channels});
    }
    const auto pixel = std::make_shared<const Image>(Size{1, 1}, channels);
    for (const RecipeExemplar& exemplar : entry.recipe.exemplars)
        plan.request.exemplars.push_back({exemplar.image.path.stem().string(), pixel});
    plan.companions.resize(plan.request.exemplars.size());
    plan.request.size = entry.recipe.size;
    plan.request.wrap = entry.recipe.wrap;
    plan.request.seed = entry.recipe.seed;
    plan.request.region = entry.recipe.region;
    return plan;
}

/// The plan that made it, with the exemplars read anew; `problem` says why not, or what changed.
RunPlan planOf(const ResultEntry& entry, int channels, Message& problem) {
    try {
        std::vector<std::string> changed;
        RunInput input = loadRecipe(
            entry.recipe, [&](const fs::path& path) { changed.push_back(path.filename().string()); });
        input.threads = entry.threads;
        if (!changed.empty())
            problem = message("{} changed since this result was made.", listOf(changed));
        return planRun(input, std::numeric_limits<std::uint64_t>::max());
    } catch (const Error& error) {
        problem = error.message();
        return planWithoutExemplars(entry, channels);
    }
}

void readSynthesis(const fs::path& folder, const ResultEntry& entry, Synthesis& synthesis) {
    synthesis.image = readImage(folder / kImage).image;
    synthesis.mapKind = entry.mapKind;
    if (entry.mapKind != MapKind::None) {
        synthesis.map = readPositionMap(folder / kMap);
        if (synthesis.map.size() != synthesis.image.size())
            fail("{} is not of the result's size.", (folder / kMap).string());
    }
    synthesis.curves = entry.curves;
    synthesis.notes = entry.notes;
    for (std::size_t i = 0; i < entry.pictures.size(); ++i)
        synthesis.pictures.push_back({entry.pictures[i], readImage(folder / numbered("picture", i)).image});
    for (std::size_t i = 0; i < entry.outputs.size(); ++i) {
        const KeptOutput& output = entry.outputs[i];
        synthesis.outputs.add(output.port, readAsset(output.kind, folder / outputName(output.kind, i)));
    }
}

void writeOutputs(const fs::path& folder, const ResultEntry& entry, const Synthesis& synthesis) {
    AssetWriteOptions options;
    options.depth = Depth::Float;
    options.space = "raw"; // nothing is converted
    options.size = synthesis.image.size();
    std::size_t index = 0; // in the order of the entry's
    for (const auto& [port, assets] : synthesis.outputs.byPort())
        for (const Asset& asset : assets) {
            const AssetKind kind = entry.outputs[index].kind;
            writeAsset(kind, asset, folder / outputName(kind, index), options);
            ++index;
        }
}

void writeSynthesis(const fs::path& folder, const Synthesis& synthesis) {
    writePixels(folder / kImage, synthesis.image);
    if (synthesis.mapKind != MapKind::None && !synthesis.map.size().empty())
        writePositionMap(folder / kMap, synthesis.map);
    for (std::size_t i = 0; i < synthesis.pictures.size(); ++i)
        writePixels(folder / numbered("picture", i), synthesis.pictures[i].image);
}

std::uint64_t bytesOf(const Image& image) {
    return image.empty() ? 0 : Image::bytesFor(image.size(), image.channels());
}

} // namespace

std::string ResultEntry::methodIds() const {
    return texloom::methodIds(recipe.steps, " + ");
}

ResultEntry entryFor(const Result& result, bool quick) {
    ResultEntry entry;
    entry.finished = now();
    entry.key = newKey(entry.finished);
    entry.quick = quick;
    entry.recipe = result.plan.recipe;
    entry.seconds = result.seconds;
    entry.estimateSeconds = result.plan.estimate.seconds;
    entry.threads = result.plan.threads;
    entry.stoppedAt = result.stoppedAt;
    entry.bytes = memoryOf(result);
    entry.mapKind = result.synthesis.map.size().empty() ? MapKind::None : result.synthesis.mapKind;
    entry.figures = result.figures;
    entry.curves = result.synthesis.curves;
    entry.notes = result.synthesis.notes;
    entry.stages = result.stages;
    for (const Picture& picture : result.synthesis.pictures)
        entry.pictures.push_back(picture.name);
    entry.companions = result.companions.size();
    for (const auto& [port, assets] : result.synthesis.outputs.byPort())
        for (const Asset& asset : assets)
            entry.outputs.push_back({port, kindOf(asset), sizeText(asset)});
    return entry;
}

std::uint64_t memoryOf(const Result& result) {
    const Synthesis& synthesis = result.synthesis;
    std::uint64_t bytes = bytesOf(synthesis.image) + PositionMap::bytesFor(synthesis.map.size());
    for (const Picture& picture : synthesis.pictures)
        bytes += bytesOf(picture.image);
    for (const Image& companion : result.companions)
        bytes += bytesOf(companion);
    for (const auto& [port, assets] : synthesis.outputs.byPort())
        for (const Asset& asset : assets)
            bytes += bytesOf(asset);
    return bytes;
}

void ResultFolder::takeOver(const fs::path& earlier) const {
    std::error_code error;
    for (const fs::directory_entry& folder : fs::directory_iterator(earlier, error)) {
        const fs::path place = m_path / folder.path().filename();
        if (!folder.is_directory(error) || !fs::exists(folder.path() / kEntry, error) ||
            fs::exists(place, error))
            continue;
        try {
            // Recipes name their files relative to where they are.
            writeText(folder.path() / kMovedEntry, entryText(readEntry(folder.path()), place));
        } catch (const Error&) {
            continue; // what cannot be read stays for whoever can
        }
        std::error_code failed; // apart, for the loop ends with `error`
        fs::create_directories(m_path, failed);
        moveFolder(folder.path(), place);
        fs::rename(place / kMovedEntry, place / kEntry, failed);
    }
}

ResultFolder::Scan ResultFolder::scan() const {
    Scan found;
    std::error_code error;
    for (const fs::directory_entry& folder : fs::directory_iterator(m_path, error)) {
        if (!folder.is_directory(error) || folder.path().extension() == kPart)
            continue;
        if (fs::exists(folder.path() / kMovedEntry, error)) // a move that a crash broke off
            fs::rename(folder.path() / kMovedEntry, folder.path() / kEntry, error);
        if (!fs::exists(folder.path() / kEntry, error)) {
            if (brokeOffLongAgo(folder.path()))
                fs::remove_all(folder.path(), error);
            continue;
        }
        try {
            found.entries.push_back(readEntry(folder.path()));
        } catch (const Error& why) {
            found.problems.push_back(
                message("The earlier result in {} is left out: {}", folder.path().string(), why.message()));
        }
    }
    std::sort(found.entries.begin(), found.entries.end(),
              [](const ResultEntry& a, const ResultEntry& b) { return a.key < b.key; });
    return found;
}

void ResultFolder::write(const ResultEntry& entry, const Result& result) const {
    const fs::path folder = of(entry);
    std::error_code error;
    fs::create_directories(folder, error);
    if (error)
        fail("The folder {} cannot be made: {}.", folder.string(), error.message());
    try {
        writeSynthesis(folder, result.synthesis);
        writeOutputs(folder, entry, result.synthesis);
        for (std::size_t i = 0; i < result.companions.size(); ++i)
            writePixels(folder / numbered("companion", i), result.companions[i]);
        writeEntry(entry);
    } catch (...) {
        remove(entry);
        throw;
    }
}

void ResultFolder::writeEntry(const ResultEntry& entry) const {
    writeText(of(entry) / kEntry, entryText(entry, of(entry)));
}

StoredResult ResultFolder::read(const ResultEntry& entry) const {
    const fs::path folder = of(entry);
    auto result = std::make_shared<Result>();
    readSynthesis(folder, entry, result->synthesis);
    for (std::size_t i = 0; i < entry.companions; ++i)
        result->companions.push_back(readImage(folder / numbered("companion", i)).image);
    StoredResult stored;
    result->plan = planOf(entry, result->synthesis.image.channels(), stored.problem);
    result->plan.recipe = entry.recipe;
    result->plan.threads = entry.threads;
    result->figures = entry.figures;
    result->stages = entry.stages;
    result->seconds = entry.seconds;
    result->stoppedAt = entry.stoppedAt;
    leaveOutCompanions(*result);
    stored.result = std::move(result);
    return stored;
}

std::uint64_t ResultFolder::bytesOf(const ResultEntry& entry) const {
    std::uint64_t bytes = 0;
    std::error_code error;
    for (const fs::directory_entry& file : fs::directory_iterator(of(entry), error))
        if (const std::uintmax_t size = file.file_size(error); !error)
            bytes += size;
    return bytes;
}

void ResultFolder::remove(const ResultEntry& entry) const {
    std::error_code ignored;
    fs::remove_all(of(entry), ignored);
}

} // namespace texloom
