#pragma once

#include "core/base/param.h"
#include "core/base/text.h"

namespace texloom {

/// Parameters that methods of spectra and of bands have in common, declared once. A method adds what is its
/// own, such as the source's letter, or says instead what differs.

/// Whether the exemplar's periodic component is learnt from (Moisan 2011) instead of the exemplar itself.
template <class Settings> Param periodicField(bool Settings::*member) {
    return field(member, "periodic", TR("Take off border jumps"))
        .group(TR("Advanced"))
        .help(TR("Learns from the exemplar's periodic component, without which its borders count as "
                 "horizontal and vertical lines."));
}

/// See SpotOptions::transition.
template <class Settings> Param transitionField(double Settings::*member) {
    return field(member, "transition", TR("Fading border"))
        .range(0, 0.5)
        .symbol("α")
        .group(TR("Advanced"))
        .help(TR("Share of each side over which the exemplar fades out where the output has another size: "
                 "larger leaves fewer streaks, smaller keeps slow changes."));
}

/// Scales of a steerable pyramid.
template <class Settings> Param octavesField(int Settings::*member) {
    return field(member, "scales", TR("Scales"))
        .range(1, 8)
        .help(TR("Octaves that the pyramid takes apart: more keep larger features. Small images use fewer."));
}

/// Orientations of a steerable pyramid.
template <class Settings> Param orientationsField(int Settings::*member) {
    return field(member, "orientations", TR("Orientations"))
        .range(1, 8)
        .help(TR("Directions told apart at each scale: more keep lines at more angles, and take longer."));
}

} // namespace texloom
