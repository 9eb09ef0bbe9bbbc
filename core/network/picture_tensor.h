#pragma once

#include "core/image/image.h"
#include "core/network/tensor.h"

namespace texloom {

/// The pixels of a picture as a tensor of its channels, and the inverse.
Tensor tensorOf(const ImageView& image);
Image imageOf(const Tensor& tensor);

} // namespace texloom
