#include "core/session/export/name_template.h"

#include "core/base/error.h"
#include "core/base/text.h"

#include <vector>

namespace texloom {

namespace {

bool isWordLetter(char letter) {
    return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
           (letter >= '0' && letter <= '9');
}

const std::string& valueOf(std::string_view word, std::string_view pattern, const NameWords& words) {
    const auto found = words.find(word);
    if (found != words.end())
        return found->second;
    std::vector<std::string> known;
    for (const auto& [name, value] : words)
        known.push_back("$" + name);
    failUsage("The name {} holds ${}, which stands for nothing here; use {}.", pattern, word, listOf(known));
}

/// Takes the word that starts at `at` off the pattern, with or without braces.
std::string_view takeWord(std::string_view pattern, std::size_t& at) {
    const bool braces = at < pattern.size() && pattern[at] == '{';
    const std::size_t begin = braces ? at + 1 : at;
    std::size_t end = begin;
    if (braces)
        end = pattern.find('}', begin);
    else
        while (end < pattern.size() && isWordLetter(pattern[end]))
            ++end;
    if (end == std::string_view::npos || end == begin)
        failUsage("The name {} holds a $ without a word after it; write $$ for a dollar sign.", pattern);
    at = end + (braces ? 1 : 0);
    return pattern.substr(begin, end - begin);
}

} // namespace

std::string expandName(std::string_view pattern, const NameWords& words) {
    std::string name;
    for (std::size_t at = 0; at < pattern.size();) {
        const char letter = pattern[at++];
        if (letter != '$') {
            name += letter;
        } else if (at < pattern.size() && pattern[at] == '$') {
            name += '$';
            ++at;
        } else {
            const std::string& value = valueOf(takeWord(pattern, at), pattern, words);
            name += value;
            const bool trailing = !name.empty() && name.back() == '_';
            if (value.empty() && trailing)
                name.pop_back();
        }
    }
    return name;
}

} // namespace texloom
