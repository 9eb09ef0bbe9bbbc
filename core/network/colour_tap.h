#pragma once

#include "core/network/descriptor.h"

#include <span>

namespace texloom {

/// A descriptor of colours alone: along directions of the colours of these pictures (the principal ones, and
/// random ones between them) how far each pixel is beyond some quantiles. It holds the distribution of
/// colours where the descriptor of structure lets it drift. Empty (no chains) where the pictures have one
/// colour.
/// @param pictures with the same number of channels.
Descriptor colourDescriptor(std::span<const Tensor* const> pictures);

} // namespace texloom
