#include "core/analysis/lattice_values.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace texloom {

namespace {

constexpr std::array kNeeded = {lattice_role::kSource, lattice_role::kFirstRight, lattice_role::kFirstDown,
                                lattice_role::kSecondRight, lattice_role::kSecondDown};
constexpr std::array kPlaces = {lattice_role::kOriginRight, lattice_role::kOriginDown,
                                lattice_role::kTileRight, lattice_role::kTileDown};

/// The parameter of this role, or null.
const Param* of(const std::vector<Param>& params, std::string_view role) {
    const auto found =
        std::find_if(params.begin(), params.end(), [&](const Param& param) { return param.role() == role; });
    return found != params.end() ? &*found : nullptr;
}

/// Sets the parameter of this role, where there is one, and the one that enables it.
void give(const std::vector<Param>& params, std::string_view role, double value, Values& values) {
    const Param* const param = of(params, role);
    if (param == nullptr)
        return;
    values[param->name()] = value;
    if (const auto& condition = param->condition())
        values[condition->name] = condition->value;
}

/// Resets the parameter of this role, and the one that enables it, to their defaults.
void leave(const std::vector<Param>& params, std::string_view role, Values& values) {
    const Param* const param = of(params, role);
    if (param == nullptr)
        return;
    values[param->name()] = param->defaultFor(0);
    for (const Param& other : params)
        if (param->condition() && other.name() == param->condition()->name)
            values[other.name()] = other.defaultFor(0);
}

/// The point of the lattice's tile at the exemplar's corner that stands for `point`.
Vec2 folded(const Lattice& lattice, Vec2 point) {
    const Vec2 at = lattice.coordinates(point);
    return point - lattice.at(std::floor(at.x), std::floor(at.y));
}

} // namespace

bool followsLattice(const std::vector<Param>& params) {
    return std::all_of(kNeeded.begin(), kNeeded.end(),
                       [&](std::string_view role) { return of(params, role) != nullptr; });
}

Values latticeValues(const std::vector<Param>& params, const Lattice& lattice,
                     const std::optional<Vec2>& origin) {
    Values values;
    give(params, lattice_role::kFirstRight, lattice.v1.x, values);
    give(params, lattice_role::kFirstDown, lattice.v1.y, values);
    give(params, lattice_role::kSecondRight, lattice.v2.x, values);
    give(params, lattice_role::kSecondDown, lattice.v2.y, values);
    if (!origin) {
        for (const std::string_view role : kPlaces)
            leave(params, role, values);
        return values;
    }
    const Vec2 phase = folded(lattice, *origin);
    give(params, lattice_role::kOriginRight, phase.x, values);
    give(params, lattice_role::kOriginDown, phase.y, values);
    give(params, lattice_role::kTileRight, std::max(0.0, origin->x), values);
    give(params, lattice_role::kTileDown, std::max(0.0, origin->y), values);
    return values;
}

Values latticeValues(const std::vector<Param>& params, const Values& settings) {
    Values values;
    const auto keep = [&](const std::string& name) {
        if (const auto found = settings.find(name); found != settings.end())
            values.insert(*found);
    };
    for (const Param& param : params) {
        const auto isIts = [&](std::string_view role) { return param.role() == role; };
        if (std::none_of(kNeeded.begin(), kNeeded.end(), isIts) &&
            std::none_of(kPlaces.begin(), kPlaces.end(), isIts))
            continue;
        keep(param.name());
        if (param.condition())
            keep(param.condition()->name);
    }
    return values;
}

LatticeSource latticeSource(const std::vector<Param>& params, const Values& settings) {
    const Param& source = *of(params, lattice_role::kSource);
    for (const LatticeSource known : {LatticeSource::Given, LatticeSource::None})
        if (settings.at(source.name()) == Value(source.choices().at(static_cast<std::size_t>(known)).id))
            return known;
    return LatticeSource::Automatic;
}

std::optional<Lattice> givenLattice(const std::vector<Param>& params, const Values& settings) {
    if (!followsLattice(params) || latticeSource(params, settings) != LatticeSource::Given)
        return {};
    const auto number = [&](std::string_view role) {
        return std::get<double>(settings.at(of(params, role)->name()));
    };
    const Lattice lattice{{number(lattice_role::kFirstRight), number(lattice_role::kFirstDown)},
                          {number(lattice_role::kSecondRight), number(lattice_role::kSecondDown)}};
    return lattice.area() > 0 ? std::optional(lattice) : std::nullopt;
}

} // namespace texloom
