#pragma once

namespace texloom::portilla_simoncelli {

/// Parameters of Portilla & Simoncelli's method (IJCV 40, 2000; Vacher & Briand, IPOL 2021).
struct Settings {
    int scales = 4;
    int orientations = 4;
    int neighbourhood =
        7; ///< side of the square of lags whose autocorrelation counts; even ones count as odd
    int iterations = 50;
    double momentum = 0.8; ///< share of an iteration's change that is added again
    double weight = 0.5;   ///< share of the second exemplar where there are two
    bool periodic = true;  ///< measure on the exemplar's periodic component
    int jointChannels = 0; ///< how many of the first channels are synthesised jointly; 0 for all
    bool crossChannel = true;
    bool marginals = true;
    bool autocorrelation = true;
    bool magnitudeAutocorrelation = true;
    bool magnitudeOrientations = true;
    bool magnitudeScales = true;
    bool bandOrientations = true;
    bool phases = true;

    /// Largest lag in samples along either axis.
    int reach() const { return (neighbourhood - 1) / 2; }
};

} // namespace texloom::portilla_simoncelli
