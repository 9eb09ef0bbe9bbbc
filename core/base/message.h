#pragma once

#include "core/base/text.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace texloom {

/// A text for the user that can still be translated: an English pattern, such as "{} has {} channels.", and
/// the values for its places. A value is a message, too: verbatim (a number, a file's name) or with a
/// translation of its own (the title of a method). Made by message(), fail() and failUsage(); a text that is
/// marked with TR() is a message without values.
class Message {
public:
    /// The translation of a pattern; the pattern itself where there is none.
    using Translate = std::function<std::string(const std::string& pattern)>;

    Message() = default;
    /// A text marked with TR(). Implicit, so that what takes a message takes such a text.
    Message(const char* text) : m_pattern(text) {}
    explicit Message(std::string pattern, std::vector<Message> values = {})
        : m_pattern(std::move(pattern)), m_values(std::move(values)) {}
    /// A text that is the same in all languages.
    static Message verbatim(std::string text);

    const std::string& pattern() const { return m_pattern; }
    const std::vector<Message>& values() const { return m_values; }
    bool isVerbatim() const { return m_verbatim; }
    bool empty() const { return m_pattern.empty(); }

    /// In English.
    std::string text() const { return m_values.empty() ? m_pattern : text({}); }
    /// In the language that `translate` knows; it is asked for patterns only, those of values included.
    std::string text(const Translate& translate) const;

    friend bool operator==(const Message&, const Message&) = default;

private:
    std::string m_pattern;
    std::vector<Message> m_values;
    bool m_verbatim = false;
};

/// The places for values in a pattern: "{}" or "{:.1f}", and in a translation also "{1}", which is the second
/// value wherever it stands.
std::vector<std::string_view> placesIn(std::string_view pattern);

/// "a", "a and b" or "a, b and c" of words without translation, such as ids.
Message listOf(const std::vector<std::string>& words);

/// A literal with a place for each of the values, checked when it is compiled.
template <class... Args> class MessagePattern {
public:
    template <std::size_t N> consteval MessagePattern(const char (&text)[N]) : m_text(text) {
#if !defined(__clang__) || __clang_major__ > 14 // clang 14 does not see that the call is within a constant
        [[maybe_unused]] const fmt::format_string<Args...> checked(text);
#endif
        // A translation could not tell "{{" or "{1}" from a place of its own.
        const std::string_view view(text);
        for (std::size_t i = 0; i + 1 < view.size(); ++i)
            if (view[i] == '{' && view[i + 1] != '}' && view[i + 1] != ':')
                throw "the places of a message are {} or {:…}";
        if (std::count(view.begin(), view.end(), '{') != static_cast<std::ptrdiff_t>(sizeof...(Args)))
            throw "a message has as many places as values";
    }
    const char* text() const {
        return m_text;
    }

private:
    const char* m_text;
};

/// A value as `place` ("{:.1f}") says.
template <class T> Message messageValue(std::string_view place, const T& value) {
    if constexpr (std::is_same_v<T, Message>)
        return value;
    else
        return Message::verbatim(
            fmt::vformat(fmt::string_view(place.data(), place.size()), fmt::make_format_args(value)));
}

/// A message from a pattern and its values. Those that have a translation of their own are to be given as
/// Message; texts count as verbatim.
template <class... Args>
Message message(MessagePattern<std::type_identity_t<Args>...> pattern, const Args&... args) {
    [[maybe_unused]] const std::vector<std::string_view> places = placesIn(pattern.text());
    [[maybe_unused]] std::size_t next = 0;
    std::vector<Message> values;
    values.reserve(sizeof...(Args));
    (values.push_back(messageValue(places[next++], args)), ...);
    return Message(pattern.text(), std::move(values));
}

} // namespace texloom

namespace fmt {

/// A message in English.
template <> struct formatter<texloom::Message> {
    constexpr auto parse(format_parse_context& context) { return context.begin(); }
    template <class Context> auto format(const texloom::Message& message, Context& context) const {
        const std::string text = message.text();
        return std::copy(text.begin(), text.end(), context.out());
    }
};

} // namespace fmt
