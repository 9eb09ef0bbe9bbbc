#include "core/network/pooling.h"

#include <algorithm>

namespace texloom {

namespace {

/// Calls visit(y, x, rows, columns) for each group of pixels whose top left is (2y, 2x).
template <class Visit> void everyGroup(const Tensor& fine, const Visit& visit) {
    for (int y = 0; 2 * y < fine.height(); ++y)
        for (int x = 0; 2 * x < fine.width(); ++x)
            visit(y, x, std::min(2, fine.height() - 2 * y), std::min(2, fine.width() - 2 * x));
}

/// Where the largest pixel of a group is, from its top left.
std::size_t largestOf(const float* corner, int rows, int columns, std::size_t stride) {
    std::size_t best = 0;
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i)
            if (corner[at(j) * stride + at(i)] > corner[best])
                best = at(j) * stride + at(i);
    return best;
}

/// Row `y` of the means of pairs of rows whose length is even.
void averageRow(const float* above, const float* below, int width, float* to) {
    for (int x = 0; x < width; ++x)
        to[x] = 0.25F * ((above[2 * x] + above[2 * x + 1]) + (below[2 * x] + below[2 * x + 1]));
}

void averageGroup(const Tensor& in, int c, int y, int x, Tensor& out) {
    const int rows = std::min(2, in.height() - 2 * y), columns = std::min(2, in.width() - 2 * x);
    float sum = 0;
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i)
            sum += in.row(c, 2 * y + j)[2 * x + i];
    out.row(c, y)[x] = sum / static_cast<float>(rows * columns);
}

void average(const Tensor& in, int c, Tensor& out) {
    const int evenWidth = in.width() / 2;
    for (int y = 0; y < out.height(); ++y) {
        const bool whole = 2 * y + 1 < in.height();
        if (whole)
            averageRow(in.row(c, 2 * y), in.row(c, 2 * y + 1), evenWidth, out.row(c, y));
        for (int x = whole ? evenWidth : 0; x < out.width(); ++x)
            averageGroup(in, c, y, x, out);
    }
}

} // namespace

void pool(const Tensor& in, Pooling pooling, Tensor& out, JobContext& context) {
    out.resize(in.channels(), (in.height() + 1) / 2, (in.width() + 1) / 2);
    context.parallel(0, in.channels(), [&](int c) {
        if (pooling == Pooling::Average)
            return average(in, c, out);
        everyGroup(in, [&](int y, int x, int rows, int columns) {
            const float* const corner = in.row(c, 2 * y) + 2 * x;
            out.row(c, y)[x] = corner[largestOf(corner, rows, columns, at(in.width()))];
        });
    });
}

void addPoolGradient(const Tensor& in, Pooling pooling, const Tensor& outGradient, Tensor& inGradient,
                     JobContext& context) {
    context.parallel(0, in.channels(), [&](int c) {
        everyGroup(inGradient, [&](int y, int x, int rows, int columns) {
            const float gradient = outGradient.row(c, y)[x];
            float* const corner = inGradient.row(c, 2 * y) + 2 * x;
            if (pooling == Pooling::Maximum) {
                corner[largestOf(in.row(c, 2 * y) + 2 * x, rows, columns, at(in.width()))] += gradient;
                return;
            }
            const float share = gradient / static_cast<float>(rows * columns);
            for (int j = 0; j < rows; ++j)
                for (int i = 0; i < columns; ++i)
                    corner[at(j) * at(inGradient.width()) + at(i)] += share;
        });
    });
}

} // namespace texloom
