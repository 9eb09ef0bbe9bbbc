#include "core/analysis/difference.h"
#include "tests/support/textures.h"

#include <gtest/gtest.h>

#include <cmath>

namespace texloom {
namespace {

using test::blobs;

TEST(Difference, IsThatOfEverySampleInDoublePrecision) {
    const Image a = blobs({37, 23}, 3, 1);
    const Image b = blobs({37, 23}, 3, 2);
    double absolute = 0, squared = 0, relative = 0;
    float largest = 0;
    for (int c = 0; c < 3; ++c)
        for (int y = 0; y < 23; ++y)
            for (int x = 0; x < 37; ++x) {
                const double apart =
                    std::abs(static_cast<double>(a(x, y, c)) - static_cast<double>(b(x, y, c)));
                absolute += apart;
                squared += apart * apart;
                relative += apart / (std::abs(static_cast<double>(b(x, y, c))) + 0.01);
                largest = std::max(largest, std::abs(a(x, y, c) - b(x, y, c)));
            }
    const double count = 37.0 * 23 * 3;
    const Difference found = difference(a, b, DifferenceKind::Absolute);
    EXPECT_NEAR(found.number, absolute / count, 1e-7);
    EXPECT_EQ(found.largest, largest);
    EXPECT_EQ(found.image(5, 7, 2), std::abs(a(5, 7, 2) - b(5, 7, 2)));
    EXPECT_NEAR(difference(a, b, DifferenceKind::Squared).number, std::sqrt(squared / count), 1e-7);
    EXPECT_NEAR(difference(a, b, DifferenceKind::Relative).number, relative / count, 1e-5);
}

TEST(Difference, IsNothingBetweenEqualsAndOfThePartThatBothHave) {
    const Image large = blobs({40, 30}, 4, 3);
    const Image part(large.view().crop(0, 0, {20, 25}).channelRange(0, 3));
    for (const auto kind : {DifferenceKind::Absolute, DifferenceKind::Squared, DifferenceKind::Relative}) {
        const Difference found = difference(large, part, kind);
        EXPECT_EQ(found.number, 0);
        EXPECT_EQ(found.largest, 0);
        EXPECT_EQ(found.image.size(), (Size{20, 25}));
        EXPECT_EQ(found.image.channels(), 3);
    }
}

} // namespace
} // namespace texloom
