#include "core/io/recipe.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/base/version.h"
#include "core/color/color_pipeline.h"
#include "core/image/map_role.h"
#include "core/io/edit_json.h"
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
    Json json = {{"file", relative.empty() ? absolute.generic_string() : relative.generic_string()},
                 {"space", file.space}};
    if (!file.hash.empty())
        json["sha1"] = file.hash;
    if (!file.role.empty())
        json["role"] = file.role;
    return json;
}

RecipeFile fileFrom(const JsonField& field, const fs::path& folder) {
    field.needObject();
    RecipeFile file;
    const fs::path path(field.at("file").text());
    if (path.empty())
        field.at("file").wrong(TR("the name of a file"));
    file.path = path.is_absolute() ? path : (folder / path).lexically_normal();
    file.space = field.has("space") ? field.at("space").text() : "";
    if (!file.space.empty())
        color::findSpace(file.space);
    file.hash = field.has("sha1") ? field.at("sha1").text() : "";
    file.role = field.has("role") ? field.at("role").text() : "";
    if (!file.role.empty())
        mapRoleFrom(file.role);
    return file;
}

Json exemplarJson(const RecipeExemplar& exemplar, const fs::path& folder) {
    Json json = fileJson(exemplar.image, folder);
    if (exemplar.mask)
        json["mask"] = fileJson(*exemplar.mask, folder);
    for (const RecipeFile& companion : exemplar.companions)
        json["companions"].push_back(fileJson(companion, folder));
    if (!exemplar.edits.empty())
        json["edits"] = texloom::toJson(exemplar.edits);
    if (exemplar.weight != 1)
        json["weight"] = exemplar.weight;
    return json;
}

RecipeExemplar exemplarFrom(const JsonField& field, const fs::path& folder) {
    RecipeExemplar exemplar;
    exemplar.image = fileFrom(field, folder);
    field.only({"file", "space", "sha1", "mask", "companions", "edits", "weight"});
    if (field.has("mask"))
        exemplar.mask = fileFrom(field.at("mask"), folder);
    if (field.has("companions")) {
        const JsonField companions = field.at("companions");
        companions.needArray(0, kMostFiles);
        for (std::size_t i = 0; i < companions.size(); ++i)
            exemplar.companions.push_back(fileFrom(companions.at(i), folder));
    }
    if (field.has("edits"))
        exemplar.edits = editsFrom(field.at("edits"));
    if (field.has("weight"))
        exemplar.weight = field.at("weight").number();
    return exemplar;
}

Json stepsJson(const std::vector<RecipeStep>& steps) {
    Json json = Json::array();
    for (const RecipeStep& step : steps)
        json.push_back({{"method", step.method}, {"parameters", toJson(step.parameters)}});
    return json;
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

Recipe recipeFrom(const JsonField& root, const fs::path& folder, bool needsExemplar) {
    if (!root.json().is_object())
        failUsage("A recipe is a JSON object; this is not one.");
    checkFormat(root);
    root.only({"texloom", "version", "method", "parameters", "then", "exemplars", "initial", "size", "wrap",
               "seed", "region", "outputs"});
    Recipe recipe;
    recipe.version = root.has("version") ? root.at("version").text() : "";
    recipe.method = root.at("method").text();
    if (root.has("parameters"))
        recipe.parameters = root.at("parameters").values();
    if (root.has("then"))
        recipe.then = stepsFrom(root.at("then"));
    const JsonField exemplars = root.at("exemplars");
    exemplars.needArray(needsExemplar ? 1 : 0, kMostFiles);
    for (std::size_t i = 0; i < exemplars.size(); ++i)
        recipe.exemplars.push_back(exemplarFrom(exemplars.at(i), folder));
    if (root.has("initial"))
        recipe.initial = fileFrom(root.at("initial"), folder);
    recipe.size = sizeFrom(root.at("size"));
    recipe.wrap = root.has("wrap") ? wrapFrom(root.at("wrap")) : Wrap{};
    recipe.seed = root.has("seed") ? seedFrom(root.at("seed")) : 0;
    if (root.has("region"))
        recipe.region = regionFrom(root.at("region"));
    return recipe;
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
    }
    if (recipe.initial)
        files.push_back(&*recipe.initial);
    return files;
}

} // namespace

std::vector<RecipeStep> stepsFrom(const JsonField& field) {
    field.needArray(0, kMostSteps);
    std::vector<RecipeStep> steps;
    for (std::size_t i = 0; i < field.size(); ++i) {
        const JsonField step = field.at(i);
        step.needObject();
        step.only({"method", "parameters"});
        steps.push_back({step.at("method").text(), {}});
        if (step.has("parameters"))
            steps.back().parameters = step.at("parameters").values();
    }
    return steps;
}

std::vector<RecipeFile*> Recipe::files() {
    return filesOf<RecipeFile>(*this);
}

std::vector<const RecipeFile*> Recipe::files() const {
    return filesOf<const RecipeFile>(*this);
}

std::string Recipe::toJson(const fs::path& folder) const {
    Json json = {{"texloom", kFormat},
                 {"version", version},
                 {"method", method},
                 {"parameters", texloom::toJson(parameters)}};
    if (!then.empty())
        json["then"] = stepsJson(then);
    json["exemplars"] = Json::array();
    for (const RecipeExemplar& exemplar : exemplars)
        json["exemplars"].push_back(exemplarJson(exemplar, folder));
    if (initial)
        json["initial"] = fileJson(*initial, folder);
    json["size"] = {size.width, size.height};
    json["wrap"] = std::string(wrap.x ? "x" : "") + (wrap.y ? "y" : "");
    json["seed"] = seed;
    if (region)
        json["region"] = {region->x, region->y, region->size.width, region->size.height};
    return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

Recipe Recipe::fromJson(std::string_view text, const fs::path& folder, bool needsExemplar) {
    const Json json = parseJson(TR("recipe"), text);
    return recipeFrom({TR("recipe"), json}, folder, needsExemplar);
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
