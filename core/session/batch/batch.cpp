#include "core/session/batch/batch.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/io/image_file.h"
#include "core/io/json_field.h"
#include "core/methods/method.h"
#include "core/session/batch/combinations.h"
#include "core/session/export/name_template.h"
#include "core/session/session.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

namespace texloom {

namespace fs = std::filesystem;
using Json = JsonField::Json;

namespace {

constexpr std::size_t kMostRuns = 100000;

/// One list of values that a sweep goes through.
struct Axis {
    std::string name; ///< "patch", "quilting.patch", "seed" or "size"
    std::vector<Json> values;
};

/// A recipe, or why there is none.
struct Read {
    Recipe recipe; ///< without its exemplars
    std::shared_ptr<const std::vector<RecipeExemplar>> exemplars;
    std::string name; ///< see Recipe::name()
    Message problem;
};

/// Recipes that runs share, by their files.
using ReadFiles = std::map<fs::path, Read>;

/// One entry of "runs" as it stands in the file.
struct Run {
    Read read;
    std::vector<Axis> axes;
    bool variedSeeds = false;
    std::string title, output, report, depth, space;
    std::vector<std::string> maps;
    bool sidecar = true;

    Combinations combinations() const {
        std::vector<std::size_t> lengths;
        for (const Axis& axis : axes)
            lengths.push_back(axis.values.size());
        return {lengths, Combinations::Fastest::Last};
    }
};

std::string textOr(const JsonField& field, const std::string& key, const std::string& otherwise) {
    return field.has(key) ? field.at(key).text() : otherwise;
}

std::string choiceOr(const JsonField& field, const std::string& key, const std::vector<std::string>& known) {
    std::string text = textOr(field, key, known.front());
    if (std::find(known.begin(), known.end(), text) == known.end())
        field.at(key).wrong(message("one of {}", listOf({known.begin(), known.end()})));
    return text;
}

template <class Make> Read readRecipe(const Make& make) {
    Read read;
    try {
        read.recipe = make();
    } catch (const Error& error) {
        read.problem = error.message();
    }
    read.name = read.recipe.name();
    read.exemplars = std::make_shared<const std::vector<RecipeExemplar>>(std::move(read.recipe.exemplars));
    read.recipe.exemplars.clear();
    return read;
}

Read recipeFrom(const JsonField& field, const fs::path& folder, ReadFiles& files) {
    if (!field.json().is_string())
        return readRecipe([&] { return Recipe::fromJson(field.json().dump(), folder); });
    const fs::path path = (folder / field.text()).lexically_normal();
    const auto [known, isNew] = files.try_emplace(path);
    if (isNew)
        known->second = readRecipe([&] { return readRun(path); });
    return known->second;
}

std::vector<Axis> axesFrom(const JsonField& field) {
    field.needObject();
    std::vector<Axis> axes;
    for (const auto& [name, values] : field.json().items()) {
        const JsonField list = field.at(name);
        list.needArray(1, kMostRuns);
        axes.push_back({name, {}});
        for (std::size_t i = 0; i < list.size(); ++i) {
            if (name == "size")
                list.at(i).needArray(2, 2);
            else if (name == "region")
                list.at(i).needArray(4, 4);
            else
                list.at(i).value();
            axes.back().values.push_back(list.at(i).json());
        }
    }
    return axes;
}

Run runFrom(const JsonField& field, const fs::path& folder, ReadFiles& files) {
    field.needObject();
    field.only(
        {"title", "recipe", "output", "maps", "report", "depth", "space", "sidecar", "sweep", "seeds"});
    Run run;
    run.read = recipeFrom(field.at("recipe"), folder, files);
    run.output = field.at("output").text();
    if (run.output.empty())
        field.at("output").wrong(TR("the name of a file"));
    run.title = textOr(field, "title", "");
    run.report = textOr(field, "report", "");
    run.depth = choiceOr(field, "depth", {"", "8", "16", "half", "float"});
    run.space = textOr(field, "space", "");
    run.variedSeeds = choiceOr(field, "seeds", {"held", "varied"}) == "varied";
    if (field.has("sidecar")) {
        if (!field.at("sidecar").json().is_boolean())
            field.at("sidecar").wrong(TR("true or false"));
        run.sidecar = field.at("sidecar").json().get<bool>();
    }
    if (field.has("maps")) {
        const JsonField maps = field.at("maps");
        maps.needArray(0, 2);
        for (std::size_t i = 0; i < maps.size(); ++i)
            run.maps.push_back(maps.at(i).text());
    }
    if (field.has("sweep"))
        run.axes = axesFrom(field.at("sweep"));
    return run;
}

/// A value as it stands in names: 32, 0.25, smooth-cut, 512x256; regions as 4096x0x512x256, place and size.
std::string nameText(const Json& value) {
    if (value.is_array()) {
        std::string text;
        for (const Json& number : value)
            text += (text.empty() ? "" : "x") + number.dump();
        return text;
    }
    return value.is_string() ? value.get<std::string>() : value.dump();
}

/// Puts one value of a sweep into a recipe. @throws UsageError
void set(Recipe& recipe, const std::string& name, const Json& value) {
    const Json named = {{name, value}};
    const JsonField field = JsonField("sweep", named).at(name);
    if (name == "seed") {
        if (!value.is_number_unsigned())
            field.wrong(TR("a whole number from 0 to 18446744073709551615"));
        recipe.seed = value.get<std::uint64_t>();
        return;
    }
    if (name == "size") {
        recipe.size = {field.at(std::size_t{0}).whole(), field.at(std::size_t{1}).whole()};
        return;
    }
    if (name == "region") {
        recipe.region = Region{field.at(std::size_t{0}).whole(),
                               field.at(std::size_t{1}).whole(),
                               {field.at(std::size_t{2}).whole(), field.at(std::size_t{3}).whole()}};
        return;
    }
    const std::size_t stop = name.find('.');
    const std::string method = stop == std::string::npos ? recipe.steps.front().method : name.substr(0, stop);
    const std::string param = stop == std::string::npos ? name : name.substr(stop + 1);
    const Value checked = findMethod(method).param(param).checked(field.value());
    for (RecipeStep& step : recipe.steps)
        if (step.method == method) {
            step.parameters[param] = checked;
            return;
        }
    failUsage("The sweep's {} is for {}, which is not one of the methods of this run.", name, method);
}

NameWords wordsFor(const Recipe& recipe, const std::string& name, std::size_t index) {
    const Size size = recipe.region ? recipe.region->size : recipe.size;
    const std::string width = std::to_string(size.width), height = std::to_string(size.height);
    return {{"name", name},
            {"method", methodIds(recipe.steps, "_")},
            {"seed", std::to_string(recipe.seed)},
            {"w", width},
            {"h", height},
            {"size", size.width == size.height ? width : width + "x" + height},
            {"index", std::to_string(index)}};
}

/// The item for one combination of a run's values, `chosen` by axis.
BatchItem itemFor(const Run& run, std::size_t combination, const std::vector<std::size_t>& chosen,
                  std::size_t number, const fs::path& folder) {
    BatchItem item{run.read.recipe, run.read.exemplars, run.read.problem, run.title, {}, {}, {}, {},
                   run.depth,       run.space,          run.sidecar};
    NameWords swept;
    for (std::size_t i = 0; i < run.axes.size(); ++i) {
        const std::string& name = run.axes[i].name;
        const Json& value = run.axes[i].values[chosen[i]];
        swept[name] = nameText(value);
        item.cell += (item.cell.empty() ? "" : ", ") + name + "=" + nameText(value);
        try {
            if (item.problem.empty())
                set(item.recipe, name, value);
        } catch (const Error& error) {
            item.problem = error.message();
        }
    }
    if (run.variedSeeds)
        item.recipe.seed += combination;
    NameWords words = wordsFor(item.recipe, run.read.name, number);
    words.merge(swept);
    const auto path = [&](const std::string& pattern) {
        return pattern.empty() ? fs::path() : (folder / expandName(pattern, words)).lexically_normal();
    };
    item.output = path(run.output);
    item.report = path(run.report);
    for (const std::string& map : run.maps)
        item.maps.push_back(path(map));
    return item;
}

/// Refuses items that would write over one another's files.
void checkOutputs(const std::vector<BatchItem>& items) {
    std::map<fs::path, std::size_t> writers;
    for (std::size_t i = 0; i < items.size(); ++i) {
        if (!items[i].problem.empty())
            continue;
        std::vector<fs::path> files = items[i].maps;
        files.push_back(items[i].output);
        if (!items[i].report.empty())
            files.push_back(items[i].report);
        if (items[i].sidecar)
            files.push_back(fs::path(items[i].output).replace_extension(".json"));
        for (const fs::path& file : files)
            if (const auto [known, added] = writers.try_emplace(file, i); !added)
                failUsage("The batch's {} and {} would both write {}; put $index, or what sets them apart, "
                          "into the name.",
                          items[known->second].label(known->second + 1), items[i].label(i + 1),
                          file.string());
    }
}

} // namespace

Recipe BatchItem::whole() const {
    Recipe all = recipe;
    all.exemplars = *exemplars;
    return all;
}

std::string BatchItem::label(std::size_t number) const {
    return cell.empty() ? fmt::format("run {}", number) : fmt::format("run {} ({})", number, cell);
}

Batch Batch::fromJson(std::string_view text, const fs::path& folder, const fs::path& outputs) {
    const Json json = parseJson(TR("batch"), text);
    const JsonField root(TR("batch"), json);
    if (!json.is_object())
        failUsage("A batch is a JSON object; this is not one.");
    if (const JsonField format = root.at("batch"); format.whole() < 1)
        format.wrong(message("1 to {}", kFormat));
    else if (format.whole() > kFormat)
        failUsage("The batch is of format {}, made for a newer Texloom; this one reads up to {}.",
                  format.whole(), kFormat);
    root.only({"batch", "title", "summary", "runs"});
    const JsonField runs = root.at("runs");
    runs.needArray(1, kMostRuns);
    Batch batch;
    batch.title = textOr(root, "title", "");
    batch.summary = textOr(root, "summary", "");
    ReadFiles files;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const Run run = runFrom(runs.at(i), folder, files);
        const Combinations combinations = run.combinations();
        if (combinations.count() > kMostRuns - batch.items.size())
            failUsage("The batch holds more than {} runs; divide it.", grouped(kMostRuns));
        for (std::size_t k = 0; k < combinations.count(); ++k)
            batch.items.push_back(itemFor(run, k, combinations.at(k), batch.items.size() + 1,
                                          outputs.empty() ? folder : outputs));
    }
    checkOutputs(batch.items);
    for (const auto& [path, read] : files)
        batch.recipes.push_back(path);
    return batch;
}

Shard Shard::parse(std::string_view text) {
    const std::size_t slash = text.find('/');
    std::uint64_t index = 0, count = 0;
    const bool read = slash != std::string_view::npos && parseUnsigned(text.substr(0, slash), index) &&
                      parseUnsigned(text.substr(slash + 1), count);
    if (!read || index < 1 || index > count || count > kMostRuns)
        failUsage("--shard {}: write it as I/N with I from 1 to N, as 3/8.", text);
    return {index - 1, count};
}

} // namespace texloom
