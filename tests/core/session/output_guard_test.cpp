#include "core/io/image_file.h"
#include "core/io/own_file.h"
#include "core/session/export/output_guard.h"
#include "tests/core/refusal.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/textures.h"

#include <OpenImageIO/imagebuf.h>
#include <gmock/gmock.h>

#include <fstream>

namespace texloom::test {

namespace {

namespace fs = std::filesystem;

fs::path made(const TemporaryFolder& folder, const std::string& name, const std::string& text = "mine") {
    writeText(folder / name, text);
    return folder / name;
}

void check(const fs::path& read, const fs::path& written, bool overwrite = true) {
    OutputGuard guard;
    guard.reads(read, "the exemplar");
    guard.writes(written, "result");
    guard.check(overwrite);
}

} // namespace

TEST(OutputGuard, KnowsAFileByAnyName) {
    const TemporaryFolder folder;
    const fs::path file = made(folder, "bark.png");
    fs::create_directory(folder / "inner");
    fs::create_symlink(file, folder / "soft.png");
    fs::create_symlink("soft.png", folder / "softer.png");
    fs::create_hard_link(file, folder / "hard.png");
    fs::create_directory_symlink(folder.path(), folder / "inner" / "up");
    for (const char* name : {"bark.png", "soft.png", "softer.png", "hard.png", "./bark.png",
                             "inner/../bark.png", "inner/up/bark.png", "inner/up/hard.png"})
        EXPECT_THAT([&] { check(file, folder / name); }, usageRefusal("bark.png", "overwritten")) << name;
    EXPECT_NO_THROW(check(file, folder / "other.png"));
}

TEST(OutputGuard, KnowsAFileThatIsNotThereYet) {
    const TemporaryFolder folder;
    fs::create_symlink("new.png", folder / "link.png");
    for (const char* name : {"new.png", "./new.png", "NEW.png", "link.png"}) {
        OutputGuard guard;
        guard.writes(folder / "new.png", "result");
        guard.writes(folder / name, "report");
        EXPECT_THAT([&] { guard.check(true); }, usageRefusal("report", "the same file")) << name;
    }
}

TEST(OutputGuard, AsksTheGuardAroundIt) {
    const TemporaryFolder folder;
    OutputGuard around;
    around.reads(made(folder, "runs.json"), "the batch itself");
    OutputGuard guard(&around);
    guard.writes(folder / "runs.json", "recipe");
    EXPECT_THAT([&] { guard.check(true); }, usageRefusal("runs.json", "the batch itself"));
}

TEST(OutputGuard, ReplacesFilesOfOthersOnlyWhenAllowed) {
    const TemporaryFolder folder;
    made(folder, "theirs.json", R"({"texloom": 1, "method": "quilting"})");
    EXPECT_THAT([&] { check(folder / "a.png", folder / "theirs.json", false); },
                usageRefusal("theirs.json", "--overwrite"));
    EXPECT_NO_THROW(check(folder / "a.png", folder / "theirs.json", true));
    EXPECT_NO_THROW(check(folder / "a.png", folder / "new.json", false));
}

TEST(OwnFile, IsToldByItsMarks) {
    const TemporaryFolder folder;
    for (const char* name : {"a.png", "a.jpg", "a.tif", "a.exr", "a.hdr"}) {
        WriteOptions options;
        options.depth = depthsFor(name).front();
        writeImage(folder / name, blobs({16, 16}, 3), options);
        EXPECT_TRUE(isOwnFile(folder / name)) << name;
    }
    OIIO::ImageBuf retouched((folder / "a.png").string());
    ASSERT_TRUE(retouched.read());
    retouched.specmod().attribute("Software", "another program");
    ASSERT_TRUE(retouched.write((folder / "retouched.png").string()));
    EXPECT_FALSE(isOwnFile(folder / "retouched.png"));
    EXPECT_TRUE(isOwnFile(made(folder, "side.json", R"({"texloom": 1, "outputs": []})")));
    EXPECT_TRUE(isOwnFile(made(folder, "report.json", R"({"texloomReport": 1})")));
    for (const char* text : {"", "{", "{}", "[]", "mine", R"({"texloom": 1, "method": "quilting"})",
                             R"({"batch": 1, "runs": []})"})
        EXPECT_FALSE(isOwnFile(made(folder, "theirs.json", text))) << text;
    EXPECT_FALSE(isOwnFile(folder / "gone.png"));
    // The voxels beside a volume's head are, those beside a recipe are somebody else's.
    made(folder, "block.json", R"({"texloom-volume": 1})");
    EXPECT_TRUE(isOwnFile(made(folder, "block.raw", "voxels")));
    EXPECT_FALSE(isOwnFile(made(folder, "side.raw", "a photo")));
    EXPECT_FALSE(isOwnFile(folder.path()));
}

} // namespace texloom::test
