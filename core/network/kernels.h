#pragma once

#include "core/network/kernel_work.h"

namespace texloom {

/// Does the convolution with the widest vectors that the machine has; the bits are the same with all.
void convolveFlat(const FlatConvolution& what);

/// Adds the products, likewise.
void addRowProducts(const RowProducts& what);

} // namespace texloom
