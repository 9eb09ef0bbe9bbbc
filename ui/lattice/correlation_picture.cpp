#include "ui/lattice/correlation_picture.h"

#include "core/image/image.h"

#include <algorithm>
#include <utility>

namespace texloom::ui {

std::shared_ptr<const DisplayPicture> pictureOf(const Correlation& correlation) {
    if (correlation.size().empty())
        return nullptr;
    constexpr int kMiddle = 4; // γ is 1 here, whatever the texture
    float highest = 0.05F;
    for (int dy = 0; dy <= correlation.bottom() / 2; ++dy)
        for (int dx = -correlation.left() / 2; dx <= correlation.right() / 2; ++dx)
            if (dx * dx + dy * dy > kMiddle * kMiddle)
                highest = std::max(highest, correlation.at(dx, dy));
    Image picture = correlation.picture();
    const PlaneSpan plane = picture.plane(0);
    for (int y = 0; y < plane.height; ++y)
        for (int x = 0; x < plane.width; ++x)
            plane(x, y) = std::clamp(plane(x, y) / highest, 0.0F, 1.0F);
    return std::make_shared<const DisplayPicture>(std::make_shared<const Image>(std::move(picture)));
}

} // namespace texloom::ui
