#pragma once

#include "core/analysis/lattice.h"
#include "core/image/image.h"

#include <functional>

namespace texloom::near_regular {

/// The exemplar with slow changes of light removed from each channel: its mean over a soft window of `width`
/// pixels is made the same everywhere, so that blocks from all places have one brightness (the source's fig.
/// 5.12). @param width at least a tile, or the texture itself is removed.
Image flattened(const ImageView& exemplar, int width, const std::function<void()>& check);

/// How uneven the light is that flattened() would remove: the standard deviation of the slow changes relative
/// to that of the rest, in the channel where it is largest; 0 for a constant exemplar.
double unevenness(const ImageView& exemplar, int width, const std::function<void()>& check);

/// A linear map of the plane that puts a lattice's courses on the axes and its vectors on whole pixels.
struct Rectification {
    Lattice lattice; ///< what the lattice becomes
    Vec2 columnX,
        columnY; ///< where a step right and a step down in the rectified picture lead in the exemplar
    Vec2 origin; ///< the exemplar's point at the rectified picture's top left
    Size size;   ///< of the rectified picture: all of it lies in the exemplar

    /// The exemplar's point for a point of the rectified picture.
    Vec2 from(double x, double y) const { return origin + x * columnX + y * columnY; }
};

/// The rectification of an exemplar with this lattice. Vectors up to 20° off an axis are put on it; a lattice
/// with none keeps its directions. The size is {0, 0} where too little of the exemplar would be left.
Rectification rectification(const Lattice& lattice, Size exemplar);

/// The exemplar resampled, by Catmull and Rom's cubic.
Image rectified(const ImageView& exemplar, const Rectification& by, const std::function<void()>& check);

} // namespace texloom::near_regular
