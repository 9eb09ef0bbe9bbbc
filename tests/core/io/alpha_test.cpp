#include "core/image/hidden_colour.h"
#include "core/io/image_file.h"
#include "tests/core/io/foreign_files.h"
#include "tests/core/io/write_as.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/textures.h"

#include <gtest/gtest.h>

#include <array>
#include <utility>
#include <vector>

namespace texloom::test {

namespace {

/// One colour everywhere.
Image plain(const std::vector<float>& color, Size size = {4, 3}) {
    Image image(size, static_cast<int>(color.size()));
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            for (int c = 0; c < image.channels(); ++c)
                image(x, y, c) = color[static_cast<std::size_t>(c)];
    return image;
}

void expectColor(const Image& image, const std::vector<float>& color, float tolerance) {
    ASSERT_EQ(image.channels(), static_cast<int>(color.size()));
    for (int c = 0; c < image.channels(); ++c)
        EXPECT_NEAR(image(1, 1, c), color[static_cast<std::size_t>(c)], tolerance) << "channel " << c;
}

struct Format {
    const char* name;
    Depth depth;
    float tolerance;
};

} // namespace

TEST(Alpha, AnExrHoldsColoursTimesAlpha) {
    const TemporaryFolder folder;
    writeForeign(folder / "a.exr", plain({0.25F, 0.125F, 0, 0.5F}));
    expectColor(readImage(folder / "a.exr").image, {0.5F, 0.25F, 0, 0.5F}, 0);
    expectColor(readImage(folder / "a.exr", {.data = true}).image, {0.25F, 0.125F, 0, 0.5F}, 0);
}

TEST(Alpha, ATiffSaysWhichItHolds) {
    const TemporaryFolder folder;
    writeForeign(folder / "a.tif", plain({0.4F, 0.2F, 0, 0.4F})); // ExtraSamples 1, as our own never are
    expectColor(readImage(folder / "a.tif").image, {1, 0.5F, 0, 0.4F}, 0.001F);
    writeImage(folder / "own.tif", plain({1, 0.6F, 0, 0.4F}), as(Depth::Bits8));
    expectColor(readImage(folder / "own.tif").image, {1, 0.6F, 0, 0.4F}, 0.001F);
}

TEST(Alpha, EveryFormatGivesBackWhatWasWritten) {
    const TemporaryFolder folder;
    for (const auto& [name, depth, tolerance] :
         {Format{"a.png", Depth::Bits8, 1e-6F}, Format{"a.png", Depth::Bits16, 1e-6F},
          Format{"a.tif", Depth::Bits8, 1e-6F}, Format{"a.tif", Depth::Float, 1e-6F},
          Format{"a.exr", Depth::Half, 1e-3F}, Format{"a.exr", Depth::Float, 1e-6F}})
        for (const std::vector<float>& color : {std::vector<float>{0.2F, 0.6F, 1, 0.4F}, {0.8F, 0.4F}}) {
            writeImage(folder / name, plain(color), as(depth));
            expectColor(readImage(folder / name).image, color, tolerance);
        }
}

TEST(Alpha, DataIsNeverMultiplied) {
    const TemporaryFolder folder;
    writeImage(folder / "a.exr", plain({0.2F, 0.6F, 1, 0.4F}), as(Depth::Float, "raw"));
    expectColor(readImage(folder / "a.exr", {.data = true}).image, {0.2F, 0.6F, 1, 0.4F}, 0);
}

TEST(Alpha, LightWithoutCoverStays) {
    const TemporaryFolder folder;
    writeForeign(folder / "a.exr", plain({0.5F, 0, 0, 0}));
    expectColor(readImage(folder / "a.exr").image, {0.5F, 0, 0, 0}, 0);
}

TEST(FillHidden, TakesColoursFromTheVisibleAlone) {
    Image image = plain({1, 0, 1, 0}, {37, 23});
    for (int y = 0; y < 23; ++y)
        for (int x = 0; x < 37; ++x)
            if ((x / 5 + y / 4) % 3 == 0) {
                image(x, y, 0) = 0.2F;
                image(x, y, 1) = 0.5F + 0.01F * static_cast<float>(x);
                image(x, y, 2) = 0.1F;
                image(x, y, 3) = 1;
            }
    const Image before = image;
    fillHidden(image, 3, {0, 1, 2});
    for (int y = 0; y < 23; ++y)
        for (int x = 0; x < 37; ++x) {
            EXPECT_EQ(image(x, y, 3), before(x, y, 3));
            EXPECT_NEAR(image(x, y, 0), 0.2F, 1e-6F);
            EXPECT_NEAR(image(x, y, 2), 0.1F, 1e-6F);
            EXPECT_NEAR(image(x, y, 1), 0.5F + 0.01F * static_cast<float>(x), 0.1F);
            if (before(x, y, 3) > 0) {
                EXPECT_EQ(image(x, y, 1), before(x, y, 1));
            }
        }
}

TEST(FillHidden, LeavesAloneWhatIsAllHiddenOrAllVisible) {
    for (const float alpha : {0.0F, 1.0F}) {
        Image image = plain({1, 0, 1, alpha});
        fillHidden(image, 3, {0, 1, 2});
        expectColor(image, {1, 0, 1, alpha}, 0);
    }
}

} // namespace texloom::test
