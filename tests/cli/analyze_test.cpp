#include "core/io/image_file.h"
#include "core/io/map_file.h"
#include "tests/cli/program.h"
#include "tests/support/lattices.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/textures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace texloom::test {
namespace {

using testing::HasSubstr;
using Json = nlohmann::json;

const Lattice kTruth{{21.5, 0}, {0, 16}};

class AnalyzeLattice : public ::testing::Test {
protected:
    AnalyzeLattice() {
        writeImage(m_folder / "tiles.png", regularTexture({172, 160}, 3, kTruth, {}, 4), {});
        writeImage(m_folder / "noise.png", noise({64, 64}, 3), {});
    }
    Ended run(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), {"analyze", "lattice"});
        return runCli(arguments, m_folder.path());
    }

    TemporaryFolder m_folder;
};

TEST_F(AnalyzeLattice, PrintsVectorsRunnersUpAndTimeAsJson) {
    const Ended ended = run({"tiles.png", "--json"});
    ASSERT_EQ(ended.status, 0) << ended.err;
    const Json json = Json::parse(ended.out);
    EXPECT_TRUE(json.at("found"));
    EXPECT_GE(json.at("confidence"), 0.5);
    EXPECT_GT(json.at("seconds"), 0);
    const Json& candidates = json.at("candidates");
    ASSERT_GE(candidates.size(), 2U);
    EXPECT_LE(candidates.size(), 4U);
    const Json& v1 = candidates[0].at("v1");
    const Json& v2 = candidates[0].at("v2");
    EXPECT_TRUE((Lattice{{v1[0], v1[1]}, {v2[0], v2[1]}}.like(kTruth, 0.5)));
    EXPECT_GT(candidates[0].at("goodness"), candidates[1].at("goodness"));
    EXPECT_EQ(candidates[0].at("wrappingRectangle"), Json::parse("[43, 16]"));
}

TEST_F(AnalyzeLattice, TakesWhatDecidesBetweenLattices) {
    writeImage(m_folder / "squares.png", nearlyAlikeSquares(), {});
    const auto area = [&](const char* alpha) {
        const Ended ended = run({"squares.png", "--json", "--alpha", alpha, "--significance", "0.9"});
        EXPECT_EQ(ended.status, 0) << ended.err;
        const Json best = Json::parse(ended.out).at("candidates")[0];
        return Lattice{{best["v1"][0], best["v1"][1]}, {best["v2"][0], best["v2"][1]}}.area();
    };
    EXPECT_NEAR(area("1.12"), 512, 10);
    EXPECT_NEAR(area("1.4"), 256, 10);
    EXPECT_EQ(run({"squares.png", "--alpha", "0.5"}).status, 2);
    EXPECT_EQ(run({"squares.png", "--significance", "1.5"}).status, 2);
}

TEST_F(AnalyzeLattice, PrintsTextAndWritesThePicture) {
    const Ended ended = run({"tiles.png", "--picture", "gamma.exr"});
    ASSERT_EQ(ended.status, 0) << ended.err;
    EXPECT_THAT(ended.out, HasSubstr("confidence"));
    EXPECT_THAT(ended.out, HasSubstr("43 × 16 px"));
    const LoadedImage picture = readImage(m_folder / "gamma.exr");
    EXPECT_EQ(picture.image.size(), (Size{343, 319}));
    EXPECT_NEAR(picture.image(171, 159, 0), 1, 1e-3);
}

TEST_F(AnalyzeLattice, SaysWhereThereIsNone) {
    const Ended ended = run({"noise.png"});
    EXPECT_EQ(ended.status, 0);
    EXPECT_THAT(ended.out, testing::AnyOf(HasSubstr("too little"), HasSubstr("Nothing")));
    EXPECT_FALSE(Json::parse(run({"noise.png", "--json"}).out).at("found"));
}

TEST_F(AnalyzeLattice, RefusesWhatItCannotRead) {
    EXPECT_EQ(run({"nothing.png"}).status, 1);
    EXPECT_EQ(run({}).status, 2);
    EXPECT_EQ(runCli({"analyze"}, m_folder.path()).status, 2);
    EXPECT_EQ(run({"tiles.png", "--picture", "gamma.doc"}).status, 2);
}

TEST(AnalyzeQuality, MeasuresInnovationOfAnyTextureAlike) {
    const TemporaryFolder folder;
    writeImage(folder / "exemplar.png", blobs({64, 60}, 3), {});
    writeImage(folder / "other.png", blobs({64, 60}, 3, 9), {});
    const auto innovation = [&](const char* result) {
        const Ended ended = runCli({"analyze", "quality", result, "exemplar.png", "--json"}, folder.path());
        EXPECT_EQ(ended.status, 0) << ended.err;
        return Json::parse(ended.out).at("Innovation, estimated").get<double>();
    };
    EXPECT_EQ(innovation("exemplar.png"), 0);
    EXPECT_GT(innovation("other.png"), 0.3);
}

TEST(AnalyzeQuality, SeesWhereAMapIsNotTheTextures) {
    const TemporaryFolder folder;
    writeImage(folder / "exemplar.png", blobs({64, 60}, 3), {});
    writePositionMap(folder / "small.png", PositionMap::identity({30, 30}));
    const Ended ended =
        runCli({"analyze", "quality", "exemplar.png", "exemplar.png", "--map", "small.png"}, folder.path());
    EXPECT_EQ(ended.status, 2);
    EXPECT_THAT(ended.err, testing::AllOf(testing::HasSubstr("30 × 30"), testing::HasSubstr("64 × 60")));
}

TEST(AnalyzeMaps, WritesPicturesOfWhatWasCopied) {
    const TemporaryFolder folder;
    const Image exemplar = blobs({64, 60}, 3);
    writeImage(folder / "exemplar.png", exemplar, {});
    const Image part(exemplar.view().crop(10, 20, {40, 30}));
    writeImage(folder / "part.png", part, {});
    const auto run = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), {"analyze", "maps", "part.png", "exemplar.png"});
        return runCli(arguments, folder.path());
    };
    const Ended ended = run({"--picture", "maps", "--neighbourhood", "7", "--json"});
    ASSERT_EQ(ended.status, 0) << ended.err;
    const Json figures = Json::parse(ended.out);
    EXPECT_EQ(figures.at("Innovation, estimated"), 0);
    EXPECT_NEAR(figures.at("Jump where pieces meet").get<double>(), 0, 1e-6);
    // A part has the colours of its places in the exemplar's picture.
    const Image positions = readImage(folder / "maps" / "exemplar_positions.png").image;
    const Image synthesis = readImage(folder / "maps" / "part_synthesis.png").image;
    EXPECT_TRUE(samePixels(synthesis, Image(positions.view().crop(10, 20, {40, 30}))));
    EXPECT_EQ(readImage(folder / "maps" / "part_copied.png").image.size(), (Size{40, 30}));

    EXPECT_EQ(run({"--neighbourhood", "3"}).status, 2);
    EXPECT_EQ(run({"--neighbourhood", "8"}).status, 2);
}

} // namespace
} // namespace texloom::test
