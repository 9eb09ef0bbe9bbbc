#pragma once

#include "core/methods/solid_request.h"

namespace texloom::solid_optimise {

/// How the solid is made.
enum class Model { PatchDistribution, HeegerBergen, Kopf, Wei };

struct Settings : SliceSettings {
    Model model = Model::PatchDistribution;
    int side = 64;       ///< of the solid in voxels
    int patch = 7;       ///< side of the compared neighbourhoods in slices
    int scales = 4;      ///< at most
    int iterations = 40; ///< at each scale, or of the whole pyramid
    int directions = 12; ///< along which patches are compared in one iteration
};

} // namespace texloom::solid_optimise
