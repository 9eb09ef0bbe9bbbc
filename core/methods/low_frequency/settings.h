#pragma once

namespace texloom::low_frequency {

/// Parameters of random low frequencies (Raad, thesis 2016, section 5.7).
struct Settings {
    double theta = 16;       ///< θ, standard deviation in pixels of the Gaussian that cuts the low band off
    bool periodic = true;    ///< take the periodic component first
    double transition = 0.1; ///< see SpotOptions
    int patch = 40;          ///< of the quilt that the high band is taken from where sizes differ
};

} // namespace texloom::low_frequency
