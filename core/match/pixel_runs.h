#pragma once

#include "core/image/size.h"

#include <vector>

namespace texloom {

/// Pixels side by side, relative to the centre of a neighbourhood.
struct PixelRun {
    int dx = 0, dy = 0; ///< of the first
    int count = 0;

    friend bool operator==(const PixelRun&, const PixelRun&) = default;
};

using PixelRuns = std::vector<PixelRun>;

/// What raster order knows of a square when it comes to the centre: the rows above and the pixels to the left
/// (Wei & Levoy, SIGGRAPH 2000), (side² − 1) / 2 in all. @param side odd.
PixelRuns causalRuns(int side);
/// The rest of the square without the centre.
PixelRuns followingRuns(int side);
/// The square without its centre.
PixelRuns aroundRuns(int side);
/// The whole square.
PixelRuns squareRuns(int side);

/// The runs cut to what lies in an output of this size on axes that do not wrap.
/// @param x, y the centre.
PixelRuns clippedRuns(const PixelRuns& runs, int x, int y, Size size, Wrap wrap);

/// Pixels of all runs.
int pixelCount(const PixelRuns& runs);

/// The next odd number where a side is even.
inline int oddSide(int side) {
    return side | 1;
}

} // namespace texloom
