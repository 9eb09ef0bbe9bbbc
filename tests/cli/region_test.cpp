#include "core/io/image_file.h"
#include "tests/cli/program.h"
#include "tests/support/lattices.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/textures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace texloom::test {
namespace {

using testing::HasSubstr;
using Json = nlohmann::json;

class Regions : public ::testing::Test {
protected:
    Regions() {
        writeImage(m_folder / "tiles.png", regularTexture({96, 90}, 3, {{17.5, 0}, {0, 13}}, {0, 0.3, 0}, 4),
                   {});
        writeImage(m_folder / "tiles_normal.png", blobs({96, 90}, 3), {});
    }
    Ended synth(std::vector<std::string> options, const std::string& output,
                const std::string& size = "300x210") const {
        std::vector<std::string> arguments = {"synth", "near-regular", "tiles.png", "--size",
                                              size,    "-o",           output};
        arguments.insert(arguments.end(), options.begin(), options.end());
        return runCli(arguments, m_folder.path());
    }
    Image image(const std::string& name) const { return readImage(m_folder / name).image; }

    TemporaryFolder m_folder;
};

TEST_F(Regions, EqualThatPartOfTheWhole) {
    ASSERT_EQ(synth({}, "whole.png").status, 0);
    const Ended ended = synth({"--region", "130,50,90,120", "--map", "map.exr"}, "part.png");
    ASSERT_EQ(ended.status, 0) << ended.err;
    EXPECT_THAT(ended.out, HasSubstr("90 × 120 px"));
    const Image whole = image("whole.png");
    EXPECT_TRUE(samePixels(image("part.png"), whole.view().crop(130, 50, {90, 120})));

    EXPECT_EQ(Json::parse(readText(m_folder / "part.json")).at("region"), Json::parse("[130, 50, 90, 120]"));
    ASSERT_EQ(runCli({"run", "part.png", "-o", "again.png"}, m_folder.path()).status, 0);
    EXPECT_TRUE(samePixels(image("again.png"), image("part.png")));
    ASSERT_EQ(runCli({"apply", "map.exr", "tiles.png", "-o", "applied.png"}, m_folder.path()).status, 0);
    EXPECT_TRUE(samePixels(image("applied.png"), image("part.png")));
}

TEST_F(Regions, AreRefusedInASentence) {
    for (const char* text : {"1,2,3", "1,2,3,x", "-1,0,5,5", "0,0,0,5", "290,0,11,5", ""}) {
        const Ended ended = synth({"--region", text}, "part.png");
        EXPECT_EQ(ended.status, *text ? 2 : ended.status) << text;
        EXPECT_LE(ended.complaints(), 1);
    }
    const Ended ended =
        runCli({"synth", "quilting", "tiles.png", "-o", "q.png", "--region", "0,0,9,9"}, m_folder.path());
    EXPECT_EQ(ended.status, 2);
    EXPECT_THAT(ended.err, HasSubstr("cannot make a part"));
}

TEST_F(Regions, WriteWhatDoesNotFitInMemoryStripByStrip) {
    ASSERT_EQ(synth({}, "whole.png", "1000x3000").status, 0);
    const Ended ended = synth({"--memory", "190", "--report", "report.json"}, "strips.png", "1000x3000");
    ASSERT_EQ(ended.status, 0) << ended.err;
    EXPECT_TRUE(samePixels(image("strips.png"), image("whole.png")));
    const Json report = Json::parse(readText(m_folder / "report.json"));
    EXPECT_LE(report.at("estimate").at("bytes"), 190 << 20);
    ASSERT_EQ(runCli({"run", "strips.json", "-o", "again.png", "--memory", "190"}, m_folder.path()).status,
              0);
    EXPECT_TRUE(samePixels(image("again.png"), image("whole.png")));

    for (const std::vector<std::string>& more :
         {std::vector<std::string>{"--map", "map.exr"}, {"--companion", "tiles_normal.png"}}) {
        std::vector<std::string> options = {"--memory", "190"};
        options.insert(options.end(), more.begin(), more.end());
        const Ended refused = synth(options, "no.png", "1000x3000");
        EXPECT_EQ(refused.status, 2);
        EXPECT_THAT(refused.err, HasSubstr("strips"));
        EXPECT_FALSE(std::filesystem::exists(m_folder / "no.png"));
    }
    const Ended none = synth({"--memory", "1"}, "no.png");
    EXPECT_EQ(none.status, 1);
    EXPECT_THAT(none.err, HasSubstr("MiB"));
}

TEST_F(Regions, OfTheLargeToolsEqualTheWholeAndTakeLittleMemory) {
    const std::vector<std::vector<std::string>> tools = {{"wang-tiles", "--set", "tile=24"},
                                                         {"anamorphosis", "--set", "kind=turbulence"},
                                                         {"regular-tile"},
                                                         {"random-mosaic", "--set", "stitch=cut"}};
    for (const std::vector<std::string>& tool : tools) {
        const auto made = [&](const std::vector<std::string>& more, const std::string& output) {
            std::vector<std::string> arguments = {"synth",  "",          "tiles.png", "-o",         output,
                                                  "--size", "1000x4000", "--report",  "report.json"};
            arguments[1] = tool.front();
            arguments.insert(arguments.end(), tool.begin() + 1, tool.end());
            arguments.insert(arguments.end(), more.begin(), more.end());
            const Ended ended = runCli(arguments, m_folder.path());
            EXPECT_EQ(ended.status, 0) << tool.front() << ": " << ended.err;
            return Json::parse(readText(m_folder / "report.json")).at("estimate").at("bytes").get<double>();
        };
        const double whole = made({}, "whole.tif");
        EXPECT_LT(made({"--memory", "170"}, "strips.tif"), 0.7 * whole) << tool.front();
        made({"--region", "700,2500,90,120", "--memory", "190"}, "part.tif");
        const Image all = image("whole.tif");
        EXPECT_TRUE(samePixels(image("strips.tif"), all)) << tool.front();
        EXPECT_TRUE(samePixels(image("part.tif"), all.view().crop(700, 2500, {90, 120}))) << tool.front();
    }
}

TEST_F(Regions, GiveTheTileSetToOtherProgramsWithItsCompanions) {
    const Ended ended = runCli({"synth", "wang-tiles", "tiles.png", "-o", "out.png", "--size", "100", "--set",
                                "tile=20", "--save", "tile-sheet=sheet.png", "--save", "tile=tile.png",
                                "--save", "tile-sheet-map=sheet.exr", "--save", "tile-table=table.json"},
                               m_folder.path());
    ASSERT_EQ(ended.status, 0) << ended.err;
    ASSERT_EQ(runCli({"apply", "sheet.exr", "tiles_normal.png", "-o", "normals.png"}, m_folder.path()).status,
              0);
    ASSERT_EQ(runCli({"apply", "sheet.exr", "tiles.png", "-o", "again.png"}, m_folder.path()).status, 0);
    const Image sheet = image("sheet.png");
    EXPECT_TRUE(samePixels(image("again.png"), sheet));
    EXPECT_EQ(image("normals.png").size(), sheet.size());
    const Json table = Json::parse(readText(m_folder / "table.json"));
    const Json &corners = table.at("arrays").at("corners"), &places = table.at("arrays").at("places");
    ASSERT_EQ(corners.size(), 16U);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const std::string number = i == 0 ? "" : "-" + std::to_string(i + 1);
        const int x = places[i][0], y = places[i][1];
        EXPECT_TRUE(samePixels(image("tile" + number + ".png"), sheet.view().crop(x, y, {20, 20}))) << i;
        // An engine that lays tiles by the table finds the one with the colours it asks for.
        const Json& own = corners[i];
        EXPECT_EQ(table.at("arrays").at("numbers")[own[0].get<std::size_t>()][own[1].get<std::size_t>()]
                                                  [own[2].get<std::size_t>()][own[3].get<std::size_t>()],
                  i);
    }
}

TEST_F(Regions, AnSTMapLaysOutAnotherMapAsTheImage) {
    const Ended ended =
        runCli({"synth", "anamorphosis", "tiles.png", "-o", "out.png", "--size", "96x90", "--set",
                "kind=turbulence", "--set", "amplitude=0.4", "--save", "stmap=st.exr"},
               m_folder.path());
    ASSERT_EQ(ended.status, 0) << ended.err;
    ASSERT_EQ(runCli({"apply", "st.exr", "tiles.png", "-o", "again.png"}, m_folder.path()).status, 0);
    const Image out = image("out.png"), again = image("again.png"), before = image("tiles.png");
    const auto apart = [&](const Image& other) {
        double squares = 0;
        for (int y = 0; y < out.height(); ++y)
            for (int x = 0; x < out.width(); ++x)
                squares +=
                    std::pow(static_cast<double>(out(x, y, 1)) - static_cast<double>(other(x, y, 1)), 2);
        return std::sqrt(squares / static_cast<double>(out.size().area()));
    };
    ASSERT_EQ(again.size(), out.size());
    EXPECT_LT(apart(again), 1.0 / 255);
    EXPECT_GT(apart(Image(before.view())), 10.0 / 255);
}

TEST_F(Regions, NotesSayWhatTheMethodDecided) {
    writeImage(m_folder / "noise.png", noise({64, 64}, 3), {});
    const Ended ended = runCli(
        {"synth", "near-regular", "noise.png", "-o", "n.png", "--report", "n_report.json"}, m_folder.path());
    EXPECT_EQ(ended.status, 0);
    EXPECT_THAT(ended.out, HasSubstr("No lattice was found in noise"));
    EXPECT_EQ(Json::parse(readText(m_folder / "n_report.json")).at("notes").size(), 1U);
}

} // namespace
} // namespace texloom::test
