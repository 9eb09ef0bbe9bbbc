#include "core/match/flat_shares.h"
#include "tests/support/textures.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace texloom::test {
namespace {

constexpr int kFlatPatch = 7;

/// Noise with a flat square from `left`, `top` to the borders.
Image withFlatCorner(Size size, int left, int top) {
    Image image = noise(size, 2);
    for (int c = 0; c < 2; ++c)
        for (int y = top; y < size.height; ++y)
            for (int x = left; x < size.width; ++x)
                image(x, y, c) = 0.25F;
    return image;
}

TEST(FlatShares, areTheShareOfPixelsInFlatParts) {
    const Image image = withFlatCorner({30, 25}, 17, 14);
    const FlatShares found(std::vector<PatchSource>{{image.view(), {}}}, kFlatPatch, [] {});
    ASSERT_EQ(found.shares().size(), 1U);
    const Image& shares = found.shares().front();
    ASSERT_EQ(shares.size(), (Size{24, 19}));
    double sum = 0;
    for (int y = 0; y < 19; ++y)
        for (int x = 0; x < 24; ++x) {
            const int across = std::clamp(x + kFlatPatch - 17, 0, kFlatPatch);
            const int down = std::clamp(y + kFlatPatch - 14, 0, kFlatPatch);
            EXPECT_NEAR(shares(x, y, 0), across * down / 49.0,
                        0.03); // noise is flat by chance here and there
            sum += static_cast<double>(shares(x, y, 0));
        }
    EXPECT_NEAR(found.usual(), sum / (24 * 19), 1e-6);
    EXPECT_TRUE(found.any());
}

TEST(FlatShares, onlyWhatMasksAllowCounts) {
    const Image flat = withFlatCorner({30, 25}, 17, 14), plain = noise({20, 20}, 2);
    Image mask = constant({30, 25}, 1, 1);
    mask(23, 20, 0) = 0; // in every flat patch
    const FlatShares masked(std::vector<PatchSource>{{flat.view(), mask.view().plane(0)}}, kFlatPatch, [] {});
    EXPECT_FALSE(masked.any());
    EXPECT_GT(masked.usual(), 0);
    const std::vector<PatchSource> weighed = {{flat.view(), {}, 3}, {plain.view(), {}, 1}};
    const FlatShares both(weighed, kFlatPatch, [] {}),
        alone(std::span<const PatchSource>(weighed).first(1), kFlatPatch, [] {});
    EXPECT_NEAR(both.usual(), alone.usual() * 3 * 24 * 19 / (3.0 * 24 * 19 + 14 * 14), 1e-4);
}

TEST(FlatShares, ordinaryExemplarsHaveNoFlatPatch) {
    for (const Image& image : {noise({40, 40}, 3), blobs({40, 40}, 3)})
        EXPECT_FALSE(FlatShares(std::vector<PatchSource>{{image.view(), {}}}, kFlatPatch, [] {}).any());
}

} // namespace
} // namespace texloom::test
