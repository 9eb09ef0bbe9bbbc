#include "core/io/image_file.h"
#include "tests/cli/program.h"
#include "tests/support/textures.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <utility>
#include <vector>

namespace texloom::test {

namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using Json = nlohmann::json;

/// A folder with bark.png and batch.json: a sweep of four small quiltings, and a run whose recipe is missing.
class Batch : public ::testing::Test {
protected:
    Batch() {
        writeImage(m_folder / "bark.png", blobs({48, 44}, 3), {});
        const Json recipe = {{"texloom", 1},
                             {"method", "quilting"},
                             {"exemplars", {{{"file", "bark.png"}}}},
                             {"size", {40, 40}},
                             {"seed", 3}};
        write({{{"recipe", recipe},
                {"output", "$name_${patch}_s$seed.png"},
                {"sweep", {{"patch", {8, 12}}, {"seed", {1, 2}}}}},
               {{"recipe", "gone.json"}, {"output", "gone.png"}}});
    }
    void write(const Json& runs) const {
        writeText(m_folder / "batch.json", Json{{"batch", 1}, {"runs", runs}}.dump());
    }
    Ended run(std::vector<std::string> options) const {
        options.insert(options.begin(), {"batch", "batch.json"});
        return runCli(options, m_folder.path());
    }
    bool has(const char* name) const { return fs::exists(m_folder / name); }

    TemporaryFolder m_folder;
};

} // namespace

TEST_F(Batch, OneFailureDoesNotStopTheOthersAndIsNamed) {
    const Ended ended = run({"--summary", "summary.json", "--quiet"});
    EXPECT_EQ(ended.status, 1);
    EXPECT_EQ(ended.complaints(), 2) << ended.err;
    EXPECT_THAT(ended.err, HasSubstr("run 5: "));
    EXPECT_THAT(ended.err, HasSubstr("1 of 5 runs failed: 5; 4 done."));
    for (const char* name : {"bark_8_s1.png", "bark_8_s2.png", "bark_12_s1.png", "bark_12_s2.json"})
        EXPECT_TRUE(has(name)) << name;
    const Json summary = Json::parse(readText(m_folder / "summary.json"));
    EXPECT_EQ(summary.at("done"), 4);
    EXPECT_EQ(summary.at("runs").at(4).at("status"), "failed");
    const Ended again = runCli({"run", "bark_12_s2.png", "-o", "again.png"}, m_folder.path());
    EXPECT_EQ(again.status, 0);
    EXPECT_TRUE(
        samePixels(readImage(m_folder / "again.png").image, readImage(m_folder / "bark_12_s2.png").image));
}

TEST_F(Batch, RunsAreRankedByAFigure) {
    const Json recipe = {{"texloom", 1},
                         {"method", "sparse"},
                         {"parameters", {{"scales", 1}, {"atoms", 32}, {"learning-iterations", 2}}},
                         {"exemplars", {{{"file", "bark.png"}}}},
                         {"size", {40, 40}},
                         {"seed", 3}};
    write({{{"recipe", recipe}, {"output", "$iterations.png"}, {"sweep", {{"iterations", {1, 9, 4}}}}}});
    const Ended ended = run({"--summary", "summary.json", "--rank", "Energy of a pixel", "--quiet"});
    ASSERT_EQ(ended.status, 0) << ended.err;
    std::vector<std::pair<double, std::string>> wanted;
    const Json summary = Json::parse(readText(m_folder / "summary.json"));
    for (const Json& made : summary.at("runs"))
        wanted.emplace_back(made.at("figures").at("Energy of a pixel"), made.at("cell"));
    std::sort(wanted.begin(), wanted.end());
    std::size_t from = 0;
    for (const auto& [energy, cell] : wanted) {
        from = ended.out.find(cell, from);
        ASSERT_NE(from, std::string::npos) << ended.out;
    }
    const Ended unknown = run({"--rank", "Energie", "--quiet", "--overwrite"});
    EXPECT_EQ(unknown.status, 2);
    EXPECT_THAT(unknown.err, HasSubstr("\"Energie\"; there are: Energy of a pixel"));
}

TEST_F(Batch, ARunThatIsRefusedByTheSystemDoesNotStopTheOthers) {
    const Json recipe = Json::parse(readText(m_folder / "batch.json")).at("runs").at(0).at("recipe");
    write({{{"recipe", recipe}, {"output", std::string(300, 'a') + ".png"}},
           {{"recipe", recipe}, {"output", "b.png"}}});
    const Ended ended = run({"--quiet"});
    EXPECT_THAT(ended.err, HasSubstr("1 of 2 runs failed: 1; 1 done."));
    EXPECT_TRUE(has("b.png"));
}

TEST_F(Batch, ShardsDoEachRunOnce) {
    EXPECT_EQ(run({"--shard", "1/2", "--quiet"}).status, 1);
    EXPECT_TRUE(has("bark_8_s1.png") && has("bark_12_s1.png"));
    EXPECT_FALSE(has("bark_8_s2.png") || has("bark_12_s2.png"));
    EXPECT_EQ(run({"--shard", "2/2", "--quiet"}).status, 0);
    EXPECT_TRUE(has("bark_8_s2.png") && has("bark_12_s2.png"));
}

TEST_F(Batch, SkipsWhatIsThereOnlyWhenTold) {
    writeText(m_folder / "bark_8_s1.png", "mine");
    const Ended skipping = run({"--shard", "1/4", "--skip-existing", "--summary", "summary.json"});
    EXPECT_THAT(skipping.err, HasSubstr("1 of 2 runs failed: 5; 0 done, 1 skipped."));
    EXPECT_EQ(readText(m_folder / "bark_8_s1.png"), "mine");
    run({"--shard", "1/4", "--overwrite"});
    EXPECT_EQ(readImageInfo(m_folder / "bark_8_s1.png").size, (Size{40, 40}));
}

TEST_F(Batch, WritesToAnotherFolderWhenTold) {
    fs::create_directory(m_folder / "made");
    EXPECT_EQ(run({"--shard", "1/5", "--to", "made", "--quiet"}).status, 0);
    EXPECT_TRUE(has("made/bark_8_s1.png"));
    EXPECT_FALSE(has("bark_8_s1.png"));
}

TEST_F(Batch, ListsItsRunsWithoutDoingThem) {
    const Ended ended = run({"--list", "--shard", "2/5"});
    EXPECT_EQ(ended.status, 0);
    EXPECT_EQ(ended.out, "run 2 (patch=8, seed=2): bark_8_s2.png\n");
    EXPECT_FALSE(has("bark_8_s2.png"));
}

TEST_F(Batch, RefusesABrokenFileWithOneLine) {
    for (const auto& [options, part] : std::vector<std::pair<std::vector<std::string>, std::string>>{
             {{"--shard", "3/2"}, "3/2"}, {{"--summary", "gone/a.json"}, "gone"}}) {
        const Ended ended = run(options);
        EXPECT_NE(ended.status, 0);
        EXPECT_EQ(ended.complaints(), 1);
        EXPECT_THAT(ended.err, HasSubstr(part));
    }
    write({{{"recipe", "a.json"}, {"output", "a.png"}, {"sweep", {{"seed", Json::array()}}}}});
    const Ended ended = run({});
    EXPECT_EQ(ended.status, 2);
    EXPECT_EQ(ended.complaints(), 1);
    EXPECT_THAT(ended.err, HasSubstr("runs[0].sweep.seed"));
    EXPECT_EQ(m_folder.entries(), 2);
}

TEST_F(Batch, JoinsImagesByATool) {
    writeImage(m_folder / "moss.png", noise({60, 44}, 3, 2), {});
    const Json join = {
        {"tool", "poisson-mix"},
        {"exemplars",
         {{{"file", "bark.png"}}, {{"file", "moss.png"}, {"edits", {{{"crop", {4, 0, 48, 44}}}}}}}}};
    write({{{"join", join}, {"output", "mixed_$preference.png"}, {"sweep", {{"preference", {1, 4}}}}}});
    Ended ended = run({"--quiet"});
    ASSERT_EQ(ended.status, 0) << ended.err;
    Image moss = readImage(m_folder / "moss.png").image;
    moss = Image(moss.view().crop(4, 0, {48, 44}));
    writeImage(m_folder / "cropped.png", moss, {});
    for (const char* preference : {"1", "4"}) {
        const std::string mixed = std::string("mixed_") + preference + ".png";
        ended = runCli({"poisson-mix", "bark.png", "cropped.png", "-o", "alone.png", "--preference",
                        preference, "--overwrite", "--quiet"},
                       m_folder.path());
        ASSERT_EQ(ended.status, 0) << ended.err;
        EXPECT_TRUE(samePixels(readImage(m_folder / mixed).image, readImage(m_folder / "alone.png").image));
    }
    EXPECT_FALSE(
        samePixels(readImage(m_folder / "mixed_1.png").image, readImage(m_folder / "mixed_4.png").image));
    EXPECT_FALSE(has("mixed_1.json"));
    // A run must not write over what another one reads.
    write({{{"join", join}, {"output", "moss.png"}}});
    ended = run({"--quiet"});
    EXPECT_EQ(ended.status, 2);
    EXPECT_THAT(ended.err, HasSubstr("moss.png"));
    // Images of two sizes are cropped to what they have in common.
    write({{{"join",
             {{"tool", "poisson-mix"}, {"exemplars", {{{"file", "bark.png"}}, {{"file", "moss.png"}}}}}},
            {"output", "sizes.png"}}});
    ended = run({});
    ASSERT_EQ(ended.status, 0) << ended.err;
    EXPECT_THAT(ended.out, HasSubstr("both are cropped to 48 × 44 px"));
    EXPECT_EQ(readImage(m_folder / "sizes.png").image.size(), (Size{48, 44}));
    // Pictures that cannot be joined are that run's failure.
    writeImage(m_folder / "grey.png", noise({48, 44}, 1, 2), {});
    write({{{"join",
             {{"tool", "poisson-mix"}, {"exemplars", {{{"file", "bark.png"}}, {{"file", "grey.png"}}}}}},
            {"output", "channels.png"}}});
    ended = run({"--quiet"});
    EXPECT_EQ(ended.status, 1);
    EXPECT_THAT(ended.err, HasSubstr("3 channels"));
}

} // namespace texloom::test
