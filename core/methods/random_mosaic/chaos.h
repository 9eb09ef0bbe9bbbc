#pragma once

#include "core/methods/random_mosaic/canvas.h"
#include "core/methods/random_mosaic/settings.h"

namespace texloom::random_mosaic {

/// Moves square blocks over a canvas on which whole exemplars lie side by side (Xu, Guo & Shum, "Chaos
/// mosaic", 2000): in each of their cells as many blocks as would cover it are taken from random places of
/// its exemplar and laid where the cat map (x, y) → (x + y, x + 2y), turned a few times, sends them.
/// @param canvas tiled with exemplars. @param cell of one of them in the output, about.
/// @param weight of the stage. @return how many blocks were laid.
int moveBlocks(Canvas& canvas, const Request& request, const Settings& settings, Size cell, double weight,
               JobContext& context);

} // namespace texloom::random_mosaic
