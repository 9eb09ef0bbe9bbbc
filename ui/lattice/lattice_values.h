#pragma once

#include "core/analysis/lattice.h"
#include "core/methods/method.h"

#include <QString>

#include <optional>

namespace texloom::ui {

/// Whether a method has the parameters of a lattice (core/analysis/lattice_settings.h).
bool followsLattice(const Method& method);

/// The settings by which a method that follows a lattice uses this one.
/// @param origin where a tile begins, in pixels of the exemplar; none where the method chooses.
Values latticeValues(const Method& method, const Lattice& lattice, const std::optional<Vec2>& origin);

/// Those of a method's settings that say which lattice it uses, and where it begins.
Values latticeValues(const Values& settings);

/// The lattice that these settings of the method give; none where it finds one by itself or follows none.
std::optional<Lattice> givenLattice(const Method& method, const Values& values);

/// Vectors this near to each other, in pixels, are the same.
inline constexpr double kSameVectors = 0.05;
bool sameVectors(const Lattice& a, const Lattice& b);

/// "120.25, 0.10".
QString vectorText(Vec2 vector, int decimals = 2);

} // namespace texloom::ui
