#pragma once

namespace texloom::heeger_bergen {

/// Parameters of Heeger & Bergen's method (SIGGRAPH 1995; Briand, Vacher, Galerne & Rabin, IPOL 2014).
struct Settings {
    int scales = 4;
    int orientations = 4;
    int iterations = 10;
    bool periodic = true; ///< measure bands on the exemplar's periodic component
};

} // namespace texloom::heeger_bergen
