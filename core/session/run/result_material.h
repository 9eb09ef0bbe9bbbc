#pragma once

#include "core/render/material.h"
#include "core/session/run/run.h"

namespace texloom {

/// A picture as a material: its colours, and its alpha as opacity.
/// @param image in the working space, of 1 to 4 channels that count; more are left out.
Material materialOf(const ImageView& image);

/// A result with its companion maps, each as what it holds; those of which nobody knows what they hold, and
/// those that a stopped run has none of, are left out. Of two that hold the same the first counts.
Material materialOf(const Result& result);

} // namespace texloom
