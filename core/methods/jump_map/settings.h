#pragma once

namespace texloom::jump_map {

/// Parameters of synthesis by a jump map (Zelinka & Garland, EGWR 2002).
struct Settings {
    int neighbourhood =
        9;              ///< side of the squares that are alike, in pixels; an even one counts as the next odd
    int jumps = 4;      ///< k: likenesses that are kept for each pixel of the exemplar
    int apart = 10;     ///< r: least distance between these and from the pixel itself, in pixels
    double jump = 0.02; ///< how likely a walk jumps where there is a perfect likeness
};

} // namespace texloom::jump_map
