#pragma once

#include "core/base/message.h"
#include "core/base/value.h"

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace texloom {

/// One entry of a parameter that chooses among a few ways.
struct Choice {
    std::string id;    ///< kebab-case, as recipes and the command line write it
    std::string title; ///< as the window shows it
};

/// Declares one parameter of a method: everything that the inspector, the command line, recipes and the
/// documentation need to know of it. Made by field(); the default is that of the member of the settings
/// struct.
class Param {
public:
    enum class Type {
        Toggle,
        Integer,
        Real,
        Choice,
        Area,  ///< a rectangle of pixels, at least one, none at negative coordinates
        Size,  ///< width and height in pixels, or nothing: left to the tool
        Points ///< as many points of an image as the settings member has
    };
    /// Says that a parameter matters only while another has this value.
    struct Condition {
        std::string name;
        Value value;
    };

    /// Smallest and largest value allowed, both included.
    Param range(double smallest, double largest) &&;
    /// Unit as shown after the value, such as "px".
    Param unit(std::string text) &&;
    /// One sentence that says what a larger or smaller value does.
    Param help(std::string text) &&;
    /// The source's own letter for it, such as "w_o".
    Param symbol(std::string text) &&;
    /// The heading under which the inspector shows it; "Method" if never said.
    Param group(std::string text) &&;
    /// The default becomes `share` of the exemplar's shorter side, within the range.
    Param scaled(double share) &&;
    /// The parameter matters only while `name` has `value`.
    Param when(std::string name, Value value) &&;
    /// What it stands for in every method that has such a parameter, whatever its name; see role() const.
    Param role(std::string_view id) &&;
    /// The part of the range that a slider offers; the whole range can still be typed.
    Param usual(double from, double to) &&;
    /// The largest value that suits an image, as a share of its shorter side; what it is for checks for
    /// itself.
    Param upToShare(double share) &&;
    /// The entries, in the order of the settings member's enumerators; of points, their names.
    Param choices(std::vector<Choice> entries) &&;

    Type type() const { return m_type; }
    const std::string& name() const { return m_name; }
    const std::string& title() const { return m_title; }
    const std::string& unit() const { return m_unit; }
    const std::string& help() const { return m_help; }
    const std::string& symbol() const { return m_symbol; }
    const std::string& group() const { return m_group; }
    /// One of the ids that those who share a meaning agree on, such as lattice_role::kFirstRight; empty for a
    /// parameter that means something to its own method alone.
    const std::string& role() const { return m_role; }
    const std::vector<Choice>& choices() const { return m_choices; }
    const std::optional<Condition>& condition() const { return m_condition; }
    bool hasRange() const { return m_smallest.has_value(); }
    double smallest() const { return m_smallest.value_or(0); }
    double largest() const { return m_largest.value_or(0); }
    /// The part of the range that is usual; all of it if nothing else was said.
    double usualFrom() const { return m_usualFrom.value_or(smallest()); }
    double usualTo() const { return m_usualTo.value_or(largest()); }
    /// The largest value that suits an image whose shorter side is `shorterSide` px; largest() if that is not
    /// said.
    double largestFor(int shorterSide) const;
    /// How many points a parameter of points has.
    std::size_t pointCount() const { return m_pointCount; }
    /// The default's share of the exemplar's shorter side, if it scales.
    const std::optional<double>& scale() const { return m_scale; }

    /// The default for an exemplar whose shorter side is `shorterSide` px; 0 stands for an unknown exemplar
    /// and gives the member's own default.
    Value defaultFor(int shorterSide) const;
    /// The value, checked and in the parameter's own type: a real without a fraction passes for an integer,
    /// and true and false for the choices yes and no, as in recipes from when the parameter was a toggle.
    /// @throws UsageError with name, value and limits.
    Value checked(const Value& value) const;
    /// Reads the value from text as written on a command line. @throws UsageError as checked().
    Value parse(std::string_view text) const;
    /// "4 to 512 px", "on or off", or "cut, smooth-cut".
    Message limits() const;
    /// Whether the parameter matters under these settings.
    bool applies(const Values& settings) const;

    /// Writes a checked value into the settings struct behind `settings`.
    void assign(void* settings, const Value& value) const { m_assign(*this, settings, value); }

private:
    Param() = default;
    template <class Settings, class Member>
    friend Param field(Member Settings::*member, std::string name, std::string title);
    [[noreturn]] void refuse(const std::string& value) const;
    Value checkedNumber(const Value& value) const;
    bool goodWholes(const Value& value) const;
    bool goodPoints(const Value& value) const;
    bool inRange(double number) const { return !hasRange() || (number >= smallest() && number <= largest()); }
    Value parseList(std::string_view text) const;

    using Assign = std::function<void(const Param&, void*, const Value&)>;

    Type m_type = Type::Real;
    std::string m_name, m_title, m_unit, m_help, m_symbol, m_role, m_group = "Method";
    Value m_default;
    std::size_t m_defaultChoice = 0, m_pointCount = 0;
    std::optional<double> m_smallest, m_largest, m_scale, m_usualFrom, m_usualTo, m_shareUpTo;
    std::vector<Choice> m_choices;
    std::optional<Condition> m_condition;
    Assign m_assign;
};

/// How a settings member of type `Member` is a parameter: which type that has, and how its values are told
/// apart and put together. Specialised for what has more than one number.
template <class Member> struct MemberType {
    static_assert(std::is_same_v<Member, bool> || std::is_same_v<Member, int> ||
                  std::is_same_v<Member, double>);
    static constexpr Param::Type kType = std::is_same_v<Member, bool>  ? Param::Type::Toggle
                                         : std::is_same_v<Member, int> ? Param::Type::Integer
                                                                       : Param::Type::Real;
    static Value value(const Member& member) { return member; }
    static Member member(const Value& value) { return std::get<Member>(value); }
};

template <std::size_t Count> struct MemberType<std::array<PlanePoint, Count>> {
    static constexpr Param::Type kType = Param::Type::Points;
    static Value value(const std::array<PlanePoint, Count>& points) {
        return PlanePoints(points.begin(), points.end());
    }
    static std::array<PlanePoint, Count> member(const Value& value) {
        std::array<PlanePoint, Count> points;
        std::copy_n(std::get<PlanePoints>(value).begin(), Count, points.begin());
        return points;
    }
};

/// Declares the parameter that is `member` of a settings struct. The member's type gives the parameter's
/// (bool, int, double, an enum class for a choice, points, and with core/image/size_fields.h areas and sizes)
/// and its initialiser the default.
/// @param name kebab-case, as recipes and `--set` write it; @param title as the window shows it.
template <class Settings, class Member>
Param field(Member Settings::*member, std::string name, std::string title) {
    Param param;
    param.m_name = std::move(name);
    param.m_title = std::move(title);
    const Member initial = Settings{}.*member;
    if constexpr (std::is_enum_v<Member>) {
        param.m_type = Param::Type::Choice;
        param.m_defaultChoice = static_cast<std::size_t>(initial);
        param.m_assign = [member](const Param& self, void* settings, const Value& value) {
            const std::string& id = std::get<std::string>(value);
            for (std::size_t i = 0; i < self.m_choices.size(); ++i)
                if (self.m_choices[i].id == id)
                    static_cast<Settings*>(settings)->*member = static_cast<Member>(i);
        };
    } else {
        using Type = MemberType<Member>;
        param.m_type = Type::kType;
        param.m_default = Type::value(initial);
        if (const auto* points = std::get_if<PlanePoints>(&param.m_default))
            param.m_pointCount = points->size();
        param.m_assign = [member](const Param&, void* settings, const Value& value) {
            static_cast<Settings*>(settings)->*member = Type::member(value);
        };
    }
    return param;
}

} // namespace texloom
