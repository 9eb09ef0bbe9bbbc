#pragma once

#include "core/image/image.h"
#include "core/job/job_context.h"
#include "core/math/line_transform.h"

#include <vector>

namespace texloom {

/// Poisson's equation Δf = g with every pixel of an image unknown, on all threads of a job and with hardly
/// any memory of its own: nothing flows over a border that does not wrap, and one that wraps closes.
/// Screened, it is Δf − f / r² = g, whose f dies away over r pixels from where g is not 0. Fit for
/// corrections, whose right side is small or sparse: transforms are in single precision, so that f is known
/// to a few 1e-6 of its range.
class GridPoisson {
public:
    /// @param reach r in pixels; 0: the equation is not screened.
    GridPoisson(Size size, Wrap wrap, double reach = 0);

    /// Replaces g by f, of mean 0. The mean of g, which no f can have, is left out.
    /// @param plane a plane of an Image of the size.
    void solve(const PlaneSpan& plane, JobContext& context) const;

    /// Bytes beyond the plane.
    static std::uint64_t bytesFor(Size size, int threads);

private:
    void solveColumns(const PlaneSpan& plane, int first, int last, float* lines) const;

    LineTransform m_rows, m_columns;
    std::vector<double> m_alongX, m_alongY; ///< what the operator multiplies coefficients by along each axis
};

} // namespace texloom
