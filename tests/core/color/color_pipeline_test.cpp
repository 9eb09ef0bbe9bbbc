#include "core/base/error.h"
#include "core/color/color_pipeline.h"
#include "tests/core/color/srgb.h"
#include "tests/support/textures.h"

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <stdexcept>

namespace texloom::test {

namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

Image pixel(std::initializer_list<float> samples) {
    Image image({1, 1}, static_cast<int>(samples.size()));
    int channel = 0;
    for (const float sample : samples)
        image(0, 0, channel++) = sample;
    return image;
}

/// Every half that is finite and not negative, from small to large.
std::vector<double> halves() {
    std::vector<double> values;
    for (int bits = 0; bits < 0x7c00; ++bits) {
        const int exponent = bits >> 10, mantissa = bits & 1023;
        values.push_back(exponent == 0 ? std::ldexp(mantissa, -24)
                                       : std::ldexp(1024 + mantissa, exponent - 25));
    }
    return values;
}

} // namespace

TEST(ColorPipeline, PassesEightBitSrgbBitForBit) {
    Image image({256, 1}, 3);
    for (int x = 0; x < 256; ++x)
        for (int c = 0; c < 3; ++c)
            image(x, 0, c) = static_cast<float>(x) / 255.0F;
    Image converted = image;
    color::toWorking(converted, "srgb");
    EXPECT_TRUE(samePixels(converted, image));
    color::fromWorking(converted, "srgb");
    EXPECT_TRUE(samePixels(converted, image));
}

TEST(ColorPipeline, WorkingValuesFollowTheSrgbCurve) {
    for (const float light : {0.0F, 0.001F, 0.0031F, 0.0032F, 0.18F, 0.5F, 1.0F, 4.0F, 100.0F}) {
        Image image = pixel({light, light, light});
        color::toWorking(image, "linear");
        EXPECT_NEAR(image(0, 0, 1), encoded(light), 2e-5 * std::max(1.0, encoded(light))) << light;
    }
}

TEST(ColorPipeline, EveryLinearHalfComesBackAsTheSameHalf) {
    const std::vector<double> values = halves();
    Image image({static_cast<int>(values.size()), 1}, 3);
    for (int x = 0; x < image.width(); ++x)
        for (int c = 0; c < 3; ++c)
            image(x, 0, c) = static_cast<float>(values[static_cast<std::size_t>(x)]);
    color::toWorking(image, "linear");
    color::fromWorking(image, "linear");
    int moved = 0;
    for (std::size_t i = 1; i + 1 < values.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            const auto back = static_cast<double>(image(static_cast<int>(i), 0, c));
            moved += back <= (values[i - 1] + values[i]) / 2 || back >= (values[i] + values[i + 1]) / 2;
        }
    EXPECT_EQ(moved, 0);
}

TEST(ColorPipeline, AcescgWhiteIsWhite) {
    Image image = pixel({1, 1, 1});
    color::toWorking(image, "acescg");
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(image(0, 0, c), 1, 1e-5);
}

TEST(ColorPipeline, AcescgPrimariesAreTheColumnsOfTheMatrix) {
    // AP1 to Rec.709 with Bradford's adaptation from the ACES white to D65, row by row.
    constexpr std::array<std::array<double, 3>, 3> kMatrix = {{{1.70505099, -0.62179212, -0.08325887},
                                                               {-0.13025642, 1.14080474, -0.01054832},
                                                               {-0.02400336, -0.12896898, 1.15297233}}};
    for (std::size_t primary = 0; primary < 3; ++primary) {
        Image image({1, 1}, 3);
        image(0, 0, static_cast<int>(primary)) = 1;
        color::toWorking(image, "acescg");
        color::fromWorking(image, "linear");
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(image(0, 0, static_cast<int>(c)), kMatrix[c][primary], 2e-5) << primary << ' ' << c;
    }
}

TEST(ColorPipeline, AcescgComesBack) {
    const Image original = noise({31, 17}, 3);
    Image image = original;
    color::toWorking(image, "acescg");
    color::fromWorking(image, "acescg");
    for (int c = 0; c < 3; ++c)
        for (int y = 0; y < 17; ++y)
            for (int x = 0; x < 31; ++x)
                ASSERT_NEAR(image(x, y, c), original(x, y, c), 1e-5);
}

TEST(ColorPipeline, NeverTouchesData) {
    const Image original = noise({31, 17}, 3);
    Image image = original;
    color::toWorking(image, "raw");
    color::fromWorking(image, "raw");
    EXPECT_TRUE(samePixels(image, original));
}

TEST(ColorPipeline, NeverTouchesAlphaOrFurtherChannels) {
    const Image original = noise({31, 17}, 6);
    Image image = original;
    color::toWorking(image, "linear");
    for (int c = 0; c < 6; ++c) {
        bool same = true;
        for (int y = 0; y < 17; ++y)
            for (int x = 0; x < 31; ++x)
                same = same && image(x, y, c) == original(x, y, c);
        EXPECT_EQ(same, c >= 3) << c;
    }
}

TEST(ColorPipeline, TakesGreyAsEqualParts) {
    for (const char* space : {"linear", "acescg"}) {
        Image grey = pixel({0.25F});
        Image color = pixel({0.25F, 0.25F, 0.25F});
        color::toWorking(grey, space);
        color::toWorking(color, space);
        EXPECT_NEAR(grey(0, 0, 0), color(0, 0, 1), 1e-5) << space;
        EXPECT_NEAR(grey(0, 0, 0), encoded(0.25), 1e-5) << space;
    }
}

TEST(ColorPipeline, ConvertsGreyBesideAnUntouchedAlpha) {
    Image image = pixel({0.25F, 0.25F});
    color::toWorking(image, "linear");
    EXPECT_NEAR(image(0, 0, 0), encoded(0.25), 1e-5);
    EXPECT_EQ(image(0, 0, 1), 0.25F);
}

TEST(ColorPipeline, ConvertsEveryRowOfAnOddWidth) {
    Image image = constant({33, 5}, 3, 0.25F);
    color::toWorking(image, "linear");
    const ValueRange range = valueRange(image);
    EXPECT_EQ(range.smallest, range.largest);
    EXPECT_NEAR(range.smallest, encoded(0.25), 1e-5);
}

/// Large images are converted a few rows at a time, between which the work can be stopped.
TEST(ColorPipeline, AsksAllTheWhileAndGivesTheSameAsRowByRow) {
    const Image original = noise({700, 500}, 3);
    Image image = original;
    int asked = 0;
    color::toWorking(image, "acescg", [&asked] { ++asked; });
    EXPECT_GE(asked, 5);
    for (const int y : {0, 92, 93, 94, 311, 499}) {
        Image row(original.view().crop(0, y, {700, 1}));
        color::toWorking(row, "acescg");
        EXPECT_TRUE(samePixels(row, image.view().crop(0, y, {700, 1}))) << y;
    }
    const auto stop = [] { throw std::length_error("stop"); };
    FileColor power;
    power.curve = FileColor::Curve::Power;
    power.power = 1.8;
    EXPECT_THROW(color::toWorking(image, power, stop), std::length_error);
    EXPECT_THROW(color::fromWorking(image, power, stop), std::length_error);
    EXPECT_THROW(color::fromWorking(image, "linear", stop), std::length_error);
}

TEST(ColorPipeline, DisplayShowsWorkingValuesAsTheyAre) {
    const Image original = noise({9, 9}, 3);
    Image image = original;
    color::toDisplay(image);
    for (int c = 0; c < 3; ++c)
        for (int y = 0; y < 9; ++y)
            for (int x = 0; x < 9; ++x)
                ASSERT_NEAR(image(x, y, c), original(x, y, c), 1e-6);
}

TEST(ColorPipeline, NamesAnUnknownSpaceAndTheKnownOnes) {
    Image image = pixel({1, 1, 1});
    EXPECT_THAT([&] { color::toWorking(image, "rec2020"); },
                ThrowsMessage<UsageError>(AllOf(HasSubstr("rec2020"), HasSubstr("srgb"), HasSubstr("acescg"),
                                                HasSubstr("linear"), HasSubstr("raw"))));
}

} // namespace texloom::test
