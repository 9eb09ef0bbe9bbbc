#include "core/image/half_scale.h"
#include "tests/support/textures.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <vector>

namespace texloom::test {

TEST(HalfScale, constantStaysConstantAtAnySize) {
    for (const Size size : {Size{1, 1}, Size{2, 5}, Size{31, 64}}) {
        const Image half = halved(constant(size, 2, 0.75F));
        EXPECT_EQ(half.size(), (Size{std::max(1, size.width / 2), std::max(1, size.height / 2)}));
        EXPECT_NEAR(valueRange(half).smallest, 0.75, 1e-6);
        EXPECT_NEAR(valueRange(half).largest, 0.75, 1e-6);
    }
}

TEST(HalfScale, pixelLiesInTheMiddleOfTheTwoItStandsFor) {
    Image ramp({40, 40}, 2);
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 40; ++x) {
            ramp(x, y, 0) = static_cast<float>(x);
            ramp(x, y, 1) = static_cast<float>(y);
        }
    const Image half = halved(ramp);
    for (int y = 2; y < 18; ++y)
        for (int x = 2; x < 18; ++x) {
            EXPECT_NEAR(half(x, y, 0), 2 * x + 0.5, 1e-4);
            EXPECT_NEAR(half(x, y, 1), 2 * y + 0.5, 1e-4);
        }
}

TEST(HalfScale, maskKeepsOnlyWhatIsWholeUnderneath) {
    Image mask = constant({6, 5}, 1, 1);
    mask(3, 2, 0) = 0;
    const Image half = halvedMask(mask.view().plane(0));
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 3; ++x)
            EXPECT_EQ(half(x, y, 0), x == 1 && y == 1 ? 0 : 1);
}

TEST(HalfScale, canBeStoppedAtEveryRow) {
    const Image image = noise({40, 30}, 2);
    int rows = 0;
    const auto count = [&rows] { ++rows; };
    halved(image, count);
    EXPECT_EQ(rows, 2 * (30 + 15));
    halvedMask(image.view().plane(0), count);
    EXPECT_EQ(rows, 2 * (30 + 15) + 15);
}

TEST(HalfScale, enlargedRowsInterpolateAndCloseOnThemselves) {
    Image image({2, 1}, 1);
    image(0, 0, 0) = 0;
    image(1, 0, 0) = 1;
    std::vector<float> twice(4);
    enlargeRow(image.view().plane(0), {4, 2}, 1, twice.data());
    EXPECT_THAT(twice, ::testing::ElementsAre(0.25F, 0.25F, 0.75F, 0.75F));
    const Image same = blobs({13, 9}, 1);
    std::vector<float> row(13);
    enlargeRow(same.view().plane(0), same.size(), 4, row.data());
    EXPECT_TRUE(std::equal(row.begin(), row.end(), same.view().plane(0).row(4)));
}

} // namespace texloom::test
