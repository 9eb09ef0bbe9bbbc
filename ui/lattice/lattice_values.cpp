#include "ui/lattice/lattice_values.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace texloom::ui {

namespace {

const std::string kGiven = "given";

bool has(const Method& method, const char* name) {
    return std::any_of(method.params().begin(), method.params().end(),
                       [&](const Param& param) { return param.name() == name; });
}

/// The point of the lattice's tile at the exemplar's corner that stands for `point`.
Vec2 folded(const Lattice& lattice, Vec2 point) {
    const Vec2 at = lattice.coordinates(point);
    return point - lattice.at(std::floor(at.x), std::floor(at.y));
}

} // namespace

bool followsLattice(const Method& method) {
    for (const char* name : {"lattice", "v1-x", "v1-y", "v2-x", "v2-y"})
        if (!has(method, name))
            return false;
    return true;
}

Values latticeValues(const Method& method, const Lattice& lattice, const std::optional<Vec2>& origin) {
    Values values = {{"lattice", kGiven},
                     {"v1-x", lattice.v1.x},
                     {"v1-y", lattice.v1.y},
                     {"v2-x", lattice.v2.x},
                     {"v2-y", lattice.v2.y}};
    if (has(method, "origin-x")) {
        const Vec2 at = origin ? folded(lattice, *origin) : Vec2{};
        values["origin-x"] = at.x;
        values["origin-y"] = at.y;
    }
    if (has(method, "tile-x")) {
        values["tile"] = std::string(origin ? "given" : "best");
        values["tile-x"] = origin ? std::max(0.0, origin->x) : 0.0;
        values["tile-y"] = origin ? std::max(0.0, origin->y) : 0.0;
    }
    return values;
}

Values latticeValues(const Values& settings) {
    Values values;
    for (const char* name :
         {"lattice", "v1-x", "v1-y", "v2-x", "v2-y", "origin-x", "origin-y", "tile", "tile-x", "tile-y"})
        if (const auto found = settings.find(name); found != settings.end())
            values.insert(*found);
    return values;
}

std::optional<Lattice> givenLattice(const Method& method, const Values& values) {
    if (!followsLattice(method) || values.at("lattice") != Value(kGiven))
        return {};
    const auto number = [&](const char* name) { return std::get<double>(values.at(name)); };
    const Lattice lattice{{number("v1-x"), number("v1-y")}, {number("v2-x"), number("v2-y")}};
    return lattice.area() > 0 ? std::optional(lattice) : std::nullopt;
}

bool sameVectors(const Lattice& a, const Lattice& b) {
    return (a.v1 - b.v1).length() < kSameVectors && (a.v2 - b.v2).length() < kSameVectors;
}

QString vectorText(Vec2 vector, int decimals) {
    return QStringLiteral("%1, %2").arg(vector.x, 0, 'f', decimals).arg(vector.y, 0, 'f', decimals);
}

} // namespace texloom::ui
