#pragma once

namespace texloom::patch_distribution {

/// Parameters of matching the distribution of patches (Elnekave & Weiss 2022).
struct Settings {
    int patch = 7;       ///< side in pixels
    int directions = 16; ///< along which patches are compared in one iteration
    int iterations = 60; ///< at the finest scale
    int scales = 5;      ///< at most
};

} // namespace texloom::patch_distribution
