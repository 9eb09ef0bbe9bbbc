#include "core/io/image_file.h"
#include "tests/cli/program.h"
#include "tests/support/textures.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <map>

namespace texloom::test {

namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using Json = nlohmann::json;

/// A folder with an exemplar, a recipe and a batch that someone wrote, and whatever else people keep.
class Overwrite : public ::testing::Test {
protected:
    Overwrite() {
        writeImage(m_folder / "tex.png", blobs({32, 32}, 3), {});
        writeImage(m_folder / "other.png", blobs({32, 32}, 3, 5), {});
        const Json recipe = {{"texloom", 1},
                             {"method", "quilting"},
                             {"parameters", {{"patch", 8}}},
                             {"exemplars", {{{"file", "tex.png"}}}},
                             {"size", {24, 24}}};
        writeText(m_folder / "bark.json", recipe.dump());
        writeText(m_folder / "notes.json", R"({"mine": true})");
        writeText(m_folder / "photo.png", "not Texloom's");
        remember();
    }

    void remember() {
        for (const fs::directory_entry& file : fs::directory_iterator(m_folder.path()))
            m_before[file.path()] = readText(file.path());
    }

    /// Runs a command that must be refused in one line that holds these words, with nothing touched.
    void refused(const std::vector<std::string>& arguments, const std::vector<std::string>& parts) {
        const Ended ended = runCli(arguments, m_folder.path());
        EXPECT_EQ(ended.status, 2) << ended.err;
        EXPECT_EQ(ended.complaints(), 1) << ended.err;
        for (const std::string& part : parts)
            EXPECT_THAT(ended.err, HasSubstr(part));
        EXPECT_EQ(m_folder.entries(), static_cast<int>(m_before.size()));
        for (const auto& [path, text] : m_before)
            EXPECT_EQ(readText(path), text) << path;
    }

    void batch(const Json& runs) {
        writeText(m_folder / "runs.json", Json{{"batch", 1}, {"runs", runs}}.dump());
        remember();
    }

    std::vector<std::string> synth(std::vector<std::string> more, const std::string& output = "new.png") {
        more.insert(more.begin(),
                    {"synth", "quilting", "tex.png", "--set", "patch=8", "--size", "24", "-o", output});
        return more;
    }

    TemporaryFolder m_folder;
    std::map<fs::path, std::string> m_before;
};

} // namespace

TEST_F(Overwrite, NothingThatACallReads) {
    fs::create_hard_link(m_folder / "tex.png", m_folder / "hard.png");
    fs::create_symlink("tex.png", m_folder / "soft.png");
    remember();
    for (const char* output : {"tex.png", "hard.png", "soft.png"})
        refused(synth({"--overwrite"}, output), {output, "tex.png", "overwritten"});
    refused(synth({"--report", "tex.png", "--overwrite"}), {"tex.png", "by the report"});
    refused(synth({"--map", "tex.png", "--overwrite"}), {"position map", "tex.png"});
    refused({"run", "bark.json", "-o", "bark.png", "--overwrite"}, {"bark.json", "the recipe of this run"});
    refused({"stress", "quilting", "tex.png", "--set", "patch=8", "-o", "s", "--report", "tex.png"},
            {"tex.png"});
    refused({"analyze", "lattice", "tex.png", "--picture", "tex.png"}, {"tex.png"});
    refused({"blend", "tex.png", "other.png", "--band", "8", "-o", "other.png"}, {"other.png"});
}

TEST_F(Overwrite, NothingThatIsNotTexlooms) {
    refused(synth({}, "photo.png"), {"photo.png", "Texloom did not write", "--overwrite"});
    refused(synth({}, "notes.png"), {"recipe", "notes.json"});
    refused(synth({"--report", "notes.json"}), {"report", "notes.json"});
    refused({"analyze", "lattice", "tex.png", "--picture", "photo.png"}, {"photo.png"});
    refused({"blend", "tex.png", "other.png", "--band", "8", "-o", "photo.png"}, {"photo.png"});
    EXPECT_EQ(runCli(synth({"--overwrite", "--quiet"}, "notes.png"), m_folder.path()).status, 0);
    EXPECT_TRUE(Json::parse(readText(m_folder / "notes.json")).contains("outputs"));
}

TEST_F(Overwrite, PagesOfPeople) {
    writeText(m_folder / "README.md", "# Mine");
    remember();
    refused({"methods", "--markdown", "."}, {"README.md", "--overwrite"});
    EXPECT_EQ(runCli({"methods", "--markdown", "pages"}, m_folder.path()).status, 0);
    EXPECT_EQ(runCli({"methods", "--markdown", "pages"}, m_folder.path()).status, 0);
}

TEST_F(Overwrite, AnEmptyFileIsNobodys) {
    writeText(m_folder / "new.png", "");
    EXPECT_EQ(runCli(synth({"--quiet"}), m_folder.path()).status, 0);
}

TEST_F(Overwrite, NothingTwice) {
    refused(synth({"--report", "new.json"}), {"new.json", "the same file"});
    refused(synth({"--map", "new.png"}), {"new.png", "the same file"});
}

TEST_F(Overwrite, ABatchKeepsWhatAnyOfItsRunsReads) {
    batch({{{"recipe", "bark.json"}, {"output", "runs.png"}}});
    refused({"batch", "runs.json", "--overwrite"}, {"runs.json", "the batch itself"});
    batch({{{"recipe", "bark.json"}, {"output", "bark.png"}}});
    refused({"batch", "runs.json", "--overwrite"}, {"bark.json", "a recipe of the batch"});
    batch({{{"recipe", "bark.json"}, {"output", "a.png"}}});
    for (const char* summary : {"runs.json", "bark.json", "tex.png", "a.png", "a.json"})
        refused({"batch", "runs.json", "--overwrite", "--summary", summary}, {summary});
    refused({"batch", "runs.json", "--summary", "notes.json"}, {"notes.json", "--overwrite"});
    batch({{{"recipe", "bark.json"}, {"output", "a.png"}, {"report", "tex.png"}}});
    refused({"batch", "runs.json", "--overwrite"}, {"tex.png"});
}

TEST_F(Overwrite, ItsOwnFilesAreReplacedAsEver) {
    const std::vector<std::string> call = synth({"--report", "report.json", "--map", "map.exr", "--quiet"});
    EXPECT_EQ(runCli(call, m_folder.path()).status, 0);
    EXPECT_EQ(runCli(call, m_folder.path()).status, 0);
    batch({{{"recipe", "bark.json"}, {"output", "a.png"}}});
    for (int i = 0; i < 2; ++i)
        EXPECT_EQ(runCli({"batch", "runs.json", "--summary", "sum.json", "--quiet"}, m_folder.path()).status,
                  0);
}

} // namespace texloom::test
