#pragma once

#include "core/math/random_phases.h"

namespace texloom::random_phase {

/// Parameters of random phase textures (Galerne, Gousseau & Morel 2011).
struct Settings {
    PhaseModel model = PhaseModel::PhaseNoise;
    bool periodic = true;    ///< take the exemplar's periodic component instead of the exemplar itself
    double transition = 0.1; ///< share of each side over which an extended spot fades out
};

} // namespace texloom::random_phase
