#include "core/network/picture_tensor.h"

#include <algorithm>

namespace texloom {

Tensor tensorOf(const ImageView& image) {
    Tensor to(image.channels, image.height, image.width);
    for (int c = 0; c < image.channels; ++c)
        for (int y = 0; y < image.height; ++y)
            std::copy_n(image.plane(c).row(y), image.width, to.row(c, y));
    return to;
}

Image imageOf(const Tensor& tensor) {
    Image to({tensor.width(), tensor.height()}, tensor.channels());
    for (int c = 0; c < tensor.channels(); ++c)
        for (int y = 0; y < tensor.height(); ++y)
            std::copy_n(tensor.row(c, y), tensor.width(), to.plane(c).row(y));
    return to;
}

} // namespace texloom
