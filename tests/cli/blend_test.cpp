#include "core/io/image_file.h"
#include "tests/cli/program.h"
#include "tests/support/textures.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

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

TEST_F(Blending, refusesWhatItCannotBlend) {
    const auto complaint = [&](const std::vector<std::string>& more) {
        std::vector<std::string> arguments = {"blend", "a.png"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Ended ended = runCli(arguments, m_folder.path());
        EXPECT_EQ(ended.status, 2);
        EXPECT_EQ(ended.complaints(), 1);
        return ended.err;
    };
    EXPECT_THAT(complaint({"small.png", "-o", "out.png", "--band", "8"}), HasSubstr("32 × 30 px"));
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
