#include "core/base/error.h"
#include "core/methods/method.h"
#include "core/methods/texture_transfer/settings.h"
#include "tests/support/method_run.h"
#include "tests/support/textures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace texloom::test::texture_transfer_tests {
namespace {

using texture_transfer::Settings;

std::shared_ptr<const Image> shared(Image image) {
    return std::make_shared<const Image>(std::move(image));
}

Request requestFor(Image exemplar, const Image& target) {
    Request request = requestOf(std::move(exemplar), target.size(), {}, 5);
    request.inputs.add("target", shared(target));
    return request;
}

Synthesis transfer(const Request& request, const Values& settings) {
    return resultOf(findMethod("texture-transfer"), request, settings);
}

/// Only the target counts, and nothing is done to it.
const Values kTargetAlone{{"patch", 12},      {"passes", 1}, {"alpha-first", 0.0},  {"alpha-last", 0.0},
                          {"tolerance", 0.0}, {"blur", 0.0}, {"match-tones", false}};

TEST(TextureTransfer, overlapsAloneArePlainQuilting) {
    Request request = requestFor(blobs({60, 50}, 3), noise({90, 70}, 3));
    const Values settings{{"patch", 16}, {"overlap", 0.25}, {"tolerance", 0.2}};
    const Synthesis made =
        transfer(request, with(settings, {{"passes", 1}, {"alpha-first", 1.0}, {"alpha-last", 1.0}}));
    request.inputs.clear("target");
    const Synthesis plain =
        resultOf(findMethod("quilting"), request, with(settings, {{"contrast", 0.0}, {"variety", 0.0}}));
    EXPECT_TRUE(samePixels(made.image, plain.image));
    EXPECT_EQ(made.map, plain.map);
}

TEST(TextureTransfer, targetThatIsAPartOfTheExemplarComesBack) {
    const Image exemplar = noise({70, 60}, 3);
    for (const Size size : {Size{12, 12}, Size{41, 33}, Size{50, 47}}) {
        const Image target(exemplar.view().crop(9, 7, size));
        const Synthesis made = transfer(requestFor(exemplar, target), kTargetAlone);
        EXPECT_TRUE(samePixels(made.image, target)) << size.width;
        EXPECT_EQ(made.map.at(3, 4).x, 12);
        EXPECT_EQ(made.map.at(3, 4).y, 11);
    }
}

TEST(TextureTransfer, passesKeepATargetThatIsThereAlready) {
    const Image exemplar = noise({70, 60}, 3);
    const Image target(exemplar.view().crop(5, 3, {44, 40}));
    const Synthesis made =
        transfer(requestFor(exemplar, target), with(kTargetAlone, {{"passes", 3}, {"alpha-last", 0.9}}));
    EXPECT_TRUE(samePixels(made.image, target));
}

TEST(TextureTransfer, darkFlatTargetIsStretchedToTheExemplarsTones) {
    // Patches of 12 px that overlap by 3 cover it and reach nowhere beyond.
    const Image exemplar = noise({48, 39}, 1);
    Image target(exemplar);
    for (int y = 0; y < target.height(); ++y)
        for (int x = 0; x < target.width(); ++x)
            target(x, y, 0) = 0.05F + 0.2F * target(x, y, 0);
    const Synthesis made =
        transfer(requestFor(exemplar, target), with(kTargetAlone, {{"match-tones", true}}));
    EXPECT_TRUE(samePixels(made.image, exemplar));
}

TEST(TextureTransfer, firstPatchIsTheNearestInLuminance) {
    const Image exemplar = blobs({40, 36}, 3, 2), target = blobs({30, 30}, 3, 9);
    const auto grey = [](const Image& image, int x, int y) {
        return 0.2126 * image(x, y, 0) + 0.7152 * image(x, y, 1) + 0.0722 * image(x, y, 2);
    };
    constexpr int kPatch = 12;
    double least = HUGE_VAL;
    Source nearest{};
    for (int y = 0; y + kPatch <= exemplar.height(); ++y)
        for (int x = 0; x + kPatch <= exemplar.width(); ++x) {
            double sum = 0;
            for (int v = 0; v < kPatch; ++v)
                for (int u = 0; u < kPatch; ++u)
                    sum += std::pow(grey(exemplar, x + u, y + v) - grey(target, u, v), 2);
            if (sum < least) {
                least = sum;
                nearest = {static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y), 0};
            }
        }
    const Synthesis made = transfer(requestFor(exemplar, target), kTargetAlone);
    EXPECT_EQ(made.map.at(0, 0), nearest);
}

TEST(TextureTransfer, correspondenceTakesThePlaceOfLuminance) {
    // The labels of the exemplar say that its left half is 1; its colours say nothing.
    Request request = requestFor(noise({64, 40}, 3), constant({40, 40}, 1, 1.0F));
    Image labels({64, 40}, 1);
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 32; ++x)
            labels(x, y, 0) = 1;
    request.exemplars.front().inputs.add("correspondence", shared(std::move(labels)));
    const Synthesis made = transfer(request, with(kTargetAlone, {{"patch", 8}}));
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 40; ++x)
            ASSERT_LT(made.map.at(x, y).x, 32) << x << ' ' << y;
}

TEST(TextureTransfer, passesShrinkPatchesAndTrustTheOverlapMore) {
    const Settings settings;
    EXPECT_EQ(settings.patchOf(0), 40);
    EXPECT_EQ(settings.patchOf(1), 27);
    EXPECT_EQ(settings.patchOf(2), 18);
    EXPECT_EQ(settings.patchOf(20), 5);
    EXPECT_DOUBLE_EQ(settings.alpha(0), 0.1);
    EXPECT_DOUBLE_EQ(settings.alpha(1), 0.5);
    EXPECT_DOUBLE_EQ(settings.alpha(2), 0.9);
    Settings once;
    once.passes = 1;
    EXPECT_DOUBLE_EQ(once.alpha(0), 0.5);
}

TEST(TextureTransfer, correspondencesThatDoNotBelongTogetherAreRefused) {
    Request request = requestFor(noise({32, 32}, 3), noise({40, 40}, 3));
    request.exemplars.front().inputs.add("correspondence", shared(noise({32, 32}, 1)));
    EXPECT_THAT(
        [&] {
            transfer(request, {{"patch", 8}});
        },
        testing::ThrowsMessage<UsageError>(testing::HasSubstr("The target has 3 channels")));
    request.exemplars.push_back({"second", shared(noise({32, 32}, 3))});
    EXPECT_THAT(
        [&] {
            transfer(request, {{"patch", 8}});
        },
        testing::ThrowsMessage<UsageError>(testing::HasSubstr("second has no picture that corresponds")));
}

} // namespace
} // namespace texloom::test::texture_transfer_tests
