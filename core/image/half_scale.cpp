#include "core/image/half_scale.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace texloom {

namespace {

constexpr int kTaps = 6;

/// exp(−d²/(2·0.8²)) at distances 2.5, 1.5 and 0.5 px to either side, normalised to sum 1.
std::array<float, kTaps> gaussianTaps() {
    std::array<float, kTaps> taps{};
    float sum = 0;
    for (int i = 0; i < kTaps; ++i) {
        const double distance = i - 2.5;
        taps[static_cast<std::size_t>(i)] = static_cast<float>(std::exp(-distance * distance / (2 * 0.64)));
        sum += taps[static_cast<std::size_t>(i)];
    }
    for (float& tap : taps)
        tap /= sum;
    return taps;
}

int halfOf(int side) {
    return std::max(1, side / 2);
}

/// Where to interpolate between two neighbours.
struct Between {
    int first, second;
    float share; ///< of the second
};

Between between(int at, int length, int from) {
    const double place = (at + 0.5) * from / length - 0.5;
    const double below = std::floor(place);
    const int first = (static_cast<int>(below) + from) % from;
    return {first, (first + 1) % from, static_cast<float>(place - below)};
}

} // namespace

Image halved(const ImageView& image, const std::function<void()>& check) {
    const std::array<float, kTaps> taps = gaussianTaps();
    Image narrow({halfOf(image.width), image.height}, image.channels);
    Image half({narrow.width(), halfOf(image.height)}, image.channels);
    for (int c = 0; c < image.channels; ++c) {
        for (int y = 0; y < image.height; ++y) {
            check();
            const float* from = image.plane(c).row(y);
            float* to = narrow.plane(c).row(y);
            for (int x = 0; x < narrow.width(); ++x)
                for (int i = 0; i < kTaps; ++i)
                    to[x] += taps[static_cast<std::size_t>(i)] *
                             from[std::clamp(2 * x + i - 2, 0, image.width - 1)];
        }
        for (int y = 0; y < half.height(); ++y) {
            check();
            for (int i = 0; i < kTaps; ++i) {
                const float* from = narrow.plane(c).row(std::clamp(2 * y + i - 2, 0, image.height - 1));
                float* to = half.plane(c).row(y);
                for (int x = 0; x < half.width(); ++x)
                    to[x] += taps[static_cast<std::size_t>(i)] * from[x];
            }
        }
    }
    return half;
}

Image halvedMask(const PlaneView& mask, const std::function<void()>& check) {
    Image half({halfOf(mask.width), halfOf(mask.height)}, 1);
    for (int y = 0; y < half.height(); ++y) {
        check();
        for (int x = 0; x < half.width(); ++x) {
            const int x1 = std::min(2 * x + 1, mask.width - 1), y1 = std::min(2 * y + 1, mask.height - 1);
            const bool whole =
                mask(2 * x, 2 * y) != 0 && mask(x1, 2 * y) != 0 && mask(2 * x, y1) != 0 && mask(x1, y1) != 0;
            half(x, y, 0) = whole ? 1.0F : 0.0F;
        }
    }
    return half;
}

void enlargeRow(const PlaneView& plane, Size size, int y, float* to) {
    const Between v = between(y, size.height, plane.height);
    const float* above = plane.row(v.first);
    const float* below = plane.row(v.second);
    for (int x = 0; x < size.width; ++x) {
        const Between u = between(x, size.width, plane.width);
        const float upper = above[u.first] + u.share * (above[u.second] - above[u.first]);
        const float lower = below[u.first] + u.share * (below[u.second] - below[u.first]);
        to[x] = upper + v.share * (lower - upper);
    }
}

} // namespace texloom
