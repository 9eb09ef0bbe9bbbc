#include "core/base/value.h"

#include "core/base/text.h"

namespace texloom {

std::string toText(const Value& value) {
    if (const auto* toggle = std::get_if<bool>(&value))
        return *toggle ? "on" : "off";
    if (const auto* whole = std::get_if<int>(&value))
        return std::to_string(*whole);
    if (const auto* real = std::get_if<double>(&value))
        return numberText(*real);
    return std::get<std::string>(value);
}

} // namespace texloom
