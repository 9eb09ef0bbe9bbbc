#include "core/session/batch/batch.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/io/image_file.h"
#include "core/io/json_field.h"
#include "core/methods/method.h"
#include "core/session/batch/combinations.h"
#include "core/session/export/name_template.h"
#include "core/session/session.h"
#include "core/tools/tool.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <unordered_map>
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
    const Tool* join = nullptr; ///< where a tool joins the exemplars
    std::string name;           ///< see Recipe::name()
    Message problem;
};

using SharedRead = std::shared_ptr<const Read>;

/// Recipes that runs share, by their files.
using ReadFiles = std::map<fs::path, SharedRead>;

std::string textOr(const JsonField& field, const std::string& key, const std::string& otherwise) {
    return field.has(key) ? field.at(key).text() : otherwise;
}

std::string choiceOr(const JsonField& field, const std::string& key, const std::vector<std::string>& known) {
    std::string text = textOr(field, key, known.front());
    if (std::find(known.begin(), known.end(), text) == known.end())
        field.at(key).wrong(message("one of {}", listOf({known.begin(), known.end()})));
    return text;
}

template <class Make> SharedRead readRecipe(const Make& make) {
    Read read;
    try {
        read.recipe = make();
    } catch (const Error& error) {
        read.problem = error.message();
    }
    read.name = read.recipe.name();
    read.exemplars = std::make_shared<const std::vector<RecipeExemplar>>(std::move(read.recipe.exemplars));
    read.recipe.exemplars.clear();
    return std::make_shared<const Read>(std::move(read));
}

SharedRead recipeFrom(const JsonField& field, const fs::path& folder, ReadFiles& files) {
    if (!field.json().is_string())
        return readRecipe([&] { return Recipe::fromJson(field.json().dump(), folder); });
    const fs::path path = (folder / field.text()).lexically_normal();
    const auto [known, isNew] = files.try_emplace(path);
    if (isNew)
        known->second = readRecipe([&] { return readRun(path); });
    return known->second;
}

/// Two images to be joined by a tool, as a recipe whose only step is that tool.
SharedRead joinFrom(const JsonField& field, const fs::path& folder) {
    field.needObject();
    field.only({"tool", "exemplars", "parameters"});
    const Tool& tool = findTool(field.at("tool").text());
    if (!tool.joins())
        failUsage("{} edits one image and joins no two; leave it to the edits of an exemplar.", tool.id());
    field.at("exemplars").needArray(2, 2);
    const auto read = readRecipe([&] {
        Recipe recipe;
        recipe.steps = {{tool.id(), field.has("parameters") ? field.at("parameters").values() : Values{}}};
        tool.resolved(recipe.steps.front().parameters);
        recipe.exemplars = exemplarsFrom(field.at("exemplars"), folder);
        return recipe;
    });
    Read joined = *read;
    joined.join = &tool;
    return std::make_shared<const Read>(std::move(joined));
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

/// A value as it stands in names: 32, 0.25, smooth-cut, 512x256; regions as 4096x0x512x256, place and size.
std::string nameText(const Json& value) {
    if (value.is_array()) {
        std::string text;
        for (const Json& number : value) {
            text += text.empty() ? "" : "x";
            text += number.dump();
        }
        return text;
    }
    return value.is_string() ? value.get<std::string>() : value.dump();
}

/// Puts one value of a sweep into a recipe. @throws UsageError
void set(Recipe& recipe, const Tool* join, const std::string& name, const Json& value) {
    const Json named = {{name, value}};
    const JsonField field = JsonField("sweep", named).at(name);
    if (join != nullptr) {
        recipe.steps.front().parameters[name] = join->param(name).checked(field.value());
        return;
    }
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

/// Names of files with a swept item's words in them.
fs::path namedBy(const std::string& pattern, const NameWords& words, const fs::path& folder) {
    return pattern.empty() ? fs::path() : (folder / expandName(pattern, words)).lexically_normal();
}

std::vector<std::string> filesOf(const BatchItem& item) {
    std::vector<std::string> files{item.output.string()};
    for (const fs::path& map : item.maps)
        files.push_back(map.string());
    if (!item.report.empty())
        files.push_back(item.report.string());
    if (item.sidecar)
        files.push_back(fs::path(item.output).replace_extension(".json").string());
    return files;
}

} // namespace

/// One entry of "runs" as it stands in the file.
struct Batch::Run {
    SharedRead read;
    std::vector<Axis> axes;
    bool variedSeeds = false;
    std::string title, output, report, depth, space;
    std::vector<std::string> maps;
    bool sidecar = true;

    static Run from(const JsonField& field, const fs::path& folder, ReadFiles& files);
    Combinations combinations() const;
    /// @param number of the item in the whole batch, from 1.
    BatchItem itemFor(std::size_t combination, std::size_t number, const fs::path& folder) const;
};

Batch::Run Batch::Run::from(const JsonField& field, const fs::path& folder, ReadFiles& files) {
    field.needObject();
    Run run;
    if (field.has("join")) { // a picture alone is written
        field.only({"title", "join", "output", "sweep"});
        run.read = joinFrom(field.at("join"), folder);
        run.sidecar = false;
    } else {
        field.only(
            {"title", "recipe", "output", "maps", "report", "depth", "space", "sidecar", "sweep", "seeds"});
        run.read = recipeFrom(field.at("recipe"), folder, files);
    }
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

Combinations Batch::Run::combinations() const {
    std::vector<std::size_t> lengths;
    for (const Axis& axis : axes)
        lengths.push_back(axis.values.size());
    return {lengths, Combinations::Fastest::Last};
}

BatchItem Batch::Run::itemFor(std::size_t combination, std::size_t number, const fs::path& folder) const {
    BatchItem item{read->recipe, read->exemplars, read->join, read->problem, title, {}, {}, {},
                   {},           depth,           space,      sidecar};
    const std::vector<std::size_t> chosen = combinations().at(combination);
    NameWords swept;
    for (std::size_t i = 0; i < axes.size(); ++i) {
        const std::string& name = axes[i].name;
        const Json& value = axes[i].values[chosen[i]];
        swept[name] = nameText(value);
        item.cell += (item.cell.empty() ? "" : ", ") + name + "=" + nameText(value);
        try {
            if (item.problem.empty())
                set(item.recipe, read->join, name, value);
        } catch (const Error& error) {
            item.problem = error.message();
        }
    }
    if (variedSeeds)
        item.recipe.seed += combination;
    NameWords words = wordsFor(item.recipe, read->name, number);
    if (read->join != nullptr && read->exemplars->size() == 2)
        words["second"] = read->exemplars->back().image.path.stem().string();
    words.merge(swept);
    item.output = namedBy(output, words, folder);
    item.report = namedBy(report, words, folder);
    for (const std::string& map : maps)
        item.maps.push_back(namedBy(map, words, folder));
    return item;
}

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
    batch.m_folder = outputs.empty() ? folder : outputs;
    ReadFiles files;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        batch.m_runs.push_back(std::make_shared<const Run>(Run::from(runs.at(i), folder, files)));
        batch.m_firsts.push_back(batch.m_size);
        const std::size_t count = batch.m_runs.back()->combinations().count();
        if (count > kMostRuns - batch.m_size)
            failUsage("The batch holds more than {} runs; divide it.", grouped(kMostRuns));
        batch.m_size += count;
    }
    batch.checkOutputs();
    for (const auto& [path, read] : files)
        batch.m_recipes.push_back(path);
    return batch;
}

BatchItem Batch::item(std::size_t index) const {
    const auto after = std::upper_bound(m_firsts.begin(), m_firsts.end(), index);
    const auto run = static_cast<std::size_t>(after - m_firsts.begin()) - 1;
    return m_runs[run]->itemFor(index - m_firsts[run], index + 1, m_folder);
}

std::vector<fs::path> Batch::sources() const {
    std::vector<fs::path> sources;
    const Read* known = nullptr;
    for (const std::shared_ptr<const Run>& run : m_runs)
        if (run->read.get() != std::exchange(known, run->read.get())) {
            Recipe whole = known->recipe;
            whole.exemplars = *known->exemplars;
            for (const RecipeFile* file : whole.files())
                sources.push_back(file->path);
        }
    return sources;
}

void Batch::checkOutputs() const {
    std::unordered_map<std::string, std::size_t> writers;
    for (std::size_t i = 0; i < m_size; ++i) {
        const BatchItem one = item(i);
        if (!one.problem.empty())
            continue;
        for (std::string& file : filesOf(one))
            if (const auto [known, added] = writers.try_emplace(std::move(file), i); !added)
                failUsage("The batch's {} and {} would both write {}; put $index, or what sets them apart, "
                          "into the name.",
                          item(known->second).label(known->second + 1), one.label(i + 1), known->first);
    }
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
