#include "core/base/error.h"
#include "core/io/map_file.h"
#include "core/session/export/export.h"
#include "tests/core/io/file_limit.h"
#include "tests/core/io/foreign_files.h"
#include "tests/core/refusal.h"
#include "tests/core/session/sample_run.h"
#include "tests/support/file_content.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <set>
#include <utility>

namespace texloom::test {

namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

std::set<fs::path> filesIn(const fs::path& folder) {
    return {fs::directory_iterator(folder), fs::directory_iterator()};
}

/// The sample with a normal map beside it, run, and an export of everything into a folder of its own.
struct SampleExport {
    SampleExport() {
        sample.addCompanion("bark_normal", sample.input.exemplars[0].image.image->size());
        result = sample.run();
        options.image = out / "made.png";
        options.maps = {out / "made_map.exr", out / "made_map.png"};
    }
    SampleRun sample;
    TemporaryFolder out;
    Result result;
    ExportOptions options;
};

/// What a recipe makes when it is run again.
Image again(const Recipe& recipe) {
    SampleRun sample;
    sample.input = loadRecipe(recipe);
    return sample.run().synthesis.image;
}

} // namespace

TEST(ExportResult, NeverWritesOverWhatTheResultWasMadeFrom) {
    SampleExport sample;
    const fs::path bark = sample.sample.folder / "bark.png",
                   normal = sample.sample.folder / "bark_normal.png";
    const std::string before = contentOf(bark) + contentOf(normal);
    sample.options.image = sample.sample.folder / "." / "bark.png";
    EXPECT_THAT([&] { exportResult(sample.result, sample.options); },
                usageRefusal("bark.png", "overwritten"));
    EXPECT_THAT([&] { exportEntries(sample.result, sample.options); },
                usageRefusal("bark.png", "overwritten"));
    sample.options.image = sample.out / "made.png";
    sample.options.maps = {normal};
    EXPECT_THAT([&] { exportResult(sample.result, sample.options); },
                usageRefusal("bark_normal.png", "overwritten"));
    EXPECT_EQ(contentOf(bark) + contentOf(normal), before);
    EXPECT_TRUE(filesIn(sample.out.path()).empty());
}

TEST(ExportResult, WritesExactlyWhatItAnnounced) {
    const SampleExport sample;
    std::set<fs::path> announced, written;
    for (const ExportEntry& entry : exportEntries(sample.result, sample.options))
        announced.insert(entry.path);
    EXPECT_TRUE(filesIn(sample.out.path()).empty());
    for (const ExportEntry& entry : exportResult(sample.result, sample.options))
        written.insert(entry.path);
    EXPECT_EQ(filesIn(sample.out.path()), announced);
    EXPECT_EQ(written, announced);
    EXPECT_EQ(announced.size(), 5U);
}

TEST(ExportResult, WritesOnlyTheResultWhenOnlyThatIsWanted) {
    SampleExport sample;
    sample.options.maps.clear();
    sample.options.sidecar = sample.options.companions = false;
    exportResult(sample.result, sample.options);
    EXPECT_EQ(filesIn(sample.out.path()), std::set{sample.options.image});
}

TEST(ExportEntries, KnowWhatIsThereAlready) {
    const SampleExport sample;
    writeText(sample.out / "made.json", "{}");
    for (const ExportEntry& entry : exportEntries(sample.result, sample.options))
        EXPECT_EQ(entry.exists, entry.path.filename() == "made.json") << entry.path;
}

TEST(ExportEntries, NameNoFileTwice) {
    SampleExport sample;
    fs::create_directory(sample.sample.folder / "other");
    for (const char* name : {"normal", "other/normal"})
        sample.sample.addCompanion(name, {48, 44});
    const Result result = sample.sample.run();
    std::set<fs::path> paths;
    for (const ExportEntry& entry : exportEntries(result, sample.options))
        EXPECT_TRUE(paths.insert(entry.path).second) << entry.path << " is written twice";
}

TEST(ExportResult, SidecarRunsAgainToTheSameBits) {
    const SampleExport sample;
    exportResult(sample.result, sample.options);
    EXPECT_TRUE(samePixels(again(readRecipe(sample.out / "made.json")), sample.result.synthesis.image));
}

TEST(ExportResult, EveryFormatsEmbeddedRecipeRunsAgainToTheSameBits) {
    SampleExport sample;
    for (const char* name : {"made.png", "made.tif", "made.exr"}) {
        sample.options.image = sample.out / name;
        sample.options.depth = depthsFor(sample.options.image).front();
        exportResult(sample.result, sample.options);
        EXPECT_TRUE(samePixels(again(readRecipe(sample.options.image)), sample.result.synthesis.image))
            << name;
    }
}

TEST(ExportResult, MapsHoldTheRecipeToo) {
    const SampleExport sample;
    exportResult(sample.result, sample.options);
    for (const fs::path& map : sample.options.maps)
        EXPECT_EQ(readRecipe(map).seed, 3U) << map;
}

TEST(ExportResult, MapsMakeTheResultFromTheExemplar) {
    const SampleExport sample;
    exportResult(sample.result, sample.options);
    const Image& exemplar = *sample.result.plan.request.exemplars[0].image;
    for (const fs::path& map : sample.options.maps)
        EXPECT_TRUE(samePixels(readPositionMap(map).apply(exemplar), sample.result.synthesis.image)) << map;
}

TEST(ExportResult, EightBitPixelsAreThoseOfTheResult) {
    const SampleExport sample;
    exportResult(sample.result, sample.options);
    EXPECT_TRUE(samePixels(readImage(sample.options.image).image, sample.result.synthesis.image));
}

TEST(ExportResult, CompanionsAreTheMapApplied) {
    const SampleExport sample;
    exportResult(sample.result, sample.options);
    const Image& normal = *sample.sample.input.exemplars[0].companions[0].image;
    EXPECT_TRUE(samePixels(readImage(sample.out / "made_normal.png").image,
                           sample.result.synthesis.map.apply(normal)));
}

TEST(ExportResult, HalfFilesAreLinear) {
    SampleExport sample;
    sample.options.image = sample.out / "made.exr";
    sample.options.depth = Depth::Half;
    exportResult(sample.result, sample.options);
    EXPECT_EQ(readImageInfo(sample.options.image).space, "linear");
    const Image back = *loadExemplar(sample.options.image).image;
    for (int x = 0; x < back.width(); ++x)
        EXPECT_NEAR(back(x, 7, 1), sample.result.synthesis.image(x, 7, 1), 1e-3);
}

TEST(ExportResult, SidecarStatesTheMapsConvention) {
    const SampleExport sample;
    exportResult(sample.result, sample.options);
    const std::string text = readText(sample.out / "made.json");
    for (const fs::path& map : sample.options.maps)
        EXPECT_THAT(text, HasSubstr(mapConvention(map)));
}

TEST(ExportResult, LeavesNothingNewWhenOneFileFails) {
    SampleExport sample;
    sample.options.maps.push_back(sample.out / "missing" / "map.exr");
    EXPECT_THROW(exportResult(sample.result, sample.options), Error);
    EXPECT_TRUE(filesIn(sample.out.path()).empty());
}

TEST(ExportResult, LeavesNothingNewWhenTheDiskIsFull) {
    const SampleExport sample;
    exportResult(sample.result, sample.options);
    const auto smallest = [&] {
        std::uintmax_t bytes = ~std::uintmax_t{0};
        for (const fs::path& file : filesIn(sample.out.path()))
            bytes = std::min(bytes, fs::file_size(file));
        return bytes;
    }();
    for (const fs::path& file : filesIn(sample.out.path()))
        fs::remove(file);
    const FileLimit limit(smallest + 1);
    EXPECT_THROW(exportResult(sample.result, sample.options), Error);
    EXPECT_TRUE(filesIn(sample.out.path()).empty());
}

TEST(ExportResult, KeepsAnEarlierFileThatItCouldNotReplace) {
    const SampleExport sample;
    writeText(sample.out / "made.png", "an earlier result");
    const FileLimit limit(100);
    EXPECT_THROW(exportResult(sample.result, sample.options), Error);
    EXPECT_EQ(contentOf(sample.out / "made.png"), "an earlier result");
    EXPECT_EQ(filesIn(sample.out.path()), std::set{sample.out / "made.png"});
}

TEST(ExportResult, LeavesNothingWhenItIsStoppedAnywhere) {
    const SampleExport sample;
    int calls = 0;
    ExportOptions counted = sample.options;
    counted.check = [&] { ++calls; };
    exportResult(sample.result, counted);
    EXPECT_GT(calls, 3 * 60);
    for (const fs::path& file : filesIn(sample.out.path()))
        fs::remove(file);
    for (int stop = 1; stop <= calls; stop += 37) {
        int left = stop;
        counted.check = [&] {
            if (--left == 0)
                throw Cancelled{};
        };
        EXPECT_THROW(exportResult(sample.result, counted), Cancelled);
        EXPECT_TRUE(filesIn(sample.out.path()).empty()) << "stopped at " << stop;
    }
}

TEST(ExportResult, RefusesAnUnknownSpaceAndLeavesNothing) {
    SampleExport sample;
    sample.options.space = "rec2020";
    EXPECT_THAT([&] { exportResult(sample.result, sample.options); },
                ThrowsMessage<UsageError>(HasSubstr("rec2020")));
    EXPECT_TRUE(filesIn(sample.out.path()).empty());
}

TEST(ExportPresets, PackAndNameTheMapsOfAMaterial) {
    SampleRun sample;
    for (const char* name : {"bark_normal", "bark_rough", "bark_metal", "bark_height"})
        sample.addCompanion(name, {48, 44});
    const Result result = sample.run();
    const TemporaryFolder out;
    ExportOptions options;
    options.preset = findExportPreset("unreal");
    options.pattern = findExportPreset("unreal").pattern;
    options.image = out / "T_bark_BC.png";
    exportResult(result, options);
    const std::set<fs::path> expected = {out / "T_bark_BC.png", out / "T_bark_BC.json", out / "T_bark_N.png",
                                         out / "T_bark_ORM.png", out / "T_bark_H.png"};
    EXPECT_EQ(filesIn(out.path()), expected);
    const Image packed = readImage(out / "T_bark_ORM.png").image;
    const Image normal = readImage(out / "T_bark_N.png").image;
    for (int x = 0; x < packed.width(); ++x) {
        EXPECT_EQ(packed(x, 9, 0), 1); // no occlusion map
        EXPECT_EQ(packed(x, 9, 1), result.companion(1)(x, 9, 0));
        EXPECT_EQ(packed(x, 9, 2), result.companion(2)(x, 9, 0));
        EXPECT_NEAR(normal(x, 9, 1), 1 - result.companion(0)(x, 9, 1), 1e-6);
        EXPECT_EQ(normal(x, 9, 0), result.companion(0)(x, 9, 0));
    }
    EXPECT_FALSE(readImageInfo(out / "T_bark_ORM.png").recipe.empty());
}

TEST(ExportResult, NamesLayersOfOneFileByThemAndPacksEachForItself) {
    SampleRun sample;
    const fs::path source = sample.folder / "set.exr";
    Image layers({48, 44}, 6);
    for (int c = 0; c < 6; ++c)
        for (int y = 0; y < 44; ++y)
            std::fill_n(layers.plane(c).row(y), 48, 0.125F * static_cast<float>(c));
    writeForeign(
        source, layers,
        {.channelNames = {"dry ORM.R", "dry ORM.G", "dry ORM.B", "wet_ORM.R", "wet_ORM.G", "wet_ORM.B"}});
    for (const char* layer : {"dry ORM", "wet_ORM"})
        for (ExemplarFile& map : loadCompanions(source, layer))
            sample.input.exemplars[0].companions.push_back(std::move(map));
    ASSERT_EQ(sample.input.exemplars[0].companions.size(), 6U);
    const TemporaryFolder out;
    ExportOptions options;
    options.image = out / "made.png";
    options.sidecar = false;
    exportResult(sample.run(), options);
    const std::set<fs::path> expected = {out / "made.png", out / "made_dry_ORM.exr",
                                         out / "made_wet_ORM.exr"};
    EXPECT_EQ(filesIn(out.path()), expected);
    const Image dry = readImage(out / "made_dry_ORM.exr").image,
                wet = readImage(out / "made_wet_ORM.exr").image;
    for (int c = 0; c < 3; ++c) {
        EXPECT_EQ(dry(5, 5, c), 0.125F * static_cast<float>(c));
        EXPECT_EQ(wet(5, 5, c), 0.125F * static_cast<float>(c + 3));
    }
}

TEST(ExportPresets, UnityWantsSmoothnessAndMayHaveNoMap) {
    SampleRun sample;
    sample.addCompanion("bark_rough", {48, 44});
    sample.addCompanion("bark_stamp", {48, 44});
    const Result result = sample.run();
    const TemporaryFolder out;
    ExportOptions options;
    options.preset = findExportPreset("unity");
    options.image = out / "made.png";
    options.sidecar = false;
    exportResult(result, options);
    const std::set<fs::path> expected = {out / "made.png", out / "made_MaskMap.png", out / "made_stamp.png"};
    EXPECT_EQ(filesIn(out.path()), expected);
    const Image packed = readImage(out / "made_MaskMap.png").image;
    ASSERT_EQ(packed.channels(), 4);
    EXPECT_NEAR(packed(5, 5, 3), 1 - result.companion(0)(5, 5, 0), 1e-6);
}

TEST(ExportResult, WritesAMapOfAJpegWithoutLoss) {
    SampleRun sample;
    const fs::path source = sample.folder / "bark_bump.jpg";
    writeImage(source, blobs({48, 44}, 1), {});
    sample.input.exemplars[0].companions = {loadData(source)};
    const Result result = sample.run();
    ASSERT_FALSE(result.synthesis.notes.empty());
    EXPECT_THAT(result.synthesis.notes.front().text(), HasSubstr("bark_bump.jpg holds data"));
    const TemporaryFolder out;
    ExportOptions options;
    options.image = out / "made.png";
    options.sidecar = false;
    exportResult(result, options);
    const std::set<fs::path> expected = {out / "made.png", out / "made_bump.png"};
    EXPECT_EQ(filesIn(out.path()), expected);
    EXPECT_TRUE(samePixels(readImage(out / "made_bump.png").image, result.companion(0)));
}

TEST(ExportResult, ReplacesOnlyWhatItWasToldItMay) {
    SampleExport sample;
    sample.options.mayReplace.emplace();
    exportResult(sample.result, sample.options);
    EXPECT_THROW(exportResult(sample.result, sample.options), Error);
    for (const ExportEntry& entry : exportEntries(sample.result, sample.options))
        sample.options.mayReplace->insert(entry.path);
    EXPECT_NO_THROW(exportResult(sample.result, sample.options));
}

TEST(DepthLike, KeepsTheSourcesDepthWhereItCan) {
    ExemplarFile source;
    source.info.depth = "16-bit";
    EXPECT_EQ(depthLike(source.info, "a.png"), Depth::Bits16);
    EXPECT_EQ(depthLike(source.info, "a.jpg"), Depth::Bits8);
    source.info.depth = "float";
    EXPECT_EQ(depthLike(source.info, "a.exr"), Depth::Float);
    EXPECT_EQ(depthLike(source.info, "a.tif"), Depth::Float);
}

TEST(ReportJson, HoldsRecipeTimesMemoryFiguresAndCurves) {
    SampleExport sample;
    sample.result.synthesis.curves = {{"Energy", {2, 1}}};
    const auto report = nlohmann::json::parse(reportJson(sample.result, sample.out.path()));
    EXPECT_EQ(report.at("recipe").at("seed"), 3);
    EXPECT_EQ(report.at("threads"), 2);
    EXPECT_GT(report.at("seconds").get<double>(), 0);
    EXPECT_FALSE(report.at("stages").empty());
    EXPECT_GT(report.at("peakMemoryBytes").get<double>(), 1e6);
    EXPECT_TRUE(report.at("figures").contains("Innovation"));
    EXPECT_EQ(report.at("curves").at("Energy"), (std::vector<double>{2, 1}));
}

} // namespace texloom::test
