#include "core/analysis/difference.h"

#include <algorithm>
#include <cmath>

namespace texloom {

namespace {

constexpr float kDarkest = 0.01F;

float sampleOf(float a, float b, DifferenceKind kind) {
    const float apart = std::abs(a - b);
    switch (kind) {
    case DifferenceKind::Squared:
        return apart * apart;
    case DifferenceKind::Relative:
        return apart / (std::abs(b) + kDarkest);
    case DifferenceKind::Absolute:
        break;
    }
    return apart;
}

} // namespace

Difference difference(const ImageView& a, const ImageView& b, DifferenceKind kind,
                      const std::function<void()>& check) {
    const Size size{std::min(a.width, b.width), std::min(a.height, b.height)};
    Difference found{Image(size, std::min(a.channels, b.channels)), 0, 0};
    for (int c = 0; c < found.image.channels(); ++c)
        for (int y = 0; y < size.height; ++y) {
            check();
            float* const row = found.image.plane(c).row(y);
            double sum = 0;
            for (int x = 0; x < size.width; ++x) {
                row[x] = sampleOf(a(x, y, c), b(x, y, c), kind);
                found.largest = std::max(found.largest, row[x]);
                sum += static_cast<double>(row[x]);
            }
            found.number += sum;
        }
    found.number /= static_cast<double>(size.area()) * found.image.channels();
    if (kind == DifferenceKind::Squared)
        found.number = std::sqrt(found.number);
    return found;
}

} // namespace texloom
