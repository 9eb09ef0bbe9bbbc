#include "core/analysis/map_usage.h"
#include "core/methods/method.h"
#include "tests/support/method_run.h"
#include "tests/support/textures.h"

#include <gtest/gtest.h>

#include <cmath>

namespace texloom::test::patchmatch_tests {

namespace {

Synthesis made(const Request& request, const Values& settings = {}) {
    return resultOf(findMethod("patchmatch"), request, settings);
}

double meanDifference(const ImageView& a, const ImageView& b) {
    double sum = 0;
    for (int c = 0; c < a.channels; ++c)
        for (int y = 0; y < a.height; ++y)
            for (int x = 0; x < a.width; ++x)
                sum += std::abs(static_cast<double>(a(x, y, c) - b(x, y, c)));
    return sum / (static_cast<double>(a.size().area()) * a.channels);
}

} // namespace

TEST(PatchMatchSynthesis, sourcesAreWhereTheMaskAllows) {
    Request request = requestOf(blobs({64, 64}, 3), {150, 130});
    Image mask = constant({64, 64}, 1, 1);
    for (int y = 0; y < 64; ++y)
        for (int x = 30; x < 45; ++x)
            mask(x, y, 0) = 0;
    request.exemplars.front().inputs.set(kMaskPort, std::make_shared<const Image>(mask));
    const Synthesis result = made(request);
    for (int y = 0; y < 130; ++y)
        for (int x = 0; x < 150; ++x) {
            const Source& source = result.map.at(x, y);
            ASSERT_EQ(mask(source.x, source.y, 0), 1) << source.x << ", " << source.y;
        }
}

TEST(PatchMatchSynthesis, everyExemplarIsUsed) {
    Request request = requestOf(blobs({64, 64}, 3), {200, 200});
    request.exemplars.push_back({"second", std::make_shared<const Image>(blobs({80, 48}, 3, 4))});
    const Synthesis result = made(request);
    const std::vector<Image> use = occurrencesOf(result.map);
    for (const Image& image : use)
        EXPECT_GT(channelMeans(image)[0], 0.05);
}

TEST(PatchMatchSynthesis, startsFromWhatTheInitialImageShows) {
    const Image exemplar = blobs({96, 96}, 3);
    Request request = requestOf(exemplar, {96, 96});
    request.inputs.set(kInitialPort, std::make_shared<const Image>(exemplar));
    EXPECT_LT(meanDifference(made(request).image, exemplar),
              0.25 * meanDifference(blobs({96, 96}, 3, 9), exemplar));
}

TEST(PatchMatchSynthesis, uniformityEvensOutWhatIsUsed) {
    const Request request = requestOf(blobs({96, 96}, 3), {256, 256});
    const double plain = occurrenceEntropy(occurrencesOf(made(request, {{"uniformity", 0.0}}).map));
    const double even = occurrenceEntropy(occurrencesOf(made(request, {{"uniformity", 2.0}}).map));
    EXPECT_GT(even, plain);
}

TEST(PatchMatchSynthesis, energyIsRecordedForEveryRound) {
    const Synthesis result =
        made(requestOf(blobs({96, 96}, 1), {128, 128}), {{"iterations", 4}, {"scales", 3}});
    ASSERT_EQ(result.curves.size(), 1U);
    EXPECT_EQ(result.curves.front().values.size(), 2U * 4 + 4 + 4);
    EXPECT_LT(result.curves.front().values[7], result.curves.front().values[0]);
}

} // namespace texloom::test::patchmatch_tests
