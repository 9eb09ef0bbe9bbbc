// Sizes, channels and values of all kinds, and the memory that they take.

#include "core/base/error.h"
#include "tests/methods/conformance/fixture.h"
#include "tests/methods/made_up_ports.h"
#include "tests/methods/process_memory.h"
#include "tests/support/textures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace texloom::test {
namespace {

using testing::HasSubstr;

constexpr double kLong = 6; ///< seconds that a method says it takes

TEST_P(Conformance, memoryStaysWithinTheEstimate) {
    if (kSanitized)
        GTEST_SKIP() << "skipped: a sanitizer's own memory is not the method's";
    Request request;
    Values settings;
    Estimate need;
    // A slow method is held to its word at a smaller output, which is still most of what it takes.
    for (Size size{1500, 1400}; size.width > 300; size = {size.width / 2, size.height / 2}) {
        request = requestFor({200, 180}, 3, size);
        fillPorts(method().info(), request);
        settings = briefSettings(method(), request);
        need = planFor(method(), request, settings, 2).estimate;
        if (need.seconds < kLong)
            break;
    }
    const std::uint64_t bytes = need.bytes;
    const auto growth = peakGrowth([&] { runWith(method(), request, settings, 2); });
    if (!growth)
        GTEST_SKIP() << "skipped: the kernel does not let the peak be reset";
    EXPECT_GT(*growth, bytes / 20) << "the estimate has nothing to do with the run";
    EXPECT_LE(*growth, bytes);
}

TEST_P(Conformance, tinyExemplarsAreRefusedInASentenceOrWork) {
    for (const Size size : {Size{1, 1}, Size{2, 2}, Size{3, 40}, Size{9, 9}})
        try {
            const Synthesis result = runWith(method(), requestFor(size, 3, {40, 40}), 1);
            EXPECT_EQ(result.image.size(), (Size{40, 40}));
        } catch (const UsageError& error) {
            EXPECT_THAT(error.what(), HasSubstr("px"));
        }
}

TEST_P(Conformance, sizesThatMakeNoSenseAreRefused) {
    for (const Size size : {Size{0, 10}, Size{10, 0}, Size{-3, 5}, Size{200000, 200000}})
        EXPECT_THROW(runWith(method(), requestFor({64, 64}, 3, size), 1), UsageError);
}

TEST_P(Conformance, oddSizesChannelsAndValuesGiveSoundResults) {
    for (const int channels : {1, 2, 5})
        for (const Size size : {Size{1, 1}, Size{3, 200}, Size{97, 1}, Size{131, 113}}) {
            const Synthesis result = runWith(method(), requestFor({53, 47}, channels, size), 2);
            EXPECT_EQ(result.image.size(), size);
            const ValueRange range = valueRange(result.image);
            EXPECT_TRUE(std::isfinite(range.smallest) && std::isfinite(range.largest));
        }
}

TEST_P(Conformance, constantExemplarGivesThatConstant) {
    if (!learns(method().info()))
        GTEST_SKIP() << "skipped: " << GetParam() << " learns from nothing";
    Request request = requestFor({40, 40}, 3, {90, 70});
    request.exemplars.front().image = shared(constant({40, 40}, 3, 0.25F));
    const ValueRange range = valueRange(runWith(method(), request, 2).image);
    EXPECT_NEAR(range.smallest, 0.25, 1e-4);
    EXPECT_NEAR(range.largest, 0.25, 1e-4);
}

TEST_P(Conformance, valuesAboveOneAreKept) {
    if (!learns(method().info()))
        GTEST_SKIP() << "skipped: " << GetParam() << " learns from nothing";
    Request request = requestFor({48, 48}, 3, {96, 96});
    Image bright = blobs({48, 48}, 3);
    for (int c = 0; c < 3; ++c)
        for (int y = 0; y < 48; ++y)
            for (int x = 0; x < 48; ++x)
                bright(x, y, c) = 40 * bright(x, y, c);
    request.exemplars.front().image = shared(std::move(bright));
    EXPECT_GT(valueRange(runWith(method(), request, 1).image).largest, 10) << "a mean may be half of 40";
}

} // namespace
} // namespace texloom::test
