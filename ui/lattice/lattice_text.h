#pragma once

#include "core/analysis/lattice.h"

#include <QString>

namespace texloom::ui {

/// Vectors this near to each other, in pixels, are the same.
inline constexpr double kSameVectors = 0.05;
bool sameVectors(const Lattice& a, const Lattice& b);

/// "120.25, 0.10".
QString vectorText(Vec2 vector, int decimals = 2);

} // namespace texloom::ui
