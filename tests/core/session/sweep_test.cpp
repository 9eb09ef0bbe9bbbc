#include "core/base/error.h"
#include "core/session/batch/sweep.h"
#include "tests/core/session/sample_run.h"

#include <gmock/gmock.h>

namespace texloom {
namespace {

using testing::ElementsAre;

std::vector<std::string> texts(const std::vector<Value>& values) {
    std::vector<std::string> all;
    for (const Value& value : values)
        all.push_back(toText(value));
    return all;
}

TEST(Sweep, ReadsListsAndSpacedValues) {
    const Method& quilting = findMethod("quilting");
    EXPECT_THAT(texts(sweepValues(quilting.param("patch"), "8, 16,32")), ElementsAre("8", "16", "32"));
    EXPECT_THAT(texts(sweepValues(quilting.param("patch"), "8:20:4, 16, 64")),
                ElementsAre("8", "12", "16", "20", "64"));
    EXPECT_THAT(texts(sweepValues(quilting.param("overlap"), "0.1:0.3:3")), ElementsAre("0.1", "0.2", "0.3"));
    EXPECT_THAT(texts(sweepSeeds("7, 1:3:3")), ElementsAre("7", "1", "2", "3"));
    EXPECT_TRUE(sweepValues(quilting.param("patch"), " ").empty());
    for (const char* wrong : {"x", "8:", "8:16", "8:16:1", "8:16:2.5", "8:16:1000", "100000"})
        EXPECT_THROW(sweepValues(quilting.param("patch"), wrong), UsageError) << wrong;
    EXPECT_THROW(sweepSeeds("-1"), UsageError);
}

TEST(Sweep, MakesEveryCombinationWithTheFirstAxisAcross) {
    const test::SampleRun sample;
    const SweepAxis patch{0, "patch", {8, 12, 16}};
    const SweepAxis overlap{0, "overlap", {0.2, 0.3}};
    const auto held = sweepCells(sample.input, {patch, overlap}, false);
    ASSERT_EQ(held.size(), 6U);
    EXPECT_EQ(toText(held[1].input.steps.front().parameters.at("patch")), "12");
    EXPECT_EQ(toText(held[3].input.steps.front().parameters.at("patch")), "8");
    EXPECT_EQ(toText(held[3].input.steps.front().parameters.at("overlap")), "0.3");
    EXPECT_EQ(held[5].input.seed, sample.input.seed);
    EXPECT_EQ(held[1].parts[0].title + held[1].parts[0].value + held[1].parts[0].unit, "Patch size12px");
    const auto varied = sweepCells(sample.input, {patch}, true);
    EXPECT_EQ(varied[2].input.seed, sample.input.seed + 2);
    for (const SweepCell& cell : held)
        EXPECT_NO_THROW(planRun(cell.input)) << cell.parts[0].value;
}

TEST(Sweep, VariesLaterMethodsAndTheSeed) {
    test::SampleRun sample;
    sample.input.steps.push_back({"quilting", {}});
    const auto cells = sweepCells(sample.input, {{1, "patch", {9, 10}}, {0, "", {5, 6}}}, false);
    ASSERT_EQ(cells.size(), 4U);
    EXPECT_EQ(toText(cells[1].input.steps[1].parameters.at("patch")), "10");
    EXPECT_EQ(cells[2].input.seed, 6U);
    EXPECT_EQ(cells[2].parts[0].value, "9");
    EXPECT_EQ(cells[2].parts[1].title + cells[2].parts[1].value, "Seed6");
    const std::vector<Value> many(11, Value(8));
    EXPECT_THROW(sweepCells(sample.input, {{0, "patch", many}, {0, "patch", many}}, false), UsageError);
}

} // namespace
} // namespace texloom
