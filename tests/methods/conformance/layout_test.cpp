// Outputs that wrap, masks, and exemplars by their weights.

#include "core/base/error.h"
#include "tests/methods/conformance/fixture.h"
#include "tests/support/textures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace texloom::test {
namespace {

/// The seam's mean difference against the largest between two neighbouring lines inside.
double worstInsideX(const ImageView& image) {
    double worst = 0;
    for (int x = 0; x + 1 < image.width; ++x) {
        double sum = 0;
        for (int c = 0; c < image.channels; ++c)
            for (int y = 0; y < image.height; ++y)
                sum += std::abs(static_cast<double>(image(x + 1, y, c) - image(x, y, c)));
        worst = std::max(worst, sum);
    }
    return worst;
}

double seamX(const ImageView& image) {
    double sum = 0;
    for (int c = 0; c < image.channels; ++c)
        for (int y = 0; y < image.height; ++y)
            sum += std::abs(static_cast<double>(image(0, y, c) - image(image.width - 1, y, c)));
    return sum;
}

Image transposed(const ImageView& image) {
    Image turned({image.height, image.width}, image.channels);
    for (int c = 0; c < image.channels; ++c)
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x)
                turned(y, x, c) = image(x, y, c);
    return turned;
}

TEST_P(Conformance, wrappedOutputTilesOnTheChosenAxes) {
    if (!method().info().canWrap())
        GTEST_SKIP() << "skipped: " << GetParam() << " does not say that it wraps";
    const std::pair<Wrap, Size> cases[] = {{{true, false}, {151, 148}}, {{false, true}, {64, 200}},
                                           {{true, false}, {64, 200}},  {{false, true}, {151, 148}},
                                           {{true, true}, {151, 148}},  {{true, true}, {64, 200}}};
    for (const auto& [wrap, size] : cases) {
        Request request = requestFor({64, 64}, 3, size);
        request.wrap = wrap;
        // Even where none shows, the seam is the worst of all columns by chance once in so many: a second
        // seed tells.
        bool across = !wrap.x, down = !wrap.y;
        for (int n = 0; n < 2 && !(across && down); ++n, ++request.seed) {
            const Image image = runWith(method(), request, 2).image, turned = transposed(image);
            across = across || seamX(image) <= worstInsideX(image);
            down = down || seamX(turned) <= worstInsideX(turned);
        }
        EXPECT_TRUE(across) << size.width << " × " << size.height;
        EXPECT_TRUE(down) << size.width << " × " << size.height;
    }
}

TEST_P(Conformance, emptyMaskIsRefused) {
    if (!method().info().heedsMasks())
        GTEST_SKIP() << "skipped: " << GetParam() << " uses no mask";
    Request request = requestFor({64, 64}, 3, {64, 64});
    request.exemplars.front().inputs.set(kMaskPort, shared(constant({64, 64}, 1, 0)));
    EXPECT_THROW(runWith(method(), request, 1), UsageError);
    request.exemplars.front().inputs.set(kMaskPort, shared(constant({64, 63}, 1, 1)));
    EXPECT_THROW(runWith(method(), request, 1), UsageError);
}

TEST_P(Conformance, whatTheMaskHidesIsNeverCopied) {
    if (!method().info().heedsMasks() || !method().info().copiesPixels())
        GTEST_SKIP() << "skipped: " << GetParam() << " copies nothing or uses no mask";
    Request request = requestFor({96, 90}, 3, {130, 110});
    Image mask = constant({96, 90}, 1, 1);
    for (int y = 0; y < 90; ++y)
        for (int x = 0; x < 96; ++x)
            if (x > 84 || (x < 6 && y > 70) || (x == 40 && y > 86))
                mask(x, y, 0) = 0;
    request.exemplars.front().inputs.set(kMaskPort, shared(mask));
    for (const Wrap wrap : {Wrap{}, Wrap{true, true}}) {
        request.wrap = wrap;
        const Synthesis result = runWith(method(), request, 2);
        for (int y = 0; y < result.map.height(); ++y)
            for (int x = 0; x < result.map.width(); ++x)
                ASSERT_NE(mask(result.map.at(x, y).x, result.map.at(x, y).y, 0), 0)
                    << result.map.at(x, y).x << ", " << result.map.at(x, y).y;
    }
}

TEST_P(Conformance, exemplarsCountAsMuchAsTheyWeigh) {
    if (!method().info().heedsWeights())
        GTEST_SKIP() << "skipped: " << GetParam() << " takes all exemplars alike";
    Request request = requestFor({40, 40}, 3, {80, 70});
    request.exemplars.push_back({"another", shared(blobs({36, 44}, 3, 2))});
    const auto weighed = [&](double first, double second) {
        request.exemplars.front().weight = first;
        request.exemplars.back().weight = second;
        return runWith(method(), request, 2);
    };
    const Synthesis plain = weighed(1, 1), first = weighed(20, 0.5), second = weighed(0.5, 20);
    EXPECT_TRUE(samePixels(plain.image, weighed(3, 3).image));
    EXPECT_FALSE(samePixels(first.image, second.image));
    if (!method().info().copiesPixels())
        return;
    const auto pixelsOfFirst = [](const PositionMap& map) {
        int count = 0;
        for (int y = 0; y < map.height(); ++y)
            for (int x = 0; x < map.width(); ++x)
                count += map.at(x, y).exemplar == 0;
        return count;
    };
    EXPECT_GT(pixelsOfFirst(first.map), pixelsOfFirst(second.map));
}

} // namespace
} // namespace texloom::test
