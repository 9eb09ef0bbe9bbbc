#include "core/io/image_file.h"
#include "tests/cli/program.h"
#include "tests/support/textures.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <utility>

namespace texloom::test {
namespace {

using ::testing::HasSubstr;

/// A folder with a.png and b.png, 64 × 60 px, and small.png.
class Blending : public ::testing::Test {
protected:
    Blending() {
        writeImage(m_folder / "a.png", blobs({64, 60}, 3, 1), {});
        writeImage(m_folder / "b.png", blobs({64, 60}, 3, 2), {});
        writeImage(m_folder / "small.png", blobs({32, 30}, 3), {});
    }
    Image image(const std::string& name) const { return readImage(m_folder / name).image; }
    TemporaryFolder m_folder;
};

TEST_F(Blending, joinsTwoImagesInEveryWay) {
    for (const char* curve : {"horizontal", "vertical", "circular"})
        for (const char* method : {"cut", "poisson", "midway"}) {
            const Ended ended = runCli({"blend", "a.png", "b.png", "-o", "out.png", "--curve", curve,
                                        "--method", method, "--band", "10", "--quiet"},
                                       m_folder.path());
            ASSERT_EQ(ended.status, 0) << ended.err;
            const Image out = image("out.png");
            EXPECT_EQ(out.size(), (Size{64, 60}));
            EXPECT_EQ(out(2, 2, 0), image("a.png")(2, 2, 0));
            EXPECT_EQ(out(61, 57, 0), image("b.png")(61, 57, 0));
        }
}

TEST_F(Blending, mixesByGradients) {
    // A constant has no gradient that is longer than another: what it is mixed with stays.
    writeImage(m_folder / "plain.png", constant({64, 60}, 3, 0.4F), {});
    for (const char* border : {"free", "first", "wrap"}) {
        const Ended ended = runCli({"poisson-mix", "a.png", "plain.png", "-o", "out.png", "--border", border,
                                    "--overwrite", "--quiet"},
                                   m_folder.path());
        ASSERT_EQ(ended.status, 0) << ended.err;
        const Image out = image("out.png"), a = image("a.png");
        for (int y = 0; y < 60; ++y)
            for (int x = 0; x < 64; ++x)
                ASSERT_NEAR(out(x, y, 1), a(x, y, 1), 1.01 / 255) << border;
    }
}

TEST_F(Blending, clonesAMaskedRegionAndNothingElse) {
    Image mask = constant({64, 60}, 1, 1);
    for (int y = 20; y < 40; ++y)
        for (int x = 10; x < 30; ++x)
            mask(x, y, 0) = 0;
    writeImage(m_folder / "mask.png", mask, {});
    const Ended ended = runCli({"poisson-clone", "a.png", "b.png", "-o", "out.png", "--mask", "mask.png",
                                "--offset-x", "15", "--offset-y", "-5", "--quiet"},
                               m_folder.path());
    ASSERT_EQ(ended.status, 0) << ended.err;
    const Image out = image("out.png"), a = image("a.png");
    int changed = 0;
    for (int y = 0; y < 60; ++y)
        for (int x = 0; x < 64; ++x) {
            const bool inside = x >= 25 && x < 45 && y >= 15 && y < 35;
            if (!inside) {
                ASSERT_EQ(out(x, y, 0), a(x, y, 0)) << x << ", " << y;
            } else
                changed += out(x, y, 0) != a(x, y, 0) ? 1 : 0;
        }
    EXPECT_GT(changed, 200);
}

TEST_F(Blending, imagesOfTwoSizesAreCroppedToTheCommonOne) {
    writeImage(m_folder / "wide.png", blobs({80, 50}, 3, 4), {});
    writeImage(m_folder / "a_cropped.png", Image(image("a.png").view().crop(0, 0, {64, 50})), {});
    writeImage(m_folder / "wide_cropped.png", Image(image("wide.png").view().crop(0, 0, {64, 50})), {});
    const std::pair<const char*, const char*> joins[] = {{"blend", "--band=8"},
                                                         {"poisson-mix", "--preference=1"}};
    for (const auto& [tool, option] : joins) {
        const Ended ended =
            runCli({tool, "a.png", "wide.png", "-o", "out.png", "--overwrite", option}, m_folder.path());
        ASSERT_EQ(ended.status, 0) << ended.err;
        EXPECT_THAT(ended.out, testing::AllOf(HasSubstr("64 × 60 px"), HasSubstr("80 × 50 px"),
                                              HasSubstr("cropped to 64 × 50 px")));
        const Ended alone =
            runCli({tool, "a_cropped.png", "wide_cropped.png", "-o", "alone.png", "--overwrite", option},
                   m_folder.path());
        ASSERT_EQ(alone.status, 0) << alone.err;
        EXPECT_THAT(alone.out, testing::Not(HasSubstr("cropped to")));
        EXPECT_TRUE(samePixels(image("out.png"), image("alone.png"))) << tool;
    }
}

TEST_F(Blending, refusesToJoinWhatDiffers) {
    writeImage(m_folder / "grey.png", noise({64, 60}, 1), {});
    const auto complaint = [&](const std::vector<std::string>& arguments) {
        const Ended ended = runCli(arguments, m_folder.path());
        EXPECT_EQ(ended.status, 2);
        EXPECT_EQ(ended.complaints(), 1);
        return ended.err;
    };
    EXPECT_THAT(complaint({"poisson-mix", "a.png", "grey.png", "-o", "out.png"}),
                testing::AllOf(HasSubstr("3 channels"), HasSubstr("1;")));
    EXPECT_THAT(complaint({"poisson-clone", "a.png", "grey.png", "-o", "out.png"}), HasSubstr("3 channels"));
    EXPECT_THAT(complaint({"poisson-clone", "a.png", "b.png", "-o", "out.png", "--offset-x", "70"}),
                HasSubstr("64 × 60 px"));
    EXPECT_THAT(complaint({"poisson-mix", "a.png", "b.png", "-o", "out.png", "--preference", "11"}),
                testing::AllOf(HasSubstr("11"), HasSubstr("0.1 to 10")));
    EXPECT_FALSE(std::filesystem::exists(m_folder / "out.png"));
}

TEST_F(Blending, refusesWhatItCannotBlend) {
    const auto complaint = [&](const std::vector<std::string>& more) {
        std::vector<std::string> arguments = {"blend", "a.png"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Ended ended = runCli(arguments, m_folder.path());
        EXPECT_EQ(ended.status, 2);
        EXPECT_EQ(ended.complaints(), 1);
        return ended.err;
    };
    EXPECT_THAT(complaint({"small.png", "-o", "out.png", "--band", "16"}), HasSubstr("15 px"));
    EXPECT_THAT(complaint({"b.png", "-o", "out.png", "--band", "31"}), HasSubstr("30 px"));
    EXPECT_THAT(complaint({"b.png", "-o", "a.png", "--band", "8"}), HasSubstr("would be overwritten"));
    EXPECT_THAT(complaint({"b.png", "-o", "out.png", "--method", "glue"}), HasSubstr("glue"));
    EXPECT_FALSE(std::filesystem::exists(m_folder / "out.png"));
}

TEST_F(Blending, statisticsGrowWithTheNumberOfNeighbours) {
    const Ended ended = runCli({"analyze", "statistics", "a.png", "--patch", "8,16,100", "--neighbours",
                                "5,20,100000", "--patches", "3", "--json"},
                               m_folder.path());
    ASSERT_EQ(ended.status, 0) << ended.err;
    const nlohmann::json json = nlohmann::json::parse(ended.out);
    EXPECT_EQ(json["patchSizes"], (std::vector<int>{8, 16}));
    for (const auto& row : json["meanDeviation"]) {
        EXPECT_GT(row[0], 0.0);
        EXPECT_GT(row[1], row[0]);
        EXPECT_TRUE(row[2].is_null());
    }
    const Ended refused = runCli({"analyze", "statistics", "small.png", "--patch", "40"}, m_folder.path());
    EXPECT_EQ(refused.status, 2);
    EXPECT_THAT(refused.err, HasSubstr("30 px"));
}

} // namespace
} // namespace texloom::test
