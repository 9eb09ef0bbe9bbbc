#pragma once

#include "core/image/position_map.h"
#include "core/methods/synthesis.h"

namespace texloom::graph_cut {

/// A direction from one pixel to a neighbour: right or down.
struct Step {
    int x = 0, y = 0;
};

/// What it costs that two neighbouring pixels come from different places (Kwatra et al. 2003, eq. 1 and 2):
/// M = (|A(a) − B(a)| + |A(b) − B(b)|) / (|g_A(a)| + |g_A(b)| + |g_B(a)| + |g_B(b)| + δ), g the differences
/// along the step and |·| the length over channels. Beyond its border an exemplar counts as it is there.
class SeamCost {
public:
    SeamCost(const Request& request, bool gradient);

    /// @param a source of a pixel, its picture A; @param b source of the pixel a step further, its picture B.
    /// 0 where b goes on as a does.
    double between(const Source& a, const Source& b, Step step) const;
    /// The same as a capacity.
    std::int32_t capacity(const Source& a, const Source& b, Step step) const;

private:
    struct Place {
        const Image* image;
        int x, y;
    };
    Place at(const Source& source, int dx, int dy) const;
    double distance(const Place& p, const Place& q) const;

    const Request& m_request;
    bool m_gradient;
    double m_delta; ///< δ: the printed denominator vanishes where both pictures are flat
};

} // namespace texloom::graph_cut
