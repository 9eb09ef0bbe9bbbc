#include "core/base/error.h"
#include "core/job/memory.h"
#include "core/session/batch/batch.h"
#include "core/session/batch/join_input.h"
#include "core/session/export/name_template.h"
#include "tests/core/refusal.h"
#include "tests/support/says.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <set>

namespace texloom::test {

namespace {

const std::string kRecipe =
    R"({"texloom": 1, "method": "quilting", "parameters": {"patch": 12}, "exemplars": [{"file": "bark.png"}],
        "size": [64, 60], "seed": 5})";

Batch batchOf(const std::string& runs) {
    return Batch::fromJson(R"({"batch": 1, "runs": [)" + runs + "]}", "/data");
}

Batch sweep(const std::string& axes, const std::string& more = "") {
    return batchOf(R"({"recipe": )" + kRecipe + R"(, "output": "$name_$index.png", "sweep": )" + axes + more +
                   "}");
}

} // namespace

TEST(NameTemplate, ExpandsWordsAndDropsEmptyOnes) {
    const NameWords words = {{"name", "bark"}, {"map", ""}, {"w", "512"}, {"quilting.patch", "32"}};
    EXPECT_EQ(expandName("$name_$map_$w", words), "bark_512");
    EXPECT_EQ(expandName("${name}s-${quilting.patch}$$", words), "barks-32$");
    EXPECT_EQ(expandName("$name_$map", words), "bark");
    EXPECT_THAT([&] { expandName("$nam", words); }, usageRefusal("$name"));
    EXPECT_THAT([&] { expandName("50$", words); }, usageRefusal("$$"));
    EXPECT_THAT([&] { expandName("${name", words); }, usageRefusal("$$"));
}

TEST(Batch, ReadsARecipeWithItsOutputs) {
    const Batch batch = batchOf(R"({"recipe": )" + kRecipe +
                                R"(, "output": "out/$name_$method_s$seed_$size.tif", "maps": ["$name.exr"],
                                    "report": "$index.json", "depth": "16", "sidecar": false})");
    ASSERT_EQ(batch.size(), 1U);
    const BatchItem item = batch.item(0);
    EXPECT_EQ(item.problem, Message());
    EXPECT_EQ(item.output, "/data/out/bark_quilting_s5_64x60.tif");
    EXPECT_EQ(item.maps.front(), "/data/bark.exr");
    EXPECT_EQ(item.report, "/data/1.json");
    EXPECT_EQ(item.depth, "16");
    EXPECT_FALSE(item.sidecar);
    EXPECT_EQ(item.whole().exemplars.front().image.path, "/data/bark.png");
}

TEST(Batch, MaySayWhatItShowsAndWriteElsewhere) {
    const std::string runs =
        R"("runs": [{"title": "Small ones", "recipe": )" + kRecipe + R"(, "output": "out/$name.png"}]})";
    const Batch plain = Batch::fromJson(R"({"batch": 1, )" + runs, "/data");
    EXPECT_EQ(plain.title + plain.summary, "");
    const Batch told = Batch::fromJson(R"({"batch": 1, "title": "Patches", "summary": "Two sizes.", )" + runs,
                                       "/data", "/made");
    EXPECT_EQ(told.title, "Patches");
    EXPECT_EQ(told.summary, "Two sizes.");
    EXPECT_EQ(told.item(0).title, "Small ones");
    EXPECT_EQ(told.item(0).output, "/made/out/bark.png");
    EXPECT_EQ(told.item(0).whole().exemplars.front().image.path, "/data/bark.png");
}

TEST(Batch, JoinsTwoImagesByATool) {
    const std::string two = R"("exemplars": [{"file": "bark.png", "edits": [{"crop": [0, 0, 9, 9]}]},
                                             {"file": "in/moss.png"}])";
    const Batch batch = batchOf(R"({"join": {"tool": "poisson-mix", "parameters": {"border": "wrap"}, )" +
                                two + R"(}, "sweep": {"preference": [1, 2.5]},
                                    "output": "$name_$second_$method_$preference.png"})");
    ASSERT_EQ(batch.size(), 2U);
    const BatchItem item = batch.item(1);
    EXPECT_EQ(item.problem, Message());
    EXPECT_EQ(item.join, &findTool("poisson-mix"));
    EXPECT_EQ(item.output, "/data/bark_moss_poisson-mix_2.5.png");
    EXPECT_EQ(std::get<double>(item.recipe.steps.front().parameters.at("preference")), 2.5);
    EXPECT_EQ(std::get<std::string>(item.recipe.steps.front().parameters.at("border")), "wrap");
    EXPECT_EQ(item.whole().exemplars.back().image.path, "/data/in/moss.png");
    EXPECT_EQ(item.whole().exemplars.front().edits.size(), 1U);
    EXPECT_EQ(batch.sources().size(), 2U);
    EXPECT_FALSE(item.sidecar);
    EXPECT_EQ(sweep(R"({"patch": [8]})").item(0).join, nullptr);

    const auto refused = [&](const std::string& join, const std::string& more = "") {
        return [join, more] { batchOf(R"({"join": {)" + join + R"(}, "output": "a.png")" + more + "}"); };
    };
    EXPECT_THAT(refused(R"("tool": "poison-mix", )" + two), usageRefusal("poison-mix"));
    EXPECT_THAT(refused(R"("tool": "crop", )" + two), usageRefusal("crop", "two"));
    EXPECT_THAT(refused(R"("tool": "blend", "exemplars": [{"file": "bark.png"}])"),
                usageRefusal("exemplars"));
    EXPECT_THAT(refused(R"("tool": "blend", )" + two, R"(, "seeds": "varied")"), usageRefusal("seeds"));
    // What is wrong with one run's values is that run's problem.
    const Batch wrong = batchOf(R"({"join": {"tool": "poisson-mix", )" + two +
                                R"(}, "output": "$index.png", "sweep": {"preference": [1, 99]}})");
    EXPECT_EQ(wrong.item(0).problem, Message());
    EXPECT_THAT(wrong.item(1).problem.text(), testing::HasSubstr("99"));
}

TEST(Batch, SweepsThroughEveryCombination) {
    const Batch batch = sweep(R"({"patch": [8, 16], "stitch": ["cut", "smooth-cut"], "size": [[32, 32]]})");
    ASSERT_EQ(batch.size(), 4U);
    std::set<std::string> cells;
    for (std::size_t i = 0; i < batch.size(); ++i) {
        const BatchItem item = batch.item(i);
        EXPECT_EQ(item.problem, Message());
        EXPECT_EQ(item.recipe.seed, 5U);
        EXPECT_EQ(item.recipe.size, (Size{32, 32}));
        cells.insert(item.cell);
    }
    EXPECT_EQ(cells.size(), 4U);
    EXPECT_EQ(batch.item(1).cell, "patch=8, stitch=smooth-cut, size=32x32");
    EXPECT_EQ(std::get<int>(batch.item(2).recipe.steps.front().parameters.at("patch")), 16);
}

TEST(Batch, SweepsOverPartsOfAnOutput) {
    const Batch batch = sweep(R"({"region": [[0, 0, 32, 20], [32, 0, 32, 20]], "size": [[64, 20]]})");
    ASSERT_EQ(batch.size(), 2U);
    EXPECT_EQ(batch.item(1).recipe.region, (Region{32, 0, {32, 20}}));
    EXPECT_EQ(batch.item(1).recipe.size, (Size{64, 20}));
    EXPECT_EQ(batch.item(1).cell, "region=32x0x32x20, size=64x20");
    EXPECT_THROW(sweep(R"({"region": [[0, 0, 32]]})"), UsageError);
    EXPECT_NE(sweep(R"({"region": [[0, 0, 32, 0.5]]})").item(0).problem.text(), "");
}

TEST(Batch, VariesTheSeedsOfASweepWhenAsked) {
    const Batch batch = sweep(R"({"patch": [8, 16, 24]})", R"(, "seeds": "varied")");
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_EQ(batch.item(i).recipe.seed, 5 + i);
}

TEST(Batch, MakesItemsWhenTheyAreAskedFor) {
    std::string exemplars = R"({"file": "0.png"})", seeds = "0";
    for (int i = 1; i < 4096; ++i)
        exemplars += R"(, {"file": ")" + std::to_string(i) + R"(.png"})";
    for (int i = 1; i < 20000; ++i)
        seeds += "," + std::to_string(i);
    const std::uint64_t before = residentMemory();
    const Batch batch =
        batchOf(R"({"recipe": {"texloom": 1, "method": "quilting", "exemplars": [)" + exemplars +
                R"(], "size": [64, 60]}, "output": "$index.png", "sweep": {"seed": [)" + seeds + "]}}");
    ASSERT_EQ(batch.size(), 20000U);
    const std::uint64_t after = residentMemory();
    constexpr std::uint64_t kLittle = 64U
                                      << 20; // the exemplars alone would be 2 GiB if each item had its own
    EXPECT_LT(after - std::min(before, after), kLittle);
    EXPECT_EQ(batch.item(19999).recipe.seed, 19999U);
    EXPECT_EQ(batch.item(7).output, "/data/8.png");
    EXPECT_EQ(batch.item(0).exemplars, batch.item(19999).exemplars) << "one recipe, shared";
    EXPECT_EQ(batch.item(3).whole().exemplars.size(), 4096U);
    EXPECT_EQ(batch.sources().size(), 4096U);
}

TEST(Batch, ABrokenRunIsItsOwnProblem) {
    const Batch batch = batchOf(R"({"recipe": "missing.json", "output": "a.png", "sweep": {"patch": [1, 2]}},
                                   {"recipe": )" +
                                kRecipe + R"(, "output": "b.png"})");
    ASSERT_EQ(batch.size(), 3U);
    EXPECT_THAT(batch.item(1).problem, says("missing.json"));
    EXPECT_EQ(batch.item(2).problem, Message());
    EXPECT_THAT(sweep(R"({"patch": [8, 9999]})").item(1).problem, says("9999"));
    EXPECT_THAT(sweep(R"({"pitch": [8]})").item(0).problem, says("patch"));
}

TEST(Batch, RefusesWhatCannotBeMeant) {
    EXPECT_THAT([] { Batch::fromJson("[]", "/"); }, usageRefusal("object"));
    EXPECT_THAT([] { Batch::fromJson(R"({"batch": 2, "runs": []})", "/"); }, usageRefusal("newer"));
    EXPECT_THAT([] { batchOf(R"({"recipe": "a.json", "output": "a.png", "sweeps": {}})"); },
                usageRefusal("sweeps"));
    EXPECT_THAT([] { sweep(R"({"patch": []})"); }, usageRefusal("patch"));
    EXPECT_THAT([] { sweep(R"({"patch": [8]})", R"(, "seeds": "random")"); }, usageRefusal("varied"));
    EXPECT_THAT(
        [] { batchOf(R"({"recipe": )" + kRecipe + R"(, "output": "a.png", "sweep": {"patch": [8, 9]}})"); },
        usageRefusal("both write /data/a.png"));
    std::string many = "[0";
    for (int i = 1; i < 400; ++i)
        many += "," + std::to_string(i);
    EXPECT_THAT([&] { sweep(R"({"patch": )" + many + R"(], "seed": )" + many + "]}"); },
                usageRefusal("100,000"));
}

TEST(Shard, PartitionsEveryBatchExactly) {
    for (const std::size_t items : {1U, 7U, 24U})
        for (const std::size_t count : {1U, 2U, 5U, 30U}) {
            std::vector<int> taken(items, 0);
            for (std::size_t i = 1; i <= count; ++i) {
                const Shard shard = Shard::parse(std::to_string(i) + "/" + std::to_string(count));
                for (std::size_t item = 0; item < items; ++item)
                    taken[item] += shard.holds(item) ? 1 : 0;
            }
            EXPECT_EQ(taken, std::vector<int>(items, 1));
        }
    for (const char* text : {"", "3", "0/4", "5/4", "1/0", "-1/4", "1/4x", "a/b"})
        EXPECT_THROW(Shard::parse(text), UsageError) << text;
}

} // namespace texloom::test
