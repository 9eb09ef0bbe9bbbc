#pragma once

#include "core/image/image.h"
#include "core/job/job_context.h"

namespace texloom {

/// How one gradient is chosen of two (Pérez, Gangnet & Blake 2003, section 3.2; Raad, thesis 2016, eq. 5.1).
struct GradientChoice {
    double preference = 1; ///< factor on the length of the first picture's gradients
    bool perChannel =
        false;          ///< each channel for itself, as printed; else all of a pixel by the length over all
    bool wraps = false; ///< differences go on over the border; else there are none over it
};

/// The divergence of v, where v(x) is the first picture's gradient at x if that is as long as the second's or
/// longer, else the second's. Gradients are differences to the pixels on the right and below; the divergence
/// is the negative of their adjoint, so that of one picture's gradients it is the sum of the differences to
/// the four neighbours. Both pictures have one size and as many channels. Its progress is the context's.
Image mixedDivergence(const ImageView& first, const ImageView& second, const GradientChoice& choice,
                      JobContext& context);

} // namespace texloom
