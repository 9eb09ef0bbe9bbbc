#include "core/image/resample.h"

#include "core/image/cubic_taps.h"
#include "core/image/placement.h"

#include <algorithm>
#include <cmath>

namespace texloom {

namespace {

/// Beyond the ends of an axis its outermost pixels are repeated.
SampleTaps tapsAt(double position, int length) {
    return cubicTaps(position, [length](int at) { return std::clamp(at, 0, length - 1); });
}

/// Calls `sample(columns, rows)` for each sample of an output pixel. @return how many there are.
template <class Sample> int forSamples(const Warp& warp, Size source, int x, int y, const Sample& sample) {
    const PlanePoint middle{x + 0.5, y + 0.5};
    const Eigen::Matrix2d step = warp.jacobian(middle);
    const int n = samplesFor(std::max(step.col(0).norm(), step.col(1).norm()));
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const PlanePoint at = warp.toSource({x + (i + 0.5) / n, y + (j + 0.5) / n});
            sample(tapsAt(at.x - 0.5, source.width), tapsAt(at.y - 0.5, source.height));
        }
    return n * n;
}

bool anyHidden(const PlaneView& mask, const SampleTaps& columns, const SampleTaps& rows) {
    for (int j = 0; j < rows.count; ++j)
        for (int i = 0; i < columns.count; ++i)
            if (mask(columns.at[static_cast<std::size_t>(i)], rows.at[static_cast<std::size_t>(j)]) == 0)
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
                forSamples(warp, source.size(), x, y, [&](const SampleTaps& columns, const SampleTaps& rows) {
                    for (int c = 0; c < source.channels; ++c)
                        result(x, y, c) += sampleAt(source.plane(c), columns, rows);
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
            forSamples(warp, mask.size(), x, y, [&](const SampleTaps& columns, const SampleTaps& rows) {
                hidden = hidden || anyHidden(mask.plane(0), columns, rows);
            });
            result(x, y, 0) = hidden ? 0.0F : 1.0F;
        }
    }
    return result;
}

Size sizeWithin(Size size, int longest) {
    if (size.longerSide() <= longest)
        return size;
    const double scale = static_cast<double>(longest) / size.longerSide();
    const auto side = [&](int length) { return std::max(1, static_cast<int>(std::lround(length * scale))); };
    return {side(size.width), side(size.height)};
}

Image resized(const ImageView& source, Size to, const std::function<void()>& check) {
    Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();
    matrix(0, 0) = static_cast<double>(source.width) / to.width;
    matrix(1, 1) = static_cast<double>(source.height) / to.height;
    return resampled(source, Placement(to, matrix), check);
}

} // namespace texloom
