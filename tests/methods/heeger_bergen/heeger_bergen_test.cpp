#include "core/methods/method.h"
#include "tests/support/method_run.h"
#include "tests/support/textures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace texloom::test::heeger_bergen_tests {
namespace {

Synthesis run(const Image& exemplar, Size size, const Values& settings = {},
              std::shared_ptr<const Image> initial = nullptr, Wrap wrap = {}) {
    Request request = requestOf(exemplar, size, wrap, 4);
    if (initial)
        request.inputs.set(kInitialPort, std::move(initial));
    return resultOf(findMethod("heeger-bergen"), request, settings);
}

std::vector<float> sorted(const ImageView& image) {
    std::vector<float> values;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            values.push_back(image(x, y, 0));
    std::sort(values.begin(), values.end());
    return values;
}

TEST(HeegerBergen, givesTheExemplarsHistogramExactlyAtItsSize) {
    const Image exemplar = blobs({64, 64}, 1);
    const std::vector<float> ours = sorted(run(exemplar, {64, 64}).image), theirs = sorted(exemplar);
    for (std::size_t i = 0; i < ours.size(); ++i)
        ASSERT_NEAR(ours[i], theirs[i], 1e-5);
}

TEST(HeegerBergen, convergesOnAGrainyTexture) {
    const Synthesis result = run(noise({128, 128}, 3), {128, 128});
    ASSERT_EQ(result.curves.front().values.size(), 10U);
    EXPECT_LT(result.curves.front().values.back(), 0.02);
}

TEST(HeegerBergen, aLineUpToItsAngleStaysOne) {
    // Diagonal stripes: differences along the stripes stay far smaller than across them.
    Image stripes({64, 64}, 1);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            stripes(x, y, 0) = static_cast<float>(std::sin((x + y) * 2 * 3.14159265 / 8));
    const Image image = run(stripes, {96, 80}).image;
    double along = 0, across = 0;
    for (int y = 1; y < 80; ++y)
        for (int x = 1; x < 95; ++x) {
            along += std::abs(image(x, y, 0) - image(x + 1, y - 1, 0));
            across += std::abs(image(x, y, 0) - image(x - 1, y - 1, 0));
        }
    EXPECT_LT(along, 0.6 * across);
}

TEST(HeegerBergen, startsFromAnImage) {
    const Image exemplar = blobs({64, 64}, 3);
    const auto initial = std::make_shared<const Image>(exemplar);
    const Image fromItself = run(exemplar, {64, 64}, {{"periodic", false}}, initial, {true, true}).image;
    double worst = 0;
    for (int c = 0; c < 3; ++c)
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x)
                worst =
                    std::max(worst, std::abs(static_cast<double>(fromItself(x, y, c) - exemplar(x, y, c))));
    EXPECT_LT(worst, 1e-3);
}

TEST(HeegerBergen, constantChannelsStayConstant) {
    Image exemplar = blobs({40, 40}, 3);
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 40; ++x)
            exemplar(x, y, 1) = 3;
    const Image image = run(exemplar, {64, 50}).image;
    for (int y = 0; y < 50; ++y)
        for (int x = 0; x < 64; ++x)
            ASSERT_NEAR(image(x, y, 1), 3, 1e-5);
}

} // namespace
} // namespace texloom::test::heeger_bergen_tests
