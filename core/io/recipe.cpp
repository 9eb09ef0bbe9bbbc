#include "core/io/recipe.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/base/version.h"
#include "core/color/color_pipeline.h"
#include "core/io/image_file.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <climits>

namespace texloom {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

constexpr std::size_t kMostFiles = 4096;
constexpr int kDeepest = 16;

/// A value in the recipe with the name by which messages call it: "exemplars[0].file".
struct Field {
    const Json& json;
    std::string name;

    [[noreturn]] void wrong(std::string_view expected) const {
        std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
        if (text.size() > 60)
            text = text.substr(0, 57) + "…";
        failUsage("The recipe's {} is {}; it must be {}.", name, text, expected);
    }
    bool has(const std::string& key) const { return json.contains(key); }
    Field at(const std::string& key) const {
        const std::string full = name.empty() ? key : name + "." + key;
        if (!json.contains(key))
            failUsage("The recipe has no {}.", full);
        return {json.at(key), full};
    }
    Field at(std::size_t index) const { return {json.at(index), name + "[" + std::to_string(index) + "]"}; }
    void only(const std::vector<std::string>& known) const {
        for (const auto& [key, value] : json.items())
            if (std::find(known.begin(), known.end(), key) == known.end())
                failUsage("The recipe has a field {} that is not known here; there is {}.",
                          name.empty() ? key : name + "." + key, listText(known));
    }
    void needObject() const {
        if (!json.is_object())
            wrong("an object");
    }
    void needArray(std::size_t least, std::size_t most) const {
        if (!json.is_array() || json.size() < least || json.size() > most)
            wrong(fmt::format("a list of {} to {}", least, most));
    }
    std::string text() const {
        if (!json.is_string())
            wrong("text");
        return json.get<std::string>();
    }
    int whole() const {
        // A number above the signed range is stored unsigned and would read as a negative one.
        const bool fits = json.is_number_unsigned()
                              ? json.get<std::uint64_t>() <= INT_MAX
                              : json.is_number_integer() && json.get<std::int64_t>() >= INT_MIN;
        if (!fits)
            wrong("a whole number that is not too large");
        return json.get<int>();
    }
};

Json toJson(const Value& value) {
    return std::visit([](const auto& held) { return Json(held); }, value);
}

Value valueFrom(const Field& field) {
    if (field.json.is_boolean())
        return field.json.get<bool>();
    if (field.json.is_number_integer())
        return field.whole();
    if (field.json.is_number())
        return field.json.get<double>();
    if (field.json.is_string())
        return field.text();
    field.wrong("a number, text, true or false");
}

Json toJson(const RecipeFile& file, const fs::path& folder) {
    std::error_code error;
    const fs::path absolute = fs::absolute(file.path, error).lexically_normal();
    const fs::path relative = absolute.lexically_relative(fs::absolute(folder, error).lexically_normal());
    Json json = {{"file", relative.empty() ? absolute.generic_string() : relative.generic_string()},
                 {"space", file.space}};
    if (!file.hash.empty())
        json["sha1"] = file.hash;
    return json;
}

RecipeFile fileFrom(const Field& field, const fs::path& folder) {
    field.needObject();
    RecipeFile file;
    const fs::path path(field.at("file").text());
    if (path.empty())
        field.at("file").wrong("the name of a file");
    file.path = path.is_absolute() ? path : (folder / path).lexically_normal();
    file.space = field.has("space") ? field.at("space").text() : "";
    if (!file.space.empty())
        color::findSpace(file.space);
    file.hash = field.has("sha1") ? field.at("sha1").text() : "";
    return file;
}

Json toJson(const RecipeExemplar& exemplar, const fs::path& folder) {
    Json json = toJson(exemplar.image, folder);
    if (exemplar.mask)
        json["mask"] = toJson(*exemplar.mask, folder);
    for (const RecipeFile& companion : exemplar.companions)
        json["companions"].push_back(toJson(companion, folder));
    return json;
}

RecipeExemplar exemplarFrom(const Field& field, const fs::path& folder) {
    RecipeExemplar exemplar;
    exemplar.image = fileFrom(field, folder);
    field.only({"file", "space", "sha1", "mask", "companions"});
    if (field.has("mask"))
        exemplar.mask = fileFrom(field.at("mask"), folder);
    if (field.has("companions")) {
        const Field companions = field.at("companions");
        companions.needArray(0, kMostFiles);
        for (std::size_t i = 0; i < companions.json.size(); ++i)
            exemplar.companions.push_back(fileFrom(companions.at(i), folder));
    }
    return exemplar;
}

Size sizeFrom(const Field& field) {
    field.needArray(2, 2);
    return {field.at(std::size_t{0}).whole(), field.at(std::size_t{1}).whole()};
}

Wrap wrapFrom(const Field& field) {
    const std::string axes = field.text();
    if (!axes.empty() && axes != "x" && axes != "y" && axes != "xy")
        field.wrong(R"("", "x", "y" or "xy")");
    return {axes.find('x') != std::string::npos, axes.find('y') != std::string::npos};
}

std::uint64_t seedFrom(const Field& field) {
    if (!field.json.is_number_unsigned())
        field.wrong("a whole number from 0 to 18446744073709551615");
    return field.json.get<std::uint64_t>();
}

void checkFormat(const Field& root) {
    const Field format = root.at("texloom");
    if (format.whole() < 1)
        format.wrong(fmt::format("1 to {}", Recipe::kFormat));
    if (format.whole() > Recipe::kFormat)
        failUsage("The recipe is of format {}, made by a newer Texloom; this one ({}) reads up to {}.",
                  format.whole(), kVersion, Recipe::kFormat);
}

Recipe recipeFrom(const Field& root, const fs::path& folder) {
    if (!root.json.is_object())
        failUsage("A recipe is a JSON object; this is not one.");
    checkFormat(root);
    root.only({"texloom", "version", "method", "parameters", "exemplars", "initial", "size", "wrap", "seed",
               "outputs"});
    Recipe recipe;
    recipe.version = root.has("version") ? root.at("version").text() : "";
    recipe.method = root.at("method").text();
    if (root.has("parameters")) {
        const Field parameters = root.at("parameters");
        parameters.needObject();
        for (const auto& [name, value] : parameters.json.items())
            recipe.parameters[name] = valueFrom(parameters.at(name));
    }
    const Field exemplars = root.at("exemplars");
    exemplars.needArray(1, kMostFiles);
    for (std::size_t i = 0; i < exemplars.json.size(); ++i)
        recipe.exemplars.push_back(exemplarFrom(exemplars.at(i), folder));
    if (root.has("initial"))
        recipe.initial = fileFrom(root.at("initial"), folder);
    recipe.size = sizeFrom(root.at("size"));
    recipe.wrap = root.has("wrap") ? wrapFrom(root.at("wrap")) : Wrap{};
    recipe.seed = root.has("seed") ? seedFrom(root.at("seed")) : 0;
    return recipe;
}

} // namespace

std::string Recipe::toJson(const fs::path& folder) const {
    Json json = {
        {"texloom", kFormat}, {"version", version}, {"method", method}, {"parameters", Json::object()}};
    for (const auto& [name, value] : parameters)
        json["parameters"][name] = texloom::toJson(value);
    json["exemplars"] = Json::array();
    for (const RecipeExemplar& exemplar : exemplars)
        json["exemplars"].push_back(texloom::toJson(exemplar, folder));
    if (initial)
        json["initial"] = texloom::toJson(*initial, folder);
    json["size"] = {size.width, size.height};
    json["wrap"] = std::string(wrap.x ? "x" : "") + (wrap.y ? "y" : "");
    json["seed"] = seed;
    return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

Recipe Recipe::fromJson(std::string_view text, const fs::path& folder) {
    Json json;
    try {
        json = Json::parse(text, [](int depth, Json::parse_event_t, Json&) {
            if (depth > kDeepest)
                failUsage("The recipe is nested more than {} levels deep.", kDeepest);
            return true;
        });
    } catch (const Json::parse_error& error) {
        failUsage("The recipe is not JSON: it breaks off or goes wrong at byte {}.", error.byte);
    } catch (const Json::exception&) {
        failUsage("The recipe holds a number that is too large.");
    }
    return recipeFrom({json, ""}, folder);
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
        throw UsageError(path.string() + ": " + error.what());
    }
}

} // namespace texloom
