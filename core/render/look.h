#pragma once

#include "core/render/camera.h"

namespace texloom {

/// What of a material is shown: lit, or one of its maps alone.
enum class Shown { Lit, Color, Normal, Roughness, Metallic, Occlusion, Height, Opacity };

/// What is seen beside the mesh and through it.
enum class Backdrop { Environment, Grey, Nothing };

/// How a material is looked at.
struct Look {
    Camera camera;
    float repeat = 1;    ///< how often the maps lie where they lie once
    float relief = 0;    ///< from the lowest height to the highest, as a share of the maps' side; 0 to 0.3
    float lightTurn = 0; ///< of the environment around the vertical axis, in radians
    float exposure = 0;  ///< in stops
    Shown shown = Shown::Lit;
    Backdrop backdrop = Backdrop::Grey;
    int samples = 1; ///< along each side of a pixel; 1 to 4
};

} // namespace texloom
