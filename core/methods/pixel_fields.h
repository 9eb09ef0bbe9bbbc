#pragma once

#include "core/base/param.h"
#include "core/base/text.h"

namespace texloom {

/// Parameters that methods which make one pixel after another have in common, declared once. A method adds
/// what is its own, such as the source's letter, or says instead what differs.

/// Side of the square that is compared. @param largest that the method can do in a reasonable time.
template <class Settings> Param neighbourhoodField(int Settings::*member, int largest) {
    return field(member, "neighbourhood", TR("Neighbourhood"))
        .range(3, largest)
        .unit("px")
        .help(TR("Side of the square that is compared (an even one counts as the next odd): larger keeps "
                 "larger structures, but takes longer."));
}

/// Scales of a pyramid of pixels; small exemplars use fewer.
template <class Settings> Param levelsField(int Settings::*member) {
    return field(member, "levels", TR("Scales"))
        .range(1, 8)
        .help(TR("At most so many, each half the size of the one before: more keep larger structures."));
}

/// How often an output is gone through.
template <class Settings> Param passesField(int Settings::*member, int most) {
    return field(member, "passes", TR("Passes")).range(1, most);
}

/// Points in a leaf of a tree that finds the nearest approximately.
template <class Settings> Param leafField(int Settings::*member) {
    return field(member, "leaf", TR("Leaf"))
        .range(1, 256)
        .group(TR("Advanced"))
        .help(TR("Neighbourhoods in a leaf of the tree: larger finds nearer ones, but takes longer."));
}

} // namespace texloom
