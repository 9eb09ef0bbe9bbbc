#include "core/io/image_file.h"
#include "core/session/export/export_preset.h"
#include "tests/core/refusal.h"
#include "tests/support/temporary_folder.h"

namespace texloom::test {

namespace {

/// A preset of somebody's own, with both kinds of files.
ExportPreset enginePreset() {
    ExportPreset preset;
    preset.id = "engine";
    preset.title = "Our engine";
    preset.pattern = "tex_$name_$map";
    preset.color = "col";
    preset.normals = MapRole::NormalDx;
    preset.files = {
        {"nrm", MapRole::NormalDx, {}, Depth::Bits16},
        {"mix",
         MapRole::Other,
         {{MapRole::Roughness, 1, true}, {MapRole::Other, 0.25F, false}, {MapRole::Metallic, 0, false}},
         Depth::Bits8},
        {"h", MapRole::Height}};
    return preset;
}

std::string presetWith(const std::string& from, const std::string& to) {
    std::string text = enginePreset().toJson();
    text.replace(text.find(from), from.size(), to);
    return text;
}

} // namespace

TEST(ExportPresetFiles, SayAllThereIsToAPreset) {
    EXPECT_EQ(ExportPreset::fromJson("engine", enginePreset().toJson()), enginePreset());
    for (const ExportPreset& shipped : exportPresets())
        EXPECT_EQ(ExportPreset::fromJson(shipped.id, shipped.toJson()), shipped) << shipped.id;
}

TEST(ExportPresetFiles, AreRefusedWithTheFieldThatIsWrong) {
    const std::pair<std::string, std::string> wrong[] = {{"\"export-preset\": 1", "\"export-preset\": 2"},
                                                         {"\"normals\": \"down\"", "\"normals\": \"left\""},
                                                         {"\"depth\": 16", "\"depth\": 12"},
                                                         {"\"inverted\": true", "\"inverted\": 1"},
                                                         {"\"map\": \"height\"", "\"map\": \"hight\""},
                                                         {"\"title\"", "\"name\""}};
    for (const auto& [from, to] : wrong)
        EXPECT_THROW(ExportPreset::fromJson("engine", presetWith(from, to)), UsageError) << to;
    EXPECT_THROW(ExportPreset::fromJson("engine", "{"), UsageError);
}

TEST(ExportPresets, MustGiveFilesNamesOfTheirOwn) {
    const auto refused = [](const std::function<void(ExportPreset&)>& change) {
        ExportPreset preset = enginePreset();
        change(preset);
        try {
            checkExportPreset(preset);
        } catch (const UsageError&) {
            return true;
        }
        return false;
    };
    EXPECT_FALSE(refused([](ExportPreset&) {}));
    EXPECT_TRUE(refused([](ExportPreset& preset) { preset.title = "  "; }));
    EXPECT_TRUE(refused([](ExportPreset& preset) { preset.pattern = "$name"; }));
    EXPECT_TRUE(refused([](ExportPreset& preset) { preset.pattern = "$nam_$map"; }));
    EXPECT_TRUE(refused([](ExportPreset& preset) { preset.pattern = "../$name_$map"; }));
    EXPECT_TRUE(refused([](ExportPreset& preset) { preset.files[2].word = "nrm"; }));
    EXPECT_TRUE(refused([](ExportPreset& preset) { preset.files[2].word = "col"; }));
    EXPECT_TRUE(refused([](ExportPreset& preset) { preset.files[2].word = ""; }));
    EXPECT_TRUE(refused([](ExportPreset& preset) { preset.files[2].word = "a/b"; }));
}

TEST(ExportPresets, OfAFolderAreReadByTitleAndTheRestIsNamed) {
    const TemporaryFolder folder;
    ExportPreset first = enginePreset();
    first.title = "A first one";
    writeText(folder / "engine.json", enginePreset().toJson());
    writeText(folder / "zebra.json", first.toJson());
    writeText(folder / "broken.json", "{}");
    std::vector<Message> refused;
    const auto read = exportPresetsIn(folder.path(), [&](const Message& why) { refused.push_back(why); });
    ASSERT_EQ(read.size(), 2U);
    EXPECT_EQ(read[0].id, "zebra");
    EXPECT_EQ(read[1], enginePreset());
    ASSERT_EQ(refused.size(), 1U);
    EXPECT_NE(refused[0].text().find("broken.json"), std::string::npos);
    EXPECT_TRUE(exportPresetsIn(folder / "nowhere", [](const Message&) {}).empty());
    EXPECT_EQ(exportPresetFrom((folder / "engine.json").string()), enginePreset());
    EXPECT_EQ(exportPresetFrom("unity").id, "unity");
    EXPECT_THROW(exportPresetFrom("unify"), UsageError);
}

} // namespace texloom::test
