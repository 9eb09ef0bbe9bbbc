#include "app/cli/param_text.h"

#include <fmt/core.h>

namespace texloom::cli {

using Json = JsonField::Json;

namespace {

const char* typeName(Param::Type type) {
    switch (type) {
    case Param::Type::Toggle:
        return "toggle";
    case Param::Type::Integer:
        return "integer";
    case Param::Type::Real:
        return "real";
    case Param::Type::Choice:
        return "choice";
    case Param::Type::Area:
        return "area";
    case Param::Type::Size:
        return "size";
    case Param::Type::Points:
        break;
    }
    return "points";
}

/// Areas and points depend on the picture: they are always given.
bool hasDefault(const Param& param) {
    return param.type() != Param::Type::Area && param.type() != Param::Type::Points;
}

} // namespace

std::string defaultText(const Param& param) {
    const Value value = param.defaultFor(0);
    if (param.scale())
        return fmt::format("{:.0f} % of the exemplar's shorter side", *param.scale() * 100);
    const auto* size = std::get_if<Wholes>(&value);
    if (size != nullptr && size->empty())
        return "left to the tool";
    const std::string unit = param.unit().empty() ? "" : " " + param.unit();
    return toText(value) + unit;
}

Json toJson(const Param& param) {
    Json json = {{"name", param.name()}, {"title", param.title()}, {"type", typeName(param.type())}};
    if (hasDefault(param))
        json["default"] = texloom::toJson(param.defaultFor(0));
    if (param.scale())
        json["defaultShareOfShorterSide"] = *param.scale();
    if (param.hasRange())
        json["range"] = {param.smallest(), param.largest()};
    for (const Choice& choice : param.choices())
        json["choices"].push_back({{"id", choice.id}, {"title", choice.title}});
    if (const auto& condition = param.condition())
        json["onlyWhen"] = {{condition->name, texloom::toJson(condition->value)}};
    json["unit"] = param.unit();
    json["symbol"] = param.symbol();
    json["help"] = param.help();
    return json;
}

void printParam(const std::string& how, const Param& param) {
    fmt::print("  {}  {}{}\n      {}\n", how, param.limits(),
               hasDefault(param) ? "; default " + defaultText(param) : "", param.help());
    if (const auto& condition = param.condition())
        fmt::print("      Matters only with {}={}.\n", condition->name, toText(condition->value));
}

} // namespace texloom::cli
