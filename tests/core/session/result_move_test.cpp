#include "core/io/image_file.h"
#include "core/session/results/result_files.h"
#include "tests/core/session/sample_run.h"

#include <gtest/gtest.h>

namespace texloom {
namespace {

namespace fs = std::filesystem;
using test::SampleRun;

std::string recipeOf(const ResultFolder::Scan& found) {
    return found.entries.size() == 1 ? found.entries.front().recipe.toJson("/") : "";
}

TEST(ResultFolder, TakesOverWhatWasKeptElsewhere) {
    SampleRun sample;
    const Result result = sample.run();
    const ResultFolder earlier(sample.folder / "cache" / "results");
    const ResultFolder later(sample.folder / "some" / "where" / "else" / "results");
    const ResultEntry entry = entryFor(result, false);
    earlier.write(entry, result);
    const std::string recipe = recipeOf(earlier.scan());
    ASSERT_FALSE(recipe.empty());

    later.takeOver(earlier.path());
    EXPECT_TRUE(earlier.scan().entries.empty());
    const ResultFolder::Scan found = later.scan();
    EXPECT_EQ(recipeOf(found), recipe); // which names the same files from another place
    EXPECT_TRUE(
        samePixels(later.read(found.entries.front()).result->synthesis.image, result.synthesis.image));

    later.takeOver(earlier.path());
    EXPECT_EQ(recipeOf(later.scan()), recipe);
}

TEST(ResultFolder, TakesOverOnlyWhatItHasNot) {
    SampleRun sample;
    const Result result = sample.run();
    const ResultFolder earlier(sample.folder / "cache"), later(sample.folder / "data");
    const ResultEntry entry = entryFor(result, false);
    earlier.write(entry, result);
    ResultEntry renamed = entry;
    renamed.title = "mine";
    later.write(renamed, result);
    later.takeOver(earlier.path());
    EXPECT_EQ(later.scan().entries.front().title, "mine");
    EXPECT_EQ(earlier.scan().entries.size(), 1U);
}

TEST(ResultFolder, EndsAMoveThatWasBrokenOff) {
    SampleRun sample;
    const Result result = sample.run();
    const ResultFolder earlier(sample.folder / "cache"), later(sample.folder / "data" / "results");
    const ResultEntry entry = entryFor(result, false);
    earlier.write(entry, result);
    const std::string recipe = recipeOf(earlier.scan());
    later.takeOver(earlier.path());
    // As if the program had been killed between the move and the entry's own rename.
    const fs::path place = later.of(entry);
    fs::rename(place / "entry.json", place / "entry.moved.json");
    fs::create_directories(later.path() / "other.part");
    EXPECT_EQ(recipeOf(later.scan()), recipe);
    EXPECT_TRUE(fs::exists(place / "entry.json"));
}

} // namespace
} // namespace texloom
