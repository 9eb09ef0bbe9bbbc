#include "core/base/message.h"

#include <fmt/format.h>

namespace texloom {

namespace {

/// The value that a place asks for; `next` counts those that have no number. None if there is none.
const Message* valueFor(std::string_view place, const std::vector<Message>& values, std::size_t& next) {
    const std::string_view number = place.substr(1, place.find_first_of(":}") - 1);
    std::uint64_t index = 0;
    if (number.empty())
        index = next++;
    else if (!parseUnsigned(number, index))
        return nullptr;
    return index < values.size() ? &values[index] : nullptr;
}

} // namespace

Message Message::verbatim(std::string text) {
    Message made(std::move(text));
    made.m_verbatim = true;
    return made;
}

std::string Message::text(const Translate& translate) const {
    std::string pattern = translate && !m_verbatim && !m_pattern.empty() ? translate(m_pattern) : m_pattern;
    if (m_values.empty())
        return pattern;
    std::string filled;
    std::size_t end = 0, next = 0;
    for (const std::string_view place : placesIn(pattern)) {
        const auto begin = static_cast<std::size_t>(place.data() - pattern.data());
        filled.append(pattern, end, begin - end);
        const Message* const value = valueFor(place, m_values, next);
        filled += value != nullptr ? value->text(translate) : std::string(place);
        end = begin + place.size();
    }
    return filled.append(pattern, end);
}

std::vector<std::string_view> placesIn(std::string_view pattern) {
    std::vector<std::string_view> places;
    for (std::size_t begin = pattern.find('{'); begin != std::string_view::npos;) {
        const std::size_t end = pattern.find('}', begin);
        if (end == std::string_view::npos)
            break;
        places.push_back(pattern.substr(begin, end + 1 - begin));
        begin = pattern.find('{', end);
    }
    return places;
}

Message listOf(const std::vector<std::string>& words) {
    if (words.size() < 2)
        return Message::verbatim(words.empty() ? "" : words.front());
    const std::string all = fmt::format("{}", fmt::join(words.begin(), words.end() - 1, ", "));
    return message("{} and {}", all, words.back());
}

} // namespace texloom
