#include "core/image/extension.h"

#include <algorithm>

namespace texloom {

Size extendedSize(Size size, const Margins& margins) {
    return {margins.left + size.width + margins.right, margins.top + size.height + margins.bottom};
}

Image extended(const ImageView& image, const Margins& margins, const std::vector<float>& beyond) {
    Image made(extendedSize(image.size(), margins), image.channels);
    for (int c = 0; c < image.channels; ++c) {
        for (int y = 0; y < made.height(); ++y)
            std::fill_n(made.plane(c).row(y), made.width(), beyond[static_cast<std::size_t>(c)]);
        for (int y = 0; y < image.height; ++y)
            std::copy_n(image.plane(c).row(y), image.width,
                        made.plane(c).row(margins.top + y) + margins.left);
    }
    return made;
}

} // namespace texloom
