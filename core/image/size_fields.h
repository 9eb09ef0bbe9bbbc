#pragma once

#include "core/base/param.h"
#include "core/image/size.h"

namespace texloom {

/// Areas and sizes as members of a settings struct; see field().
template <> struct MemberType<Region> {
    static constexpr Param::Type kType = Param::Type::Area;
    static Value value(const Region& area) {
        return Wholes{area.x, area.y, area.size.width, area.size.height};
    }
    static Region member(const Value& value) {
        const auto& numbers = std::get<Wholes>(value);
        return {numbers.at(0), numbers.at(1), {numbers.at(2), numbers.at(3)}};
    }
};

/// An empty size leaves the choice to the tool.
template <> struct MemberType<Size> {
    static constexpr Param::Type kType = Param::Type::Size;
    static Value value(const Size& size) { return size.empty() ? Wholes{} : Wholes{size.width, size.height}; }
    static Size member(const Value& value) {
        const auto& numbers = std::get<Wholes>(value);
        return numbers.empty() ? Size{} : Size{numbers.at(0), numbers.at(1)};
    }
};

} // namespace texloom
