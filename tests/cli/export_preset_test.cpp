// How a material's files are named and packed, chosen on the command line.

#include "core/io/image_file.h"
#include "core/session/export/export_preset.h"
#include "tests/cli/program.h"
#include "tests/support/textures.h"

#include <gmock/gmock.h>

namespace texloom::test {

namespace {

using ::testing::HasSubstr;

class ExportPresetOption : public ::testing::Test {
protected:
    ExportPresetOption() {
        for (const char* name : {"bark.png", "bark_roughness.png", "bark_metallic.png"})
            writeImage(m_folder / name, blobs({32, 24}, 1), {});
    }

    Ended synth(const std::string& preset, const std::string& output) const {
        return runCli({"synth", "quilting", "bark.png", "--companion", "bark_roughness.png", "--companion",
                       "bark_metallic.png", "--set", "patch=8", "--export-preset", preset, "-o", output,
                       "--quiet"},
                      m_folder.path());
    }
    bool there(const char* name) const { return std::filesystem::exists(m_folder / name); }

    TemporaryFolder m_folder;
};

} // namespace

TEST_F(ExportPresetOption, NamesAndPacksTheMaps) {
    const Ended end = synth("unreal", "T_bark_BC.png");
    ASSERT_EQ(end.status, 0) << end.err;
    EXPECT_TRUE(there("T_bark_BC.png") && there("T_bark_ORM.png"));
    EXPECT_EQ(readImage(m_folder / "T_bark_ORM.png").image.channels(), 3);
}

TEST_F(ExportPresetOption, MayBeAFileOfOnesOwn) {
    ExportPreset preset = findExportPreset("unreal");
    preset.pattern = "tex_$name_$map";
    preset.files.back().word = "height";
    preset.files[1].word = "mix";
    writeText(m_folder / "mine.json", preset.toJson());
    const Ended end = synth("mine.json", "made.png");
    ASSERT_EQ(end.status, 0) << end.err;
    EXPECT_TRUE(there("made.png") && there("tex_bark_mix.png"));
    EXPECT_FALSE(there("T_bark_ORM.png"));
}

TEST_F(ExportPresetOption, IsRefusedBeforeTheRunInASentence) {
    for (const char* wrong : {"unreel", "nowhere.json"}) {
        const Ended end = synth(wrong, "made.png");
        EXPECT_NE(end.status, 0);
        EXPECT_EQ(end.complaints(), 1);
        EXPECT_FALSE(there("made.png"));
    }
    EXPECT_THAT(synth("unreel", "made.png").err, HasSubstr("unreal"));
}

} // namespace texloom::test
