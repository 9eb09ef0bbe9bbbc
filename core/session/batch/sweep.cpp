#include "core/session/batch/sweep.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/session/batch/combinations.h"

#include <algorithm>
#include <climits>
#include <cmath>
#include <functional>

namespace texloom {

namespace {

constexpr double kMostValues = static_cast<double>(kMostSweepCells);

std::string_view trimmed(std::string_view text) {
    const auto first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos)
        return {};
    return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(separator, begin), text.size());
        parts.push_back(trimmed(text.substr(begin, end - begin)));
        begin = end + 1;
    }
    return parts;
}

/// The numbers of from:to:count as texts; whole ones if `whole`.
std::vector<std::string> spaced(std::string_view text, bool whole) {
    const std::vector<std::string_view> parts = split(text, ':');
    double from = 0, to = 0, count = 0;
    if (parts.size() != 3 || !parseNumber(parts[0], from) || !parseNumber(parts[1], to) ||
        !parseNumber(parts[2], count) || count < 2 || count > kMostValues || count != std::floor(count))
        failUsage("“{}” is not from:to:count, such as 8:64:5, with a count of 2 to {}.", text,
                  kMostSweepCells);
    std::vector<std::string> texts;
    for (int i = 0; i < static_cast<int>(count); ++i) {
        const double share = i / (count - 1);
        const double value = from + (to - from) * share;
        constexpr double kDigits = 1e6;
        texts.push_back(numberText(whole ? std::round(value) : std::round(value * kDigits) / kDigits));
    }
    return texts;
}

/// Reads a list whose entries `parse` reads; `whole` is for what lies between.
std::vector<Value> valuesIn(std::string_view text, bool whole,
                            const std::function<Value(std::string_view)>& parse) {
    std::vector<Value> values;
    const auto add = [&](std::string_view entry) {
        const Value value = parse(entry);
        if (std::find(values.begin(), values.end(), value) == values.end())
            values.push_back(value);
    };
    for (const std::string_view entry : split(text, ',')) {
        if (entry.empty())
            continue;
        if (entry.find(':') == std::string_view::npos)
            add(entry);
        else
            for (const std::string& between : spaced(entry, whole))
                add(between);
    }
    return values;
}

SweepCell::Part partOf(const Param& parameter, const Value& value) {
    SweepCell::Part part{parameter.title(), toText(value), parameter.unit()};
    if (const bool* on = std::get_if<bool>(&value))
        part.value = *on ? TR("on") : TR("off");
    for (const Choice& choice : parameter.choices())
        if (choice.id == part.value)
            part.value = choice.title;
    return part;
}

/// Sets one axis's value. @return what a label says of it.
SweepCell::Part apply(const SweepAxis& axis, const Value& value, RunInput& input) {
    if (axis.parameter.empty()) {
        input.seed = static_cast<std::uint64_t>(std::get<int>(value));
        return {TR("Seed"), std::to_string(input.seed), ""};
    }
    RecipeStep& step = input.steps.at(axis.step);
    step.parameters[axis.parameter] = value;
    return partOf(findMethod(step.method).param(axis.parameter), value);
}

} // namespace

std::vector<Value> sweepValues(const Param& parameter, std::string_view text) {
    return valuesIn(text, parameter.type() == Param::Type::Integer,
                    [&](std::string_view entry) { return parameter.parse(entry); });
}

std::vector<Value> sweepSeeds(std::string_view text) {
    return valuesIn(text, true, [](std::string_view entry) -> Value {
        std::uint64_t seed = 0;
        if (!parseUnsigned(entry, seed) || seed > INT_MAX)
            failUsage("The seed “{}” is not a whole number from 0 to {}.", entry, INT_MAX);
        return static_cast<int>(seed);
    });
}

std::vector<SweepCell> sweepCells(const RunInput& input, const std::vector<SweepAxis>& axes, bool varySeed) {
    std::vector<std::size_t> lengths;
    for (const SweepAxis& axis : axes)
        lengths.push_back(axis.values.size());
    const Combinations combinations(lengths, Combinations::Fastest::First);
    if (combinations.count() > kMostSweepCells)
        failUsage("These are {} runs; a sweep has at most {}.", combinations.count(), kMostSweepCells);
    std::vector<SweepCell> cells;
    for (std::size_t i = 0; i < combinations.count(); ++i) {
        SweepCell& cell = cells.emplace_back();
        cell.input = input;
        if (varySeed)
            cell.input.seed += i;
        const std::vector<std::size_t> chosen = combinations.at(i);
        for (std::size_t axis = 0; axis < axes.size(); ++axis)
            cell.parts.push_back(apply(axes[axis], axes[axis].values[chosen[axis]], cell.input));
    }
    return cells;
}

} // namespace texloom
