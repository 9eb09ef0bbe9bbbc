#pragma once

#include "core/base/message.h"
#include "core/base/value.h"

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
    enum class Type { Toggle, Integer, Real, Choice };
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
    /// The entries, in the order of the settings member's enumerators.
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

    using Assign = std::function<void(const Param&, void*, const Value&)>;

    Type m_type = Type::Real;
    std::string m_name, m_title, m_unit, m_help, m_symbol, m_role, m_group = "Method";
    Value m_default;
    std::size_t m_defaultChoice = 0;
    std::optional<double> m_smallest, m_largest, m_scale;
    std::vector<Choice> m_choices;
    std::optional<Condition> m_condition;
    Assign m_assign;
};

/// Declares the parameter that is `member` of a method's settings struct. The member's type gives the
/// parameter's (bool, int, double, or an enum class for a choice) and its initialiser the default.
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
        static_assert(std::is_same_v<Member, bool> || std::is_same_v<Member, int> ||
                      std::is_same_v<Member, double>);
        param.m_type = std::is_same_v<Member, bool>  ? Param::Type::Toggle
                       : std::is_same_v<Member, int> ? Param::Type::Integer
                                                     : Param::Type::Real;
        param.m_default = initial;
        param.m_assign = [member](const Param&, void* settings, const Value& value) {
            static_cast<Settings*>(settings)->*member = std::get<Member>(value);
        };
    }
    return param;
}

} // namespace texloom
