#pragma once

#include <map>
#include <string>
#include <string_view>

namespace texloom {

/// What the words of a name template stand for: "name" -> "bark".
using NameWords = std::map<std::string, std::string, std::less<>>;

/// A file's name from a template: each `$word` (letters and digits), or `${word}`, becomes what it stands
/// for, `$$` a dollar sign. Words without a value leave no double underscore behind: "$name_$map" with an
/// empty map is "bark". @throws UsageError that lists the known words.
std::string expandName(std::string_view pattern, const NameWords& words);

} // namespace texloom
