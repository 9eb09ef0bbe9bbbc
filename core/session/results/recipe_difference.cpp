#include "core/base/error.h"
#include "core/base/text.h"
#include "core/session/results/result_store.h"

#include <algorithm>
#include <set>

namespace texloom {

namespace {

const Method* knownMethod(const std::string& id) {
    const auto& all = methods();
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const Method& method) { return method.id() == id; });
    return found == all.end() ? nullptr : &*found;
}

const Param* knownParam(const Method* method, const std::string& name) {
    if (method == nullptr)
        return nullptr;
    const auto& all = method->params();
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const Param& param) { return param.name() == name; });
    return found == all.end() ? nullptr : &*found;
}

Message valueText(const Values& values, const std::string& name, const Param* param) {
    const auto found = values.find(name);
    if (found == values.end())
        return {};
    const std::string text = toText(found->second);
    if (std::holds_alternative<bool>(found->second))
        return Message(text);
    if (param == nullptr)
        return Message::verbatim(text);
    for (const Choice& choice : param->choices())
        if (choice.id == text)
            return Message(choice.title);
    return param->unit().empty() ? Message::verbatim(text) : message("{} {}", text, Message(param->unit()));
}

Message methodText(const RecipeStep& step) {
    const Method* const method = knownMethod(step.method);
    return method != nullptr ? Message(method->info().title) : Message::verbatim(step.method);
}

class Table {
public:
    void add(const Message& what, const Message& first, const Message& second) {
        if (first != second)
            m_rows.push_back({what, first, second});
    }
    std::vector<RecipeDifference> take() { return std::move(m_rows); }

private:
    std::vector<RecipeDifference> m_rows;
};

/// Parameters in the order of the method's declaration, then those it does not know.
std::vector<std::string> namesOf(const RecipeStep& first, const RecipeStep& second) {
    std::vector<std::string> names;
    const auto add = [&](const std::string& name) {
        if (std::find(names.begin(), names.end(), name) == names.end())
            names.push_back(name);
    };
    for (const RecipeStep* step : {&first, &second})
        if (const Method* method = knownMethod(step->method))
            for (const Param& param : method->params())
                add(param.name());
    for (const RecipeStep* step : {&first, &second})
        for (const auto& [name, value] : step->parameters)
            add(name);
    return names;
}

void compareSteps(Table& table, const RecipeStep& first, const RecipeStep& second) {
    table.add(TR("Method"), methodText(first), methodText(second));
    for (const std::string& name : namesOf(first, second)) {
        const Param* const a = knownParam(knownMethod(first.method), name);
        const Param* const b = knownParam(knownMethod(second.method), name);
        const Param* const titled = a != nullptr ? a : b;
        table.add(titled != nullptr ? Message(titled->title()) : Message::verbatim(name),
                  valueText(first.parameters, name, a), valueText(second.parameters, name, b));
    }
}

/// The title of a port of one of the recipe's methods, or its id.
Message portTitle(const Recipe& recipe, const std::string& id) {
    for (const RecipeStep& step : recipe.steps)
        if (const Method* method = knownMethod(step.method))
            if (const Port* port = method->info().input(id))
                return Message(port->title);
    return Message::verbatim(id);
}

Message inputText(const Recipe& recipe, const std::string& port) {
    std::vector<std::string> names;
    if (const auto found = recipe.inputs.find(port); found != recipe.inputs.end())
        for (const RecipeFile& file : found->second)
            names.push_back(file.path.filename().string());
    return listOf(names);
}

void compareInputs(Table& table, const Recipe& first, const Recipe& second) {
    std::set<std::string> ports;
    for (const Recipe* recipe : {&first, &second})
        for (const auto& [port, files] : recipe->inputs)
            ports.insert(port);
    for (const std::string& port : ports)
        table.add(portTitle(first.inputs.contains(port) ? first : second, port), inputText(first, port),
                  inputText(second, port));
}

/// Names of the exemplars' files; with the beginning of their hashes where names alone do not tell them
/// apart.
Message filesText(const Recipe& recipe, bool hashes) {
    constexpr std::size_t kTold = 7;
    std::vector<std::string> names;
    for (const RecipeExemplar& exemplar : recipe.exemplars) {
        const std::string name = exemplar.image.path.filename().string();
        names.push_back(hashes ? fmt::format("{} ({})", name, exemplar.image.hash.substr(0, kTold)) : name);
    }
    return listOf(names);
}

Message sizeText(Size size) {
    return message("{} × {} px", size.width, size.height);
}

Message wrapText(Wrap wrap) {
    return Message::verbatim(wrap.x && wrap.y ? "X, Y" : wrap.x ? "X" : wrap.y ? "Y" : "–");
}

/// How many edits each exemplar has had.
Message editsText(const Recipe& recipe) {
    std::vector<std::string> counts;
    for (const RecipeExemplar& exemplar : recipe.exemplars)
        counts.push_back(std::to_string(exemplar.edits.size()));
    return listOf(counts);
}

/// How much each exemplar counts.
Message weightsText(const Recipe& recipe) {
    std::vector<std::string> weights;
    for (const RecipeExemplar& exemplar : recipe.exemplars)
        weights.push_back(numberText(exemplar.weight));
    return listOf(weights);
}

bool sameEdits(const Recipe& first, const Recipe& second) {
    return std::equal(first.exemplars.begin(), first.exemplars.end(), second.exemplars.begin(),
                      second.exemplars.end(),
                      [](const RecipeExemplar& a, const RecipeExemplar& b) { return a.edits == b.edits; });
}

} // namespace

std::vector<RecipeDifference> differences(const Recipe& first, const Recipe& second) {
    Table table;
    const bool sameNames = filesText(first, false) == filesText(second, false);
    table.add(TR("Exemplars"), filesText(first, sameNames), filesText(second, sameNames));
    if (!sameEdits(first, second)) {
        const Message before = editsText(first), after = editsText(second);
        table.add(TR("Edits of exemplars"), before,
                  before == after ? message("{} (other ones)", after) : after);
    }
    if (first.exemplars.size() > 1 && first.exemplars.size() == second.exemplars.size())
        table.add(TR("Weights of exemplars"), weightsText(first), weightsText(second));
    table.add(TR("Size"), sizeText(first.size), sizeText(second.size));
    table.add(TR("Wraps"), wrapText(first.wrap), wrapText(second.wrap));
    table.add(TR("Seed"), Message::verbatim(std::to_string(first.seed)),
              Message::verbatim(std::to_string(second.seed)));
    compareInputs(table, first, second);
    const std::vector<RecipeStep>& a = first.steps;
    const std::vector<RecipeStep>& b = second.steps;
    for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i)
        if (i < a.size() && i < b.size())
            compareSteps(table, a[i], b[i]);
        else
            table.add(TR("Then"), i < a.size() ? methodText(a[i]) : Message(),
                      i < b.size() ? methodText(b[i]) : Message());
    return table.take();
}

} // namespace texloom
