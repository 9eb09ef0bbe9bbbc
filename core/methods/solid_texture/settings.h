#pragma once

#include "core/methods/solid_request.h"

namespace texloom::solid_texture {

struct Settings : SliceSettings {
    int iterations = 1000;
    int trainSide = 64;     ///< of the slices that are compared
    int slices = 1;         ///< of each direction in one iteration
    double rate = 0.02;     ///< of Adam
    double patchWeight = 1; ///< of the distribution of patches beside the descriptor
    double descriptorWeight = 1;
};

} // namespace texloom::solid_texture
