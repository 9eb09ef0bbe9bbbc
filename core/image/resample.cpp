#include "core/image/resample.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace texloom {

namespace {

/// The maximum number of samples along each axis of a pixel where the image shrinks.
constexpr int kMostSamples = 8;

/// The four pixels along one axis that a sample is made of, kept within the image.
struct Taps {
    std::array<int, 4> at;
    std::array<float, 4> weight;
    int first = 0, last = 3; ///< those whose weight is not 0

    /// @param position in pixels' centres. By Catmull & Rom (1974): interpolates, third order.
    Taps(double position, int length) {
        const double floor = std::floor(position);
        const double t = position - floor;
        weight = {static_cast<float>(((2 - t) * t - 1) * t / 2),
                  static_cast<float>(((3 * t - 5) * t * t + 2) / 2),
                  static_cast<float>(((4 - 3 * t) * t + 1) * t / 2), static_cast<float>((t - 1) * t * t / 2)};
        const double inside = std::clamp(floor, -4.0, length + 4.0);
        for (int i = 0; i < 4; ++i)
            at[static_cast<std::size_t>(i)] = std::clamp(static_cast<int>(inside) + i - 1, 0, length - 1);
        if (t == 0)
            first = last = 1;
    }
};

/// Calls `sample(columns, rows)` for each sample of an output pixel. @return how many there are.
template <class Sample> int forSamples(const Warp& warp, Size source, int x, int y, const Sample& sample) {
    const PlanePoint middle{x + 0.5, y + 0.5};
    const Eigen::Matrix2d step = warp.jacobian(middle);
    // A step of little more than 1 does not justify a second sample.
    constexpr double kSlack = 0.25;
    const double shrinks = std::max(step.col(0).norm(), step.col(1).norm());
    const int n = std::clamp(static_cast<int>(std::ceil(shrinks - kSlack)), 1, kMostSamples);
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const PlanePoint at = warp.toSource({x + (i + 0.5) / n, y + (j + 0.5) / n});
            sample(Taps(at.x - 0.5, source.width), Taps(at.y - 0.5, source.height));
        }
    return n * n;
}

float sampled(const PlaneView& plane, const Taps& columns, const Taps& rows) {
    if (columns.first == columns.last && rows.first == rows.last)
        return plane(columns.at[1], rows.at[1]);
    float sum = 0;
    for (auto j = static_cast<std::size_t>(rows.first); j <= static_cast<std::size_t>(rows.last); ++j) {
        const float* row = plane.row(rows.at[j]);
        float across = 0;
        for (auto i = static_cast<std::size_t>(columns.first); i <= static_cast<std::size_t>(columns.last);
             ++i)
            across += columns.weight[i] * row[columns.at[i]];
        sum += rows.weight[j] * across;
    }
    return sum;
}

bool anyHidden(const PlaneView& mask, const Taps& columns, const Taps& rows) {
    for (auto j = static_cast<std::size_t>(rows.first); j <= static_cast<std::size_t>(rows.last); ++j)
        for (auto i = static_cast<std::size_t>(columns.first); i <= static_cast<std::size_t>(columns.last);
             ++i)
            if (mask(columns.at[i], rows.at[j]) == 0)
                return true;
    return false;
}

} // namespace

Image resampled(const ImageView& source, const Warp& warp, const std::function<void()>& check) {
    Image result(warp.size(), source.channels);
    for (int y = 0; y < result.height(); ++y) {
        check();
        for (int x = 0; x < result.width(); ++x) {
            const int count =
                forSamples(warp, source.size(), x, y, [&](const Taps& columns, const Taps& rows) {
                    for (int c = 0; c < source.channels; ++c)
                        result(x, y, c) += sampled(source.plane(c), columns, rows);
                });
            for (int c = 0; count > 1 && c < source.channels; ++c)
                result(x, y, c) /= static_cast<float>(count);
        }
    }
    return result;
}

Image resampledMask(const ImageView& mask, const Warp& warp, const std::function<void()>& check) {
    Image result(warp.size(), 1);
    for (int y = 0; y < result.height(); ++y) {
        check();
        for (int x = 0; x < result.width(); ++x) {
            bool hidden = false;
            forSamples(warp, mask.size(), x, y, [&](const Taps& columns, const Taps& rows) {
                hidden = hidden || anyHidden(mask.plane(0), columns, rows);
            });
            result(x, y, 0) = hidden ? 0.0F : 1.0F;
        }
    }
    return result;
}

} // namespace texloom
