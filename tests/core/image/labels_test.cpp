#include "core/image/extension.h"
#include "core/image/labels.h"
#include "core/image/selection.h"
#include "tests/support/textures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <utility>
#include <vector>

namespace texloom::test {
namespace {

/// Indices from 0 to 3 in areas with holes and spurs.
Image areas(Size size) {
    Image made = blobs(size, 1);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            made(x, y, 0) = std::floor(made(x, y, 0) * 3.999F);
    return made;
}

/// The pixels that a path by sides through one value leads to, by trying until nothing changes.
std::set<std::pair<int, int>> areaAround(const Image& indices, int x, int y) {
    std::set<std::pair<int, int>> area = {{x, y}};
    for (std::size_t before = 0; before != area.size();) {
        before = area.size();
        for (int v = 0; v < indices.height(); ++v)
            for (int u = 0; u < indices.width(); ++u)
                if (indices(u, v, 0) == indices(x, y, 0) &&
                    (area.contains({u - 1, v}) || area.contains({u + 1, v}) || area.contains({u, v - 1}) ||
                     area.contains({u, v + 1})))
                    area.insert({u, v});
    }
    return area;
}

} // namespace

TEST(Labels, aFillReachesWhatAPathBySidesReachesAndNothingElse) {
    const Image indices = areas({37, 29});
    for (const auto& [x, y] : {std::pair(0, 0), std::pair(18, 14), std::pair(36, 28), std::pair(20, 3)}) {
        const Image filled = labels::filled(indices, x, y, 7);
        const auto area = areaAround(indices, x, y);
        for (int v = 0; v < indices.height(); ++v)
            for (int u = 0; u < indices.width(); ++u)
                ASSERT_EQ(filled(u, v, 0), area.contains({u, v}) ? 7.0F : indices(u, v, 0)) << u << ", " << v;
    }
}

TEST(Labels, aFillWithTheColourThatIsThereChangesNothing) {
    const Image indices = areas({20, 20});
    EXPECT_TRUE(samePixels(labels::filled(indices, 5, 5, static_cast<int>(indices(5, 5, 0))), indices));
}

TEST(Labels, theCornersOfAreasDoNotJoinThem) {
    Image indices({2, 2}, 1);
    indices(1, 0, 0) = indices(0, 1, 0) = 1;
    const Image filled = labels::filled(indices, 0, 0, 2);
    EXPECT_EQ(filled(0, 0, 0), 2);
    EXPECT_EQ(filled(1, 1, 0), 0);
}

TEST(Labels, aPictureComesBackFromItsIndicesToTheBit) {
    const labels::Palette palette = labels::usualColours(3);
    const Image indices = areas({31, 17});
    const Image picture = labels::pictureOf(indices, palette);
    EXPECT_TRUE(samePixels(labels::indicesOf(picture, palette), indices));
    const auto found = labels::flatColours(picture, 4);
    ASSERT_TRUE(found);
    EXPECT_TRUE(samePixels(labels::pictureOf(labels::indicesOf(picture, *found), *found), picture));
    EXPECT_FALSE(labels::flatColours(picture, found->size() - 1)) << "more colours than are allowed";
}

TEST(Labels, usualColoursDifferWhateverTheChannels) {
    for (const int channels : {1, 2, 3, 4, 6}) {
        const labels::Palette palette = labels::usualColours(channels);
        ASSERT_EQ(palette.size(), 8U);
        EXPECT_EQ(std::set(palette.begin(), palette.end()).size(), palette.size()) << channels;
        for (const labels::Colour& colour : palette)
            EXPECT_EQ(colour.size(), static_cast<std::size_t>(channels));
    }
    EXPECT_EQ(labels::usualColours(4).front().back(), 1.0F) << "no colour is transparent";
}

TEST(Labels, joinedPalettesKeepTheFirstOnesPlaces) {
    const labels::Palette usual = labels::usualColours(3), first = {usual[2], {0.25F, 0.5F, 0.75F}};
    const labels::Palette joined = labels::joined(first, usual, 5);
    EXPECT_EQ(joined, (labels::Palette{first[0], first[1], usual[0], usual[1], usual[3]}));
    EXPECT_EQ(labels::joined(first, usual, 1), first) << "none is taken away";
}

TEST(Labels, aShapeIsPaintedWhereItIsAtLeastHalf) {
    const Size size{8, 4};
    Image shape(size, 1);
    shape(3, 1, 0) = 0.5F;
    shape(4, 1, 0) = 0.49F;
    shape(5, 2, 0) = 1;
    const Image made = labels::painted(Image(size, 1), shape, 3);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            EXPECT_EQ(made(x, y, 0), shape(x, y, 0) >= 0.5F ? 3.0F : 0.0F) << x << ", " << y;
}

TEST(Extension, thePictureLiesWhereTheMarginsLeaveIt) {
    const Image picture = blobs({9, 7}, 2);
    const Margins margins{3, 2, 5, 1};
    const Image made = extended(picture, margins, {0.25F, 0.75F});
    ASSERT_EQ(made.size(), (Size{17, 10}));
    EXPECT_TRUE(samePixels(made.view().crop(3, 2, picture.size()), picture));
    for (int y = 0; y < made.height(); ++y)
        for (int x = 0; x < made.width(); ++x) {
            const bool within = x >= 3 && x < 12 && y >= 2 && y < 9;
            if (!within) {
                EXPECT_EQ(made(x, y, 0), 0.25F) << x << ", " << y;
                EXPECT_EQ(made(x, y, 1), 0.75F) << x << ", " << y;
            }
        }
    EXPECT_TRUE(samePixels(extended(picture, {}, {0, 0}), picture));
}

} // namespace texloom::test
