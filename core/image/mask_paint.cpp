#include "core/image/mask_paint.h"

#include <algorithm>
#include <cmath>

namespace texloom {

Image paintedMask(const Image* mask, Size source, const Warp& warp, const Image& stroke, bool hide,
                  const std::function<void()>& check) {
    Image painted = mask != nullptr ? *mask : Image(source, 1);
    if (mask == nullptr)
        for (int y = 0; y < source.height; ++y)
            std::fill_n(painted.plane(0).row(y), source.width, 1.0F);
    for (int y = 0; y < source.height; ++y) {
        check();
        // Neighbours map to nearby points, so each point is where inverting a field at the next one starts.
        PlanePoint near{0.5, (y + 0.5) * warp.size().height / source.height};
        for (int x = 0; x < source.width; ++x) {
            const PlanePoint at = warp.fromSource({x + 0.5, y + 0.5}, near);
            if (std::isfinite(at.x) && std::isfinite(at.y))
                near = at;
            if (!(at.x >= 0 && at.y >= 0 && at.x < stroke.width() && at.y < stroke.height()))
                continue;
            if (stroke(static_cast<int>(at.x), static_cast<int>(at.y), 0) != 0)
                painted(x, y, 0) = hide ? 0.0F : 1.0F;
        }
    }
    return painted;
}

} // namespace texloom
