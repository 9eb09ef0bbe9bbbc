#pragma once

#include "core/base/param.h"
#include "core/base/text.h"
#include "core/math/anamorphosis.h"

#include <string>

namespace texloom {

/// Parameters of a deformation, declared once for all that deform.

template <class Settings> AnamorphosisOptions anamorphosisOptions(const Settings& settings) {
    return {settings.kind, settings.axis, settings.amplitude, settings.frequency, settings.scale};
}

template <class Settings>
Param anamorphosisKindField(AnamorphosisKind Settings::*member, const std::string& name) {
    return field(member, name, TR("Kind"))
        .choices({{"affine", TR("Affine in two pieces")},
                  {"parabola", TR("Parabola")},
                  {"sinusoid", TR("Sinusoid")},
                  {"turbulence", TR("Turbulence")}})
        .help(TR("The first three stretch and squeeze along one axis; turbulence swirls along both."));
}

template <class Settings> Param anamorphosisAxisField(AnamorphosisAxis Settings::*member) {
    return field(member, "axis", TR("Axis"))
        .choices({{"x", TR("Across")}, {"y", TR("Down")}})
        .help(TR("The axis that the first three kinds deform; turbulence deforms both."));
}

template <class Settings> Param anamorphosisAmplitudeField(double Settings::*member) {
    return field(member, "amplitude", TR("Amplitude"))
        .range(0, 0.95)
        .help(TR("How strongly: 0 changes nothing; near 1 the most squeezed places shrink to almost nothing. "
                 "Turbulence is lowered until nothing folds."));
}

/// @param kind name of the parameter that chooses the kind.
template <class Settings> Param anamorphosisFrequencyField(int Settings::*member, const std::string& kind) {
    return field(member, "frequency", TR("Waves"))
        .range(1, 16)
        .when(kind, std::string("sinusoid"))
        .help(TR("Waves of the sinusoid over the whole: more of them move less far."));
}

template <class Settings> Param anamorphosisScaleField(double Settings::*member, const std::string& kind) {
    return field(member, "scale", TR("Scale"))
        .range(4, 512)
        .unit("px")
        .when(kind, std::string("turbulence"))
        .help(TR("Size of the swirls: larger bends slower and moves farther."));
}

} // namespace texloom
