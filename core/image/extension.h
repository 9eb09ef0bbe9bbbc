#pragma once

#include "core/image/image.h"

#include <vector>

namespace texloom {

/// How many pixels a picture is extended by at each side; none is below 0.
struct Margins {
    int left = 0, top = 0, right = 0, bottom = 0;

    bool empty() const { return left == 0 && top == 0 && right == 0 && bottom == 0; }
};

/// The size of a picture that is extended.
Size extendedSize(Size size, const Margins& margins);

/// A picture on a larger canvas, with one value for each channel beyond its edges.
Image extended(const ImageView& image, const Margins& margins, const std::vector<float>& beyond);

} // namespace texloom
