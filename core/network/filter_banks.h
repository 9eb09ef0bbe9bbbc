#pragma once

#include "core/network/descriptor.h"

namespace texloom {

/// Random filters in one layer: 64 each of 3, 7 and 11 px, on three levels (Ustyuzhaninov, Brendel, Gatys &
/// Bethge 2017). Needs no weights of anybody. Always the same for a number of channels.
Descriptor randomDescriptor(int channels);

/// Rectified wavelets: the positive parts of Morlet wavelets in four phases, eight directions and two scales
/// (and those of further scales by the levels of the picture's pyramid), whose covariances, also between
/// places some pixels apart, describe a texture (Brochard, Zhang & Mallat 2022). Colours are seen as
/// lightness and two differences, other channels one by one.
Descriptor waveletDescriptor(int channels);

} // namespace texloom
