#include "core/math/grid_poisson.h"

#include "core/job/pool.h"
#include "core/math/fft.h"

#include <algorithm>

namespace texloom {

namespace {

constexpr int kLines = 16;

int groupsOf(int count) {
    return (count + kLines - 1) / kLines;
}

} // namespace

GridPoisson::GridPoisson(Size size, Wrap wrap, double reach)
    : m_rows(size.width, wrap.x), m_columns(size.height, wrap.y) {
    const double screen = reach > 0 ? 1 / (reach * reach) : 0;
    for (int k = 0; k < size.width; ++k)
        m_alongX.push_back(m_rows.secondDifference(k) - screen);
    for (int k = 0; k < size.height; ++k)
        m_alongY.push_back(m_columns.secondDifference(k));
}

/// Transforms some columns, divides by the Laplacian, and transforms them back. They are worked on side by
/// side in `lines`, since columns of an image can share cache sets.
void GridPoisson::solveColumns(const PlaneSpan& plane, int first, int last, float* lines) const {
    const std::ptrdiff_t stride = m_columns.stride();
    for (int y = 0; y < plane.height; ++y)
        for (int x = first; x < last; ++x)
            lines[(x - first) * stride + y] = plane(x, y);
    m_columns.forward(lines, last - first, stride);
    const double scale = m_rows.scale() * m_columns.scale();
    for (int x = first; x < last; ++x) {
        const double alongX = m_alongX[static_cast<std::size_t>(x)];
        float* line = lines + (x - first) * stride;
        for (int y = 0; y < plane.height; ++y) {
            const double factor = alongX + m_alongY[static_cast<std::size_t>(y)];
            line[y] = x + y == 0 ? 0 : static_cast<float>(static_cast<double>(line[y]) / (factor * scale));
        }
    }
    m_columns.backward(lines, last - first, stride);
    for (int y = 0; y < plane.height; ++y)
        for (int x = first; x < last; ++x)
            plane(x, y) = lines[(x - first) * stride + y];
}

void GridPoisson::solve(const PlaneSpan& plane, JobContext& context) const {
    Pool<FftBuffer<float>> buffers;
    const auto rows = [&](bool forward) {
        context.parallel(0, groupsOf(plane.height), [&](int block) {
            const int first = block * kLines, count = std::min(kLines, plane.height - first);
            if (forward)
                m_rows.forward(plane.row(first), count, plane.stride);
            else
                m_rows.backward(plane.row(first), count, plane.stride);
        });
    };
    rows(true);
    context.parallel(0, groupsOf(plane.width), [&](int block) {
        const auto lines = buffers.borrow(
            [&] { return FftBuffer<float>(static_cast<std::size_t>(m_columns.stride()) * kLines); });
        solveColumns(plane, block * kLines, std::min(plane.width, (block + 1) * kLines), lines->data());
    });
    rows(false);
}

std::uint64_t GridPoisson::bytesFor(Size size, int threads) {
    return static_cast<std::uint64_t>(size.height + size.width + 64) *
           (kLines * sizeof(float) * static_cast<std::uint64_t>(threads + 1) + 2 * sizeof(double));
}

} // namespace texloom
