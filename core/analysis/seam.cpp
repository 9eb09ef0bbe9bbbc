#include "core/analysis/seam.h"

#include <cmath>

namespace texloom {

namespace {

/// Sum of absolute differences of two rows of `count` samples.
double rowDifference(const float* a, const float* b, int count) {
    double sum = 0;
    for (int x = 0; x < count; ++x)
        sum += static_cast<double>(std::abs(a[x] - b[x]));
    return sum;
}

/// @param inside summed over `steps` steps between neighbours, @param seam over one.
double ratio(double seam, double inside, int steps) {
    if (steps < 1 || (seam == 0 && inside == 0))
        return 1;
    return inside > 0 ? seam * steps / inside : HUGE_VAL;
}

} // namespace

SeamScore seamScore(const ImageView& image, const std::function<void()>& check) {
    const int lastX = image.width - 1, lastY = image.height - 1;
    double insideX = 0, seamX = 0, insideY = 0, seamY = 0;
    for (int c = 0; c < image.channels; ++c) {
        const PlaneView plane = image.plane(c);
        for (int y = 0; y < image.height; ++y) {
            check();
            const float* row = plane.row(y);
            insideX += rowDifference(row, row + 1, lastX);
            seamX += static_cast<double>(std::abs(row[0] - row[lastX]));
            if (y < lastY)
                insideY += rowDifference(row, plane.row(y + 1), image.width);
        }
        seamY += rowDifference(plane.row(0), plane.row(lastY), image.width);
    }
    return {ratio(seamX, insideX, lastX), ratio(seamY, insideY, lastY)};
}

} // namespace texloom
