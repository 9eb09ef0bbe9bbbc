#pragma once

#include "core/image/image.h"
#include "core/math/anamorphosis.h"

namespace texloom::anamorphosis {

/// A drawing of the deformation, black on white: the curve of the map along its axis, with the identity as a
/// grey line (Raad, thesis 2016, figure 5.30); of turbulence, squares of the picture as they are deformed.
/// @param plane that is deformed. @param channels of the drawing.
Image pictureOf(const Anamorphosis& warp, Size plane, int channels);

/// Size of the largest drawing, in pixels.
inline constexpr int kPictureSide = 512;

} // namespace texloom::anamorphosis
