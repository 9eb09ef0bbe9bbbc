#include "core/io/recipe.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/base/version.h"
#include "core/color/color_pipeline.h"
#include "core/image/map_role.h"
#include "core/io/edit_json.h"
#include "core/io/file_name_json.h"
#include "core/io/image_file.h"
#include "core/io/json_field.h"

namespace texloom {

namespace fs = std::filesystem;
using Json = JsonField::Json;

namespace {

constexpr std::size_t kMostFiles = 4096;
constexpr std::size_t kMostSteps = 16;

Json fileJson(const RecipeFile& file, const fs::path& folder) {
    std::error_code error;
    const fs::path absolute = fs::absolute(file.path, error).lexically_normal();
    const fs::path relative = absolute.lexically_relative(fs::absolute(folder, error).lexically_normal());
    Json json;
    putFileName(json, "file", relative.empty() ? absolute : relative);
    json["space"] = file.space;
    if (!file.hash.empty())
        json["sha1"] = file.hash;
    if (!file.role.empty())
        json["role"] = file.role;
    if (!file.layer.empty())
        json["layer"] = file.layer;
    if (!file.channel.whole())
        json["channel"] = file.channel.index;
    if (file.channel.inverted)
        json["inverted"] = true;
    return json;
}

MapChannel channelFrom(const JsonField& field) {
    MapChannel channel;
    if (!field.has("channel"))
        return channel;
    channel.index = field.at("channel").whole();
    if (channel.index < 0)
        field.at("channel").wrong(TR("a channel of the file, counted from 0"));
    if (field.has("inverted")) {
        if (!field.at("inverted").json().is_boolean())
            field.at("inverted").wrong(TR("true or false"));
        channel.inverted = field.at("inverted").json().get<bool>();
    }
    return channel;
}

RecipeFile fileFrom(const JsonField& field, const fs::path& folder) {
    field.needObject();
    RecipeFile file;
    const fs::path path = fileNameFrom(field, "file");
    file.path = path.is_absolute() ? path : (folder / path).lexically_normal();
    file.space = field.has("space") ? field.at("space").text() : "";
    if (!file.space.empty())
        color::findSpace(file.space);
    file.hash = field.has("sha1") ? field.at("sha1").text() : "";
    file.role = field.has("role") ? field.at("role").text() : "";
    if (!file.role.empty())
        mapRoleFrom(file.role);
    file.layer = field.has("layer") ? field.at("layer").text() : "";
    file.channel = channelFrom(field);
    return file;
}

/// The field of its own that the image to start from has had since the first recipes.
constexpr const char* kInitial = "initial";

/// Writes each port's files as a list; that of the image to start from stands alone.
void addInputs(Json& json, const RecipeInputs& inputs, const fs::path& folder) {
    for (const auto& [port, files] : inputs) {
        if (port == kInitial && files.size() == 1) {
            json[kInitial] = fileJson(files.front(), folder);
            continue;
        }
        for (const RecipeFile& file : files)
            json["inputs"][port].push_back(fileJson(file, folder));
    }
}

RecipeInputs inputsFrom(const JsonField& field, const fs::path& folder) {
    RecipeInputs inputs;
    if (field.has(kInitial))
        inputs[kInitial].push_back(fileFrom(field.at(kInitial), folder));
    if (!field.has("inputs"))
        return inputs;
    const JsonField ports = field.at("inputs");
    ports.needObject();
    for (const auto& [port, list] : ports.json().items()) {
        const JsonField files = ports.at(port);
        files.needArray(1, kMostFiles);
        for (std::size_t i = 0; i < files.size(); ++i)
            inputs[port].push_back(fileFrom(files.at(i), folder));
    }
    return inputs;
}

Json exemplarJson(const RecipeExemplar& exemplar, const fs::path& folder) {
    Json json = fileJson(exemplar.image, folder);
    if (exemplar.mask)
        json["mask"] = fileJson(*exemplar.mask, folder);
    for (const RecipeFile& companion : exemplar.companions)
        json["companions"].push_back(fileJson(companion, folder));
    addInputs(json, exemplar.inputs, folder);
    if (!exemplar.edits.empty())
        json["edits"] = texloom::toJson(exemplar.edits);
    if (exemplar.weight != 1)
        json["weight"] = exemplar.weight;
    return json;
}

RecipeExemplar exemplarFrom(const JsonField& field, const fs::path& folder) {
    RecipeExemplar exemplar;
    exemplar.image = fileFrom(field, folder);
    field.only(
        {"file", "fileBytes", "space", "layer", "sha1", "mask", "companions", "inputs", "edits", "weight"});
    if (field.has("mask"))
        exemplar.mask = fileFrom(field.at("mask"), folder);
    if (field.has("companions")) {
        const JsonField companions = field.at("companions");
        companions.needArray(0, kMostFiles);
        for (std::size_t i = 0; i < companions.size(); ++i)
            exemplar.companions.push_back(fileFrom(companions.at(i), folder));
    }
    exemplar.inputs = inputsFrom(field, folder);
    if (field.has("edits"))
        exemplar.edits = editsFrom(field.at("edits"));
    if (field.has("weight"))
        exemplar.weight = field.at("weight").number();
    return exemplar;
}

/// The first step stands beside the recipe's other fields, those that follow it in a list.
void addSteps(Json& json, const std::vector<RecipeStep>& steps) {
    json["method"] = steps.front().method;
    json["parameters"] = toJson(steps.front().parameters);
    for (std::size_t i = 1; i < steps.size(); ++i)
        json["then"].push_back({{"method", steps[i].method}, {"parameters", toJson(steps[i].parameters)}});
}

RecipeStep stepFrom(const JsonField& field) {
    RecipeStep step{field.at("method").text(), {}};
    if (field.has("parameters"))
        step.parameters = field.at("parameters").values();
    return step;
}

Size sizeFrom(const JsonField& field) {
    field.needArray(2, 2);
    return {field.at(std::size_t{0}).whole(), field.at(std::size_t{1}).whole()};
}

Wrap wrapFrom(const JsonField& field) {
    const std::string axes = field.text();
    if (!axes.empty() && axes != "x" && axes != "y" && axes != "xy")
        field.wrong(TR(R"("", "x", "y" or "xy")"));
    return {axes.find('x') != std::string::npos, axes.find('y') != std::string::npos};
}

std::uint64_t seedFrom(const JsonField& field) {
    if (!field.json().is_number_unsigned())
        field.wrong(TR("a whole number from 0 to 18446744073709551615"));
    return field.json().get<std::uint64_t>();
}

Region regionFrom(const JsonField& field) {
    field.needArray(4, 4);
    const auto number = [&](std::size_t i) { return field.at(i).whole(); };
    return {number(0), number(1), {number(2), number(3)}};
}

void checkFormat(const JsonField& root) {
    const JsonField format = root.at("texloom");
    if (format.whole() < 1)
        format.wrong(message("1 to {}", Recipe::kFormat));
    if (format.whole() > Recipe::kFormat)
        failUsage("The recipe is of format {}, made by a newer Texloom; this one ({}) reads up to {}.",
                  format.whole(), kVersion, Recipe::kFormat);
}

Recipe recipeFrom(const JsonField& root, const fs::path& folder) {
    if (!root.json().is_object())
        failUsage("A recipe is a JSON object; this is not one.");
    checkFormat(root);
    root.only({"texloom", "version", "method", "parameters", "then", "exemplars", "initial", "inputs", "size",
               "wrap", "seed", "region", "outputs"});
    Recipe recipe;
    recipe.version = root.has("version") ? root.at("version").text() : "";
    recipe.steps = {stepFrom(root)};
    if (root.has("then"))
        for (RecipeStep& step : stepsFrom(root.at("then")))
            recipe.steps.push_back(std::move(step));
    if (root.has("exemplars")) // whether the methods need any is checked where the run is planned
        recipe.exemplars = exemplarsFrom(root.at("exemplars"), folder);
    recipe.inputs = inputsFrom(root, folder);
    recipe.size = sizeFrom(root.at("size"));
    recipe.wrap = root.has("wrap") ? wrapFrom(root.at("wrap")) : Wrap{};
    recipe.seed = root.has("seed") ? seedFrom(root.at("seed")) : 0;
    if (root.has("region"))
        recipe.region = regionFrom(root.at("region"));
    return recipe;
}

template <class File, class Inputs> void addFiles(std::vector<File*>& files, Inputs& inputs) {
    for (auto& [port, ofPort] : inputs)
        for (File& file : ofPort)
            files.push_back(&file);
}

/// Of a recipe, const or not.
template <class File, class Recipe> std::vector<File*> filesOf(Recipe& recipe) {
    std::vector<File*> files;
    for (auto& exemplar : recipe.exemplars) {
        files.push_back(&exemplar.image);
        if (exemplar.mask)
            files.push_back(&*exemplar.mask);
        for (File& companion : exemplar.companions)
            files.push_back(&companion);
        addFiles(files, exemplar.inputs);
    }
    addFiles(files, recipe.inputs);
    return files;
}

} // namespace

std::vector<RecipeExemplar> exemplarsFrom(const JsonField& field, const fs::path& folder) {
    field.needArray(0, kMostFiles);
    std::vector<RecipeExemplar> exemplars;
    for (std::size_t i = 0; i < field.size(); ++i)
        exemplars.push_back(exemplarFrom(field.at(i), folder));
    return exemplars;
}

std::vector<RecipeStep> stepsFrom(const JsonField& field) {
    field.needArray(0, kMostSteps);
    std::vector<RecipeStep> steps;
    for (std::size_t i = 0; i < field.size(); ++i) {
        const JsonField step = field.at(i);
        step.needObject();
        step.only({"method", "parameters"});
        steps.push_back(stepFrom(step));
    }
    return steps;
}

std::string methodIds(const std::vector<RecipeStep>& steps, const std::string& separator) {
    std::string ids;
    for (const RecipeStep& step : steps)
        ids += (ids.empty() ? "" : separator) + step.method;
    return ids;
}

std::vector<RecipeFile*> Recipe::files() {
    return filesOf<RecipeFile>(*this);
}

std::vector<const RecipeFile*> Recipe::files() const {
    return filesOf<const RecipeFile>(*this);
}

std::string Recipe::name() const {
    const std::vector<const RecipeFile*> all = files(); // exemplars come first
    return all.empty() ? "texture" : all.front()->path.stem().string();
}

std::string Recipe::space() const {
    if (!exemplars.empty())
        return exemplars.front().image.space;
    const auto initial = inputs.find(kInitial);
    return initial == inputs.end() || initial->second.empty() ? "srgb" : initial->second.front().space;
}

std::string Recipe::toJson(const fs::path& folder) const {
    Json json = {{"texloom", kFormat}, {"version", version}};
    addSteps(json, steps);
    json["exemplars"] = Json::array();
    for (const RecipeExemplar& exemplar : exemplars)
        json["exemplars"].push_back(exemplarJson(exemplar, folder));
    addInputs(json, inputs, folder);
    json["size"] = {size.width, size.height};
    json["wrap"] = std::string(wrap.x ? "x" : "") + (wrap.y ? "y" : "");
    json["seed"] = seed;
    if (region)
        json["region"] = {region->x, region->y, region->size.width, region->size.height};
    return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

Recipe Recipe::fromJson(std::string_view text, const fs::path& folder) {
    const Json json = parseJson(TR("recipe"), text);
    return recipeFrom({TR("recipe"), json}, folder);
}

Recipe readRecipe(const fs::path& path) {
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    try {
        if (path.extension() == ".json")
            return Recipe::fromJson(readText(path), folder);
        const std::string embedded = readImageInfo(path).recipe;
        if (embedded.empty())
            fail("{} holds no recipe.", path.string());
        return Recipe::fromJson(embedded, folder);
    } catch (const UsageError& error) {
        failUsage("{}: {}", path.string(), error.message());
    }
}

} // namespace texloom
