#pragma once

#include "core/math/anamorphosis.h"

namespace texloom::anamorphosis {

/// How the exemplar goes on beyond its borders.
enum class Border { Mirror, Repeat };
enum class Interpolation { Cubic, Linear, Nearest };

/// Parameters of anamorphoses (Raad, thesis 2016, section 5.5).
struct Settings {
    AnamorphosisKind kind = AnamorphosisKind::Sinusoid;
    AnamorphosisAxis axis = AnamorphosisAxis::X;
    double amplitude = 0.5; ///< 0 moves nothing
    int frequency = 3;      ///< waves of the sinusoid
    double scale = 64;      ///< of the turbulence, in pixels
    Border border = Border::Mirror;
    Interpolation interpolation = Interpolation::Cubic;
};

} // namespace texloom::anamorphosis
