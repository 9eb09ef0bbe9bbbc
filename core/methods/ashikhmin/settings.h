#pragma once

#include <string_view>

namespace texloom::ashikhmin {

/// The input that stands for what is not made yet.
inline constexpr std::string_view kTargetPort = "target";

/// Parameters of the coherent synthesis of Ashikhmin (I3D 2001).
struct Settings {
    int neighbourhood = 9;   ///< side in pixels; an even one counts as the next odd
    int passes = 2;          ///< those after the first compare whole squares
    double targetWeight = 1; ///< w: how much the target counts beside what is made already
    double jump = 0;         ///< probability that a random pixel of the exemplar is a candidate too
};

} // namespace texloom::ashikhmin
