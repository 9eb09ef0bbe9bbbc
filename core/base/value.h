#pragma once

#include <map>
#include <string>
#include <variant>

namespace texloom {

/// One setting's value: a toggle, a whole number, a real number, or the id of a choice.
using Value = std::variant<bool, int, double, std::string>;

/// Settings by name, as recipes, presets, the inspector and the command line hold them.
using Values = std::map<std::string, Value, std::less<>>;

/// The value as a person writes it: "on", "40", "0.25", "smooth-cut".
std::string toText(const Value& value);

} // namespace texloom
