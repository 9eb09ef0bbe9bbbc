#include "core/methods/sparse/enlarged_cubic.h"

#include "core/base/at.h"
#include "core/image/cubic_taps.h"

#include <algorithm>
#include <vector>

namespace texloom::sparse {

namespace {

/// Where each value of a line of `result` pixels comes from.
std::vector<SampleTaps> tapsAlong(int length, int result, bool wraps) {
    std::vector<SampleTaps> taps;
    for (int i = 0; i < result; ++i)
        taps.push_back(cubicTaps((i + 0.5) * length / result - 0.5, [&](int pixel) {
            return wraps ? ((pixel % length) + length) % length : std::clamp(pixel, 0, length - 1);
        }));
    return taps;
}

} // namespace

Image enlargedCubic(const Image& image, Size size, Wrap wrap, JobContext& context) {
    const std::vector<SampleTaps> across = tapsAlong(image.width(), size.width, wrap.x);
    const std::vector<SampleTaps> down = tapsAlong(image.height(), size.height, wrap.y);
    Image rows({size.width, image.height()}, image.channels());
    context.parallel(0, image.height(), [&](int y) {
        for (int c = 0; c < image.channels(); ++c) {
            const float* from = image.plane(c).row(y);
            float* to = rows.plane(c).row(y);
            for (const SampleTaps& taps : across) {
                float sum = 0;
                for (std::size_t k = 0; k < at(taps.count); ++k)
                    sum += taps.weight[k] * from[taps.at[k]];
                *to++ = sum;
            }
        }
    });
    Image large(size, image.channels());
    context.parallel(0, size.height, [&](int y) {
        const SampleTaps& taps = down[at(y)];
        for (int c = 0; c < image.channels(); ++c)
            for (std::size_t k = 0; k < at(taps.count); ++k) {
                const float* from = rows.plane(c).row(taps.at[k]);
                float* to = large.plane(c).row(y);
                for (int x = 0; x < size.width; ++x)
                    to[x] += taps.weight[k] * from[x];
            }
    });
    return large;
}

} // namespace texloom::sparse
