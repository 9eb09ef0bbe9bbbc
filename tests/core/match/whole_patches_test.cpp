#include "core/match/whole_patches.h"
#include "tests/support/textures.h"

#include <gtest/gtest.h>

#include <utility>

namespace texloom::test {

namespace {

/// Hides about a tenth of the pixels.
Image mottled(Size size) {
    Image mask = noise(size, 1, 3);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            mask(x, y, 0) = mask(x, y, 0) < 0.1F ? 0.0F : 1.0F;
    return mask;
}

bool whole(const Image& mask, int left, int top, int patch) {
    for (int y = top; y < top + patch; ++y)
        for (int x = left; x < left + patch; ++x)
            if (mask(x, y, 0) == 0)
                return false;
    return true;
}

} // namespace

TEST(WholePatches, AreThoseThatLookingAtEveryPixelFinds) {
    const Image mask = mottled({41, 29});
    for (const int patch : {1, 3, 5}) {
        std::vector<std::pair<int, int>> expected, found;
        for (int y = 0; y + patch <= mask.height(); ++y)
            for (int x = 0; x + patch <= mask.width(); ++x)
                if (whole(mask, x, y, patch))
                    expected.emplace_back(x, y);
        ASSERT_FALSE(expected.empty());
        anyWholePatch(mask.view().plane(0), patch, [&](int x, int y) {
            found.emplace_back(x, y);
            return false;
        });
        EXPECT_EQ(found, expected) << patch;
        EXPECT_TRUE(leavesWholePatch(mask.view().plane(0), patch));
    }
    EXPECT_FALSE(leavesWholePatch(mask.view().plane(0), 29));
    EXPECT_FALSE(leavesWholePatch(constant({4, 4}, 1, 1).view().plane(0), 5));
}

} // namespace texloom::test
