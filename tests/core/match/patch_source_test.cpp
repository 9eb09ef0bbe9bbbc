#include "core/match/patch_source.h"
#include "tests/support/textures.h"

#include <gtest/gtest.h>

#include <vector>

namespace texloom::test {

TEST(PatchSource, VarianceIsThatOfAllPixelsTogether) {
    // Distances of 1 and 2 from the means in 6 pixels, and of 3 and 0 in 2 pixels.
    const Image near = stacked(std::vector<ImageView>{constant({3, 2}, 1, 1.5F), constant({3, 2}, 1, 1.0F)});
    const Image far = stacked(std::vector<ImageView>{constant({1, 2}, 1, 3.5F), constant({1, 2}, 1, -1.0F)});
    const std::vector<PatchSource> sources{{near.view(), {}}, {far.view(), {}}};
    EXPECT_DOUBLE_EQ(pixelVariance(sources, std::vector<double>{0.5, -1.0}, [] {}),
                     (6 * (1 + 4) + 2 * 9) / 8.0);
}

} // namespace texloom::test
