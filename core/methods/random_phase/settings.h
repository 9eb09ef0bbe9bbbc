#pragma once

namespace texloom::random_phase {

/// Which random field is drawn.
enum class Model { PhaseNoise, SpotNoise };

/// Parameters of random phase textures (Galerne, Gousseau & Morel 2011).
struct Settings {
    Model model = Model::PhaseNoise;
    bool periodic = true;    ///< take the exemplar's periodic component instead of the exemplar itself
    double transition = 0.1; ///< share of each side over which an extended spot fades out
};

} // namespace texloom::random_phase
