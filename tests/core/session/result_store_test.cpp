#include "core/base/error.h"
#include "core/io/image_file.h"
#include "core/session/results/result_store.h"
#include "tests/core/session/sample_run.h"
#include "tests/support/says.h"

#include <gmock/gmock.h>

#include <fstream>

namespace texloom {
namespace {

using test::SampleRun;
using test::says;
using testing::ElementsAre;

/// A run with everything that a result can have.
std::shared_ptr<const Result> fullResult(SampleRun& sample) {
    auto result = std::make_shared<Result>(sample.run());
    result->synthesis.curves = {{"Energy", {3, 2.5, 1.0 / 3}}};
    result->synthesis.notes = {TR("The patch was made smaller."), message("{} px.", 1.5)};
    Image picture({5, 4}, 2);
    picture(1, 2, 1) = -7.25F;
    result->synthesis.pictures = {{"Lattice", std::move(picture)}};
    return result;
}

std::vector<std::string> keysOf(const std::vector<ResultEntry>& entries) {
    std::vector<std::string> keys;
    for (const ResultEntry& entry : entries)
        keys.push_back(entry.key);
    return keys;
}

/// An entry that stands for a result of so many bytes.
ResultEntry entryOf(const std::string& key, std::uint64_t bytes) {
    ResultEntry entry;
    entry.key = key;
    entry.bytes = bytes;
    return entry;
}

std::shared_ptr<const Result> anyResult() {
    return std::make_shared<const Result>();
}

TEST(ResultFolder, GivesEverythingBackBitForBit) {
    SampleRun sample;
    sample.addCompanion("bark_normal", {48, 44});
    const auto result = fullResult(sample);
    ResultEntry entry = entryFor(*result, true);
    entry.title = "Bark “one”";
    entry.pinned = true;
    const ResultFolder folder(sample.folder / "results");
    folder.write(entry, *result);

    const ResultFolder::Scan found = ResultFolder(sample.folder / "results").scan();
    ASSERT_EQ(found.entries.size(), 1U);
    EXPECT_TRUE(found.problems.empty());
    const ResultEntry& again = found.entries.front();
    EXPECT_EQ(again.title, entry.title);
    EXPECT_TRUE(again.pinned && again.quick);
    EXPECT_EQ(again.recipe.toJson("/"), entry.recipe.toJson("/"));
    EXPECT_EQ(again.finished, entry.finished);
    EXPECT_EQ(again.seconds, entry.seconds);

    const StoredResult stored = folder.read(again);
    EXPECT_EQ(stored.problem, Message());
    EXPECT_TRUE(samePixels(stored.result->synthesis.image, result->synthesis.image));
    EXPECT_TRUE(stored.result->synthesis.map == result->synthesis.map);
    EXPECT_EQ(stored.result->synthesis.mapKind, MapKind::Exact);
    EXPECT_EQ(stored.result->synthesis.curves.front().values, result->synthesis.curves.front().values);
    EXPECT_EQ(stored.result->synthesis.notes, result->synthesis.notes);
    EXPECT_TRUE(samePixels(stored.result->synthesis.pictures.front().image,
                           result->synthesis.pictures.front().image));
    ASSERT_EQ(stored.result->figures.size(), result->figures.size());
    EXPECT_EQ(stored.result->figures.back().value, result->figures.back().value);
    EXPECT_TRUE(samePixels(stored.result->companion(0), result->companion(0)));
    EXPECT_EQ(stored.result->label(), result->label());
}

TEST(ResultFolder, KeepsAlphaAndValuesBeyondOneAsTheyAre) {
    SampleRun sample;
    Image hdr({40, 40}, 4);
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 40; ++x)
            for (int c = 0; c < 4; ++c)
                hdr(x, y, c) = c == 3 ? 0.25F : static_cast<float>(x * 3.7 - y * 0.1 + c);
    WriteOptions options;
    options.depth = Depth::Float;
    writeImage(sample.folder / "hdr.tif", hdr, options);
    sample.input.exemplars = {{loadExemplar(sample.folder / "hdr.tif", "raw"), {}, {}}};
    const auto result = std::make_shared<const Result>(sample.run());
    const ResultEntry entry = entryFor(*result, false);
    const ResultFolder folder(sample.folder / "results");
    folder.write(entry, *result);
    EXPECT_TRUE(samePixels(folder.read(entry).result->synthesis.image, result->synthesis.image));
}

TEST(ResultFolder, LeavesOutWhatIsDamagedWithASentence) {
    SampleRun sample;
    const auto result = std::make_shared<const Result>(sample.run());
    const ResultFolder folder(sample.folder / "results");
    std::vector<ResultEntry> entries;
    for (int i = 0; i < 3; ++i)
        folder.write(entries.emplace_back(entryFor(*result, false)), *result);
    EXPECT_LT(entries[0].key, entries[1].key);
    std::ofstream(folder.of(entries[1]) / "entry.json") << "{\"texloomResult\": 1, \"title\": [";
    std::filesystem::create_directories(folder.path() / "0000000000001-7"); // broken off before its entry
    const ResultFolder::Scan found = folder.scan();
    EXPECT_THAT(keysOf(found.entries), ElementsAre(entries[0].key, entries[2].key));
    ASSERT_EQ(found.problems.size(), 1U);
    EXPECT_THAT(found.problems.front(), says(entries[1].key));

    std::filesystem::resize_file(folder.of(entries[2]) / "image.tif", 900);
    EXPECT_THROW(folder.read(entries[2]), Error);
    folder.remove(entries[0]);
    EXPECT_EQ(folder.bytesOf(entries[0]), 0U);
}

TEST(ResultFolder, ShowsPixelsWhoseExemplarIsGoneAndSaysSo) {
    SampleRun sample;
    const auto result = std::make_shared<const Result>(sample.run());
    const ResultEntry entry = entryFor(*result, false);
    const ResultFolder folder(sample.folder / "results");
    folder.write(entry, *result);
    sample.write("bark", {48, 44}, 3, 5);
    EXPECT_THAT(folder.read(entry).problem, says("bark.png changed"));
    std::filesystem::remove(sample.folder / "bark.png");
    const StoredResult stored = folder.read(entry);
    EXPECT_THAT(stored.problem, says("bark.png"));
    EXPECT_TRUE(samePixels(stored.result->synthesis.image, result->synthesis.image));
    EXPECT_EQ(stored.result->fileName(), result->fileName());
}

TEST(ResultStore, DropsFromMemoryWhatWasUsedLongestAgo) {
    ResultStore store;
    for (const char* key : {"1", "2", "3"}) {
        store.add(entryOf(key, 40), anyResult());
        store.saved(key, 40);
    }
    EXPECT_TRUE(store.inMemory("1"));
    store.setMemoryBudget(100);
    EXPECT_FALSE(store.inMemory("2"));
    EXPECT_TRUE(store.inMemory("1") && store.inMemory("3"));
    store.loaded("2", anyResult());
    EXPECT_FALSE(store.inMemory("1"));
    EXPECT_TRUE(store.inMemory("2") && store.inMemory("3"));
    store.setMemoryBudget(0);
    EXPECT_EQ(store.memoryUsed(), 0U);
    EXPECT_EQ(store.entries().size(), 3U);
}

TEST(ResultStore, KeepsInMemoryWhatIsNotOnTheDiskYet) {
    ResultStore store;
    store.setMemoryBudget(50);
    for (const char* key : {"1", "2"})
        store.add(entryOf(key, 40), anyResult());
    EXPECT_EQ(store.memoryUsed(), 80U);
    store.saved("2", 40);
    EXPECT_TRUE(store.inMemory("1"));
    EXPECT_FALSE(store.inMemory("2"));
}

TEST(ResultStore, NeverTakesPinnedOnesNorTheNewestOffTheDisk) {
    ResultStore store;
    store.setDiskBudget(100);
    for (const char* key : {"1", "2", "3", "4"})
        store.add(entryOf(key, 40), anyResult());
    store.setPinned("1", true);
    EXPECT_THAT(store.beyondDisk(), ElementsAre("2", "3"));
    for (const char* key : {"2", "3"})
        store.take(key);
    EXPECT_TRUE(store.beyondDisk().empty());
    store.setDiskBudget(1);
    EXPECT_TRUE(store.beyondDisk().empty());
}

TEST(ResultStore, PutsBackInOrder) {
    ResultStore store;
    for (const char* key : {"3", "5"})
        store.add(entryOf(key, 1), anyResult());
    store.addEarlier({entryOf("1", 1), entryOf("3", 1)});
    EXPECT_THAT(keysOf(store.entries()), ElementsAre("1", "3", "5"));
    const auto taken = store.take("3");
    ASSERT_TRUE(taken);
    EXPECT_THAT(keysOf(store.entries()), ElementsAre("1", "5"));
    EXPECT_FALSE(store.take("3"));
    store.putBack(*taken);
    EXPECT_THAT(keysOf(store.entries()), ElementsAre("1", "3", "5"));
}

TEST(ExpectedSeconds, FollowsRunsOfTheSameMethodsOnAsManyThreads) {
    const SampleRun sample;
    const RunPlan plan = planRun(sample.input);
    EXPECT_FALSE(expectedSeconds(plan, {}));
    ResultEntry earlier;
    earlier.recipe = plan.recipe;
    earlier.threads = plan.threads;
    earlier.estimateSeconds = plan.estimate.seconds * 2;
    earlier.seconds = 8;
    EXPECT_NEAR(expectedSeconds(plan, {earlier}).value_or(0), 4, 1e-9);
    ResultEntry other = earlier;
    other.threads = plan.threads + 1;
    EXPECT_FALSE(expectedSeconds(plan, {other}));
    other = earlier;
    other.recipe.steps.push_back({"quilting", {}});
    EXPECT_FALSE(expectedSeconds(plan, {other}));
}

TEST(RecipeDifferences, NameWhatDiffersAndNothingElse) {
    SampleRun sample;
    const Recipe first = planRun(sample.input).recipe;
    EXPECT_TRUE(differences(first, first).empty());
    sample.input.steps.front().parameters["patch"] = 20;
    sample.input.seed = 4;
    sample.input.wrap = {true, false};
    const auto rows = differences(first, planRun(sample.input).recipe);
    ASSERT_EQ(rows.size(), 3U);
    EXPECT_EQ(rows[0].what, "Wraps");
    EXPECT_EQ(rows[1].what, "Seed");
    EXPECT_EQ(rows[1].second.text(), "4");
    EXPECT_EQ(rows[2].what, "Patch size");
    EXPECT_EQ(rows[2].first.text(), "12 px");
    EXPECT_EQ(rows[2].second.text(), "20 px");

    Recipe other = first;
    other.exemplars.front().image.hash = "0123456789abcdef";
    const auto files = differences(first, other);
    ASSERT_EQ(files.size(), 1U);
    EXPECT_EQ(files.front().second.text(), "bark.png (0123456)");
    other = first;
    other.steps.front().method = "random-phase";
    other.steps.front().parameters.clear();
    other.steps.push_back({"quilting", {}});
    const auto methods = differences(first, other);
    EXPECT_EQ(methods.front().what, "Method");
    EXPECT_EQ(methods.back().what, "Then");
}

} // namespace
} // namespace texloom
