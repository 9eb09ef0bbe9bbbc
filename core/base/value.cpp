#include "core/base/value.h"

#include "core/base/text.h"

namespace texloom {

namespace {

std::string joined(const std::vector<std::string>& numbers) {
    std::string text;
    for (const std::string& number : numbers)
        text += (text.empty() ? "" : ",") + number;
    return text;
}

} // namespace

std::string toText(const Value& value) {
    if (const auto* toggle = std::get_if<bool>(&value))
        return *toggle ? "on" : "off";
    if (const auto* whole = std::get_if<int>(&value))
        return std::to_string(*whole);
    if (const auto* real = std::get_if<double>(&value))
        return numberText(*real);
    std::vector<std::string> numbers;
    if (const auto* wholes = std::get_if<Wholes>(&value)) {
        for (const int whole : *wholes)
            numbers.push_back(std::to_string(whole));
        return joined(numbers);
    }
    if (const auto* points = std::get_if<PlanePoints>(&value)) {
        for (const PlanePoint& point : *points)
            numbers.insert(numbers.end(), {numberText(point.x), numberText(point.y)});
        return joined(numbers);
    }
    return std::get<std::string>(value);
}

} // namespace texloom
