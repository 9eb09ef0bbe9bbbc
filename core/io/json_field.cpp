#include "core/io/json_field.h"

#include "core/base/error.h"
#include "core/base/text.h"

#include <algorithm>
#include <climits>
#include <cmath>
#include <cstdint>
#include <set>
#include <type_traits>

namespace texloom {

using Json = JsonField::Json;

namespace {

constexpr int kDeepest = 16;

} // namespace

JsonField JsonField::at(const std::string& key) const {
    const std::string full = m_name.empty() ? key : m_name + "." + key;
    if (!m_json.contains(key))
        failUsage("The {} has no {}.", m_document, full);
    return {m_document, m_json.at(key), full};
}

JsonField JsonField::at(std::size_t index) const {
    return {m_document, m_json.at(index), m_name + "[" + std::to_string(index) + "]"};
}

void JsonField::wrong(const Message& expected) const {
    std::string text = m_json.dump(-1, ' ', false, Json::error_handler_t::replace);
    if (text.size() > 60)
        text = text.substr(0, 57) + "…";
    failUsage("The {}'s {} is {}; it must be {}.", m_document, m_name, text, expected);
}

void JsonField::only(const std::vector<std::string>& known) const {
    for (const auto& [key, value] : m_json.items())
        if (std::find(known.begin(), known.end(), key) == known.end())
            failUsage("The {} has an unknown field {}; the known ones are {}.", m_document,
                      m_name.empty() ? key : m_name + "." + key, listOf(known));
}

void JsonField::needObject() const {
    if (!m_json.is_object())
        wrong(TR("an object"));
}

void JsonField::needArray(std::size_t least, std::size_t most) const {
    if (!m_json.is_array() || m_json.size() < least || m_json.size() > most)
        wrong(message("a list of {} to {}", least, most));
}

std::string JsonField::text() const {
    if (!m_json.is_string())
        wrong(TR("text"));
    auto text = m_json.get<std::string>();
    // The system would take a name to end there.
    if (text.find('\0') != std::string::npos)
        wrong(TR("text without a zero byte"));
    return text;
}

double JsonField::number() const {
    if (!m_json.is_number() || !std::isfinite(m_json.get<double>()))
        wrong(TR("a number"));
    return m_json.get<double>();
}

int JsonField::whole() const {
    // A number above the signed range is stored unsigned and would read as a negative one.
    const bool fits = m_json.is_number_unsigned()
                          ? m_json.get<std::uint64_t>() <= INT_MAX
                          : m_json.is_number_integer() && m_json.get<std::int64_t>() >= INT_MIN;
    if (!fits)
        wrong(TR("a whole number that is not too large"));
    return m_json.get<int>();
}

Value JsonField::value() const {
    if (m_json.is_boolean())
        return m_json.get<bool>();
    if (m_json.is_number_integer())
        return whole();
    if (m_json.is_number())
        return m_json.get<double>();
    if (m_json.is_string())
        return text();
    wrong(TR("a number, text, true or false"));
}

Values JsonField::values() const {
    needObject();
    Values values;
    for (const auto& [name, value] : m_json.items())
        values[name] = at(name).value();
    return values;
}

Json parseJson(const Message& document, std::string_view text) {
    try {
        std::vector<std::set<std::string>> keys; // of the objects around the place that is read
        return Json::parse(text, [&](int depth, Json::parse_event_t event, Json& parsed) {
            if (depth > kDeepest)
                failUsage("The {} is nested more than {} levels deep.", document, kDeepest);
            if (event == Json::parse_event_t::object_start)
                keys.emplace_back();
            else if (event == Json::parse_event_t::object_end)
                keys.pop_back();
            else if (event == Json::parse_event_t::key &&
                     !keys.back().insert(parsed.get<std::string>()).second)
                failUsage("The {} says {} twice in one place; only one of them can hold.", document,
                          parsed.get<std::string>());
            return true;
        });
    } catch (const Json::parse_error& error) {
        failUsage("The {} is not JSON: it breaks off or goes wrong at byte {}.", document, error.byte);
    } catch (const Json::exception&) {
        failUsage("The {} holds a number that is too large.", document);
    }
}

Json toJson(const Value& value) {
    return std::visit(
        [](const auto& held) -> Json {
            if constexpr (std::is_same_v<std::decay_t<decltype(held)>, PlanePoints>) {
                Json list = Json::array();
                for (const PlanePoint& point : held)
                    list.push_back(Json::array({point.x, point.y}));
                return list;
            } else {
                return held;
            }
        },
        value);
}

Json toJson(const Values& values) {
    Json json = Json::object();
    for (const auto& [name, value] : values)
        json[name] = toJson(value);
    return json;
}

} // namespace texloom
