#pragma once

#include "core/base/exemplar_edit.h"
#include "core/image/size.h"

#include <string>
#include <utility>

namespace texloom::test {

/// Edits as recipes hold them.
inline ExemplarEdit crop(int x, int y, int width, int height) {
    return {{"crop", Wholes{x, y, width, height}}};
}

inline ExemplarEdit turn(double degrees) {
    return {{"rotate", degrees}};
}

/// @param axis "horizontal" or "vertical".
inline ExemplarEdit flip(const char* axis) {
    return {{"flip", std::string(axis)}};
}

/// @param size empty: as long as the longer of opposite sides.
inline ExemplarEdit rectify(PlanePoints corners, Size size = {}) {
    ExemplarEdit edit = {{"rectify", std::move(corners)}};
    if (!size.empty())
        edit["size"] = Wholes{size.width, size.height};
    return edit;
}

/// @param model "smooth" or "polynomial".
inline ExemplarEdit flatten(const char* model, double strength = 1, ExemplarEdit more = {}) {
    more["flatten"] = std::string(model);
    more["strength"] = strength;
    return more;
}

} // namespace texloom::test
