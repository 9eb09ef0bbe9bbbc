#include "core/analysis/seam.h"

#include <cmath>

namespace texloom {

namespace {

/// Mean absolute difference between the columns x and x + 1, the last one meeting the first.
double columnDifference(const ImageView& image, int x) {
    const int next = (x + 1) % image.width;
    double sum = 0;
    for (int c = 0; c < image.channels; ++c)
        for (int y = 0; y < image.height; ++y)
            sum += std::abs(static_cast<double>(image(next, y, c) - image(x, y, c)));
    return sum / (static_cast<double>(image.height) * image.channels);
}

double rowDifference(const ImageView& image, int y) {
    const int next = (y + 1) % image.height;
    double sum = 0;
    for (int c = 0; c < image.channels; ++c)
        for (int x = 0; x < image.width; ++x)
            sum += std::abs(static_cast<double>(image(x, next, c) - image(x, y, c)));
    return sum / (static_cast<double>(image.width) * image.channels);
}

template <class Difference> double seamScore(int count, const Difference& difference) {
    if (count < 2)
        return 1;
    double inside = 0;
    for (int i = 0; i + 1 < count; ++i)
        inside += difference(i);
    inside /= count - 1;
    const double seam = difference(count - 1);
    if (inside > 0)
        return seam / inside;
    return seam > 0 ? HUGE_VAL : 1;
}

} // namespace

double seamScoreX(const ImageView& image) {
    return seamScore(image.width, [&](int x) { return columnDifference(image, x); });
}

double seamScoreY(const ImageView& image) {
    return seamScore(image.height, [&](int y) { return rowDifference(image, y); });
}

} // namespace texloom
