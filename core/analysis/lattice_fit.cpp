#include "core/analysis/lattice_fit.h"

#include "core/analysis/lattice_multiples.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace texloom {

namespace {

struct Maximum {
    Vec2 at;
    double height = 0;
};

/// The maximum of γ near a point, to a fraction of a pixel; nothing if there is none.
std::optional<Maximum> maximumNear(const CorrelationPeaks& peaks, Vec2 point, int reach) {
    const CorrelationPeaks::Peak top = peaks.summit(point, reach);
    if (top.height <= 0 || !peaks.inside({double(top.x), double(top.y)}, 1))
        return {};
    const Correlation& gamma = peaks.smooth();
    const float left = gamma.at(top.x - 1, top.y), right = gamma.at(top.x + 1, top.y);
    const float above = gamma.at(top.x, top.y - 1), below = gamma.at(top.x, top.y + 1);
    const float here = top.height;
    if (left > here || right > here || above > here || below > here)
        return {};
    return Maximum{{top.x + parabolaTop(left, here, right), top.y + parabolaTop(above, here, below)}, here};
}

/// The fit to the multiples up to `rings` only.
Lattice fittedTo(const CorrelationPeaks& peaks, const Lattice& lattice, int rings) {
    const int reach = std::clamp(static_cast<int>(0.2 * lattice.v1.length()), 1, 3);
    const Size size = peaks.size();
    double aa = 0, ab = 0, bb = 0;
    Vec2 pa, pb;
    const Thinned thinned(size, lattice, rings);
    eachMultiple(size, lattice, rings, [&](int a, int b, Vec2 p) {
        if (!thinned.keeps(a, b))
            return;
        const std::optional<Maximum> top = maximumNear(peaks, p, reach);
        if (!top)
            return;
        const double share = (1 - std::abs(top->at.x) / size.width) * (1 - std::abs(top->at.y) / size.height);
        const double weight = top->height * share;
        aa += weight * a * a;
        ab += weight * a * b;
        bb += weight * b * b;
        pa = pa + weight * a * top->at;
        pb = pb + weight * b * top->at;
    });
    const double determinant = aa * bb - ab * ab;
    if (determinant <= 1e-9 * aa * bb)
        return lattice;
    return {(1 / determinant) * (bb * pa - ab * pb), (1 / determinant) * (aa * pb - ab * pa)};
}

} // namespace

double parabolaTop(double before, double here, double after) {
    const double bend = before - 2 * here + after;
    return bend < 0 ? std::clamp(0.5 * (before - after) / bend, -0.5, 0.5) : 0;
}

Lattice fitted(const CorrelationPeaks& peaks, const Lattice& rough) {
    Lattice now = rough;
    const int most = ringsOf(peaks.size(), rough);
    // From the nearest multiples outwards, so that no maximum is mistaken for its neighbour.
    for (int rings = 1;; rings = std::min(2 * rings, most)) {
        const Lattice next = fittedTo(peaks, now, rings).reduced();
        if (next.area() < 0.5 * rough.area() || next.area() > 2 * rough.area())
            return rough;
        now = next;
        if (rings >= most)
            return fittedTo(peaks, now, most).reduced();
    }
}

} // namespace texloom
