#include "core/base/param.h"

#include "core/base/error.h"
#include "core/base/text.h"

#include <algorithm>
#include <charconv>
#include <climits>
#include <cmath>

namespace texloom {

Param Param::range(double smallest, double largest) && {
    m_smallest = smallest;
    m_largest = largest;
    return std::move(*this);
}

Param Param::unit(std::string text) && {
    m_unit = std::move(text);
    return std::move(*this);
}

Param Param::help(std::string text) && {
    m_help = std::move(text);
    return std::move(*this);
}

Param Param::symbol(std::string text) && {
    m_symbol = std::move(text);
    return std::move(*this);
}

Param Param::group(std::string text) && {
    m_group = std::move(text);
    return std::move(*this);
}

Param Param::scaled(double share) && {
    m_scale = share;
    return std::move(*this);
}

Param Param::when(std::string name, Value value) && {
    m_condition = Condition{std::move(name), std::move(value)};
    return std::move(*this);
}

Param Param::role(std::string_view id) && {
    m_role = id;
    return std::move(*this);
}

Param Param::usual(double from, double to) && {
    m_usualFrom = from;
    m_usualTo = to;
    return std::move(*this);
}

Param Param::upToShare(double share) && {
    m_shareUpTo = share;
    return std::move(*this);
}

Param Param::choices(std::vector<Choice> entries) && {
    m_choices = std::move(entries);
    if (m_type == Type::Choice)
        m_default = m_choices.at(m_defaultChoice).id;
    return std::move(*this);
}

Value Param::defaultFor(int shorterSide) const {
    if (!m_scale || shorterSide <= 0)
        return m_default;
    const double scaled = std::clamp(*m_scale * shorterSide, smallest(), largest());
    if (m_type == Type::Integer)
        return std::min(static_cast<int>(std::lround(scaled)),
                        std::max(shorterSide, static_cast<int>(smallest())));
    return scaled;
}

double Param::largestFor(int shorterSide) const {
    return m_shareUpTo ? std::clamp(*m_shareUpTo * shorterSide, smallest(), largest()) : largest();
}

Message Param::limits() const {
    switch (m_type) {
    case Type::Toggle:
        return TR("on or off");
    case Type::Choice: {
        std::string ids;
        for (const Choice& choice : m_choices)
            ids += (ids.empty() ? "" : ", ") + choice.id;
        return Message::verbatim(ids);
    }
    case Type::Area:
        return TR("x,y,width,height in whole px");
    case Type::Size:
        return message("width,height, each {} to {} px", numberText(smallest()), numberText(largest()));
    case Type::Points:
        return message("{} points as x,y,x,y,… in px", m_pointCount);
    case Type::Integer:
    case Type::Real:
        break;
    }
    if (!hasRange())
        return m_type == Type::Integer ? TR("any whole number") : TR("any number");
    if (m_unit.empty())
        return message("{} to {}", numberText(smallest()), numberText(largest()));
    return message("{} to {} {}", numberText(smallest()), numberText(largest()), Message(m_unit));
}

void Param::refuse(const std::string& value) const {
    const Message title(m_title);
    const bool number = m_type == Type::Integer || m_type == Type::Real;
    if (m_type == Type::Choice)
        failUsage("{} = {}: {} is one of {}.", m_name, value, title, limits());
    if (number && hasRange())
        failUsage("{} = {}: {} goes from {}.", m_name, value, title, limits());
    failUsage("{} = {}: {} is {}.", m_name, value, title, limits());
}

namespace {

/// The id that a value names; empty if it names none. A choice of yes and no may have been a toggle when a
/// recipe was written.
std::string choiceId(const Value& value) {
    if (const auto* toggle = std::get_if<bool>(&value))
        return *toggle ? "yes" : "no";
    const auto* id = std::get_if<std::string>(&value);
    return id != nullptr ? *id : std::string();
}

} // namespace

Value Param::checked(const Value& value) const {
    switch (m_type) {
    case Type::Toggle:
        if (!std::holds_alternative<bool>(value))
            refuse(toText(value));
        return value;
    case Type::Choice: {
        const std::string id = choiceId(value);
        if (std::none_of(m_choices.begin(), m_choices.end(), [&](const Choice& c) { return c.id == id; }))
            refuse(toText(value));
        return id;
    }
    case Type::Area:
    case Type::Size:
        if (!goodWholes(value))
            refuse(toText(value));
        return value;
    case Type::Points:
        if (!goodPoints(value))
            refuse(toText(value));
        return value;
    case Type::Integer:
    case Type::Real:
        break;
    }
    return checkedNumber(value);
}

Value Param::checkedNumber(const Value& value) const {
    double number = 0;
    if (const auto* whole = std::get_if<int>(&value))
        number = *whole;
    else if (const auto* real = std::get_if<double>(&value))
        number = *real;
    else
        refuse(toText(value));
    const bool isWhole = number == std::floor(number);
    const bool tooLarge = m_type == Type::Integer && std::abs(number) > INT_MAX;
    if (!std::isfinite(number) || tooLarge || !inRange(number))
        refuse(toText(value));
    if (m_type == Type::Integer && !isWhole)
        failUsage("{} = {}: this is not a whole number; {}: {}.", m_name, toText(value), Message(m_title),
                  limits());
    if (m_type == Type::Integer)
        return static_cast<int>(number);
    return number;
}

bool Param::goodWholes(const Value& value) const {
    const auto* wholes = std::get_if<Wholes>(&value);
    if (wholes == nullptr)
        return false;
    if (m_type == Type::Size)
        return wholes->empty() || (wholes->size() == 2 && inRange(wholes->at(0)) && inRange(wholes->at(1)));
    return wholes->size() == 4 && wholes->at(0) >= 0 && wholes->at(1) >= 0 && wholes->at(2) > 0 &&
           wholes->at(3) > 0;
}

bool Param::goodPoints(const Value& value) const {
    const auto* points = std::get_if<PlanePoints>(&value);
    return points != nullptr && points->size() == m_pointCount &&
           std::all_of(points->begin(), points->end(), [](const PlanePoint& point) {
               return std::isfinite(point.x) && std::isfinite(point.y);
           });
}

Value Param::parseList(std::string_view text) const {
    std::vector<double> numbers;
    for (std::size_t begin = 0; begin <= text.size() && !text.empty();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        double number = 0;
        if (!parseNumber(text.substr(begin, end - begin), number))
            refuse(std::string(text));
        numbers.push_back(number);
        begin = end + 1;
    }
    if (m_type == Type::Points) {
        if (numbers.size() != 2 * m_pointCount)
            refuse(std::string(text));
        PlanePoints points;
        for (std::size_t i = 0; i < numbers.size(); i += 2)
            points.push_back({numbers[i], numbers[i + 1]});
        return checked(points);
    }
    Wholes wholes;
    for (const double number : numbers) {
        if (number != std::floor(number) || std::abs(number) > INT_MAX)
            refuse(std::string(text));
        wholes.push_back(static_cast<int>(number));
    }
    return checked(wholes);
}
namespace {

/// Refuses a text that is no number, or none that can be held.
[[noreturn]] void refuseNumber(const Param& param, std::string_view text) {
    double number = 0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
    const Message title(param.title());
    if (read.ec == std::errc::result_out_of_range)
        failUsage("{} = {}: this number is too large, or too near 0, to be held; {}: {}.", param.name(), text,
                  title, param.limits());
    failUsage("{} = {}: this is no number in decimal digits, without spaces; {}: {}.", param.name(), text,
              title, param.limits());
}

} // namespace

Value Param::parse(std::string_view text) const {
    if (m_type == Type::Choice)
        return checked(std::string(text));
    if (m_type == Type::Toggle) {
        for (const char* yes : {"on", "true", "yes", "1"})
            if (text == yes)
                return true;
        for (const char* no : {"off", "false", "no", "0"})
            if (text == no)
                return false;
        refuse(std::string(text));
    }
    if (m_type == Type::Area || m_type == Type::Size || m_type == Type::Points)
        return parseList(text);
    double number = 0;
    if (text.empty())
        refuse("(nothing)");
    if (!parseNumber(text, number))
        refuseNumber(*this, text);
    return checked(number);
}

bool Param::applies(const Values& settings) const {
    if (!m_condition)
        return true;
    const auto it = settings.find(m_condition->name);
    return it != settings.end() && it->second == m_condition->value;
}

} // namespace texloom
