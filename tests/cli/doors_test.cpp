// Methods of kinds that no shipped method has, through the command line.

#include "core/io/image_file.h"
#include "core/io/model_file.h"
#include "core/session/run/checkpoint_file.h"
#include "tests/cli/program.h"
#include "tests/support/textures.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <csignal>
#include <fstream>
#include <numeric>
#include <set>
#include <thread>
#include <vector>

namespace texloom::test {

namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using Json = nlohmann::json;

class Doors : public ::testing::Test {
protected:
    Doors() {
        writeImage(m_folder / "bark.png", blobs({48, 44}, 3), {});
        writeImage(m_folder / "face.png", blobs({70, 50}, 3, 5), {});
    }

    Ended ended(const std::vector<std::string>& arguments) const {
        return runCli(arguments, m_folder.path(), TEXLOOM_CLI_DOORS);
    }
    std::string run(const std::vector<std::string>& arguments) const {
        const Ended end = ended(arguments);
        EXPECT_EQ(end.status, 0) << end.err;
        return end.out;
    }
    void expectRefusal(const std::vector<std::string>& arguments,
                       const std::vector<std::string>& words) const {
        const Ended end = ended(arguments);
        EXPECT_EQ(end.status, 2);
        EXPECT_EQ(end.complaints(), 1);
        for (const std::string& word : words)
            EXPECT_THAT(end.err, HasSubstr(word));
    }
    Image image(const std::string& name) const { return readImage(m_folder / name).image; }
    Json json(const std::string& name) const { return Json::parse(readText(m_folder / name)); }

    TemporaryFolder m_folder;
};

} // namespace

TEST_F(Doors, WhatIsLeftOutOfTheBuildIsRefusedWithTheReason) {
    EXPECT_THAT(run({"methods"}), HasSubstr("left-out: not part of this build"));
    expectRefusal({"synth", "left-out", "bark.png", "-o", "a.png"},
                  {"left-out is not part of this build", "install it"});

    run({"synth", "mirror-tile", "bark.png", "-o", "b.png", "--quiet"});
    std::string recipe = readText(m_folder / "b.json");
    recipe.replace(recipe.find("mirror-tile"), std::string("mirror-tile").size(), "left-out");
    std::ofstream(m_folder / "c.json") << recipe;
    expectRefusal({"run", "c.json", "-o", "d.png"}, {"left-out is not part of this build", "install it"});
}

TEST_F(Doors, MethodsSayWhatTheyTakeAndGive) {
    const Json stipple = Json::parse(run({"methods", "stipple", "--json"})).front();
    EXPECT_EQ(stipple.at("category"), "tools");
    EXPECT_EQ(stipple.at("takes").at(1).at("id"), "target");
    EXPECT_EQ(stipple.at("takes").at(1).at("extent"), "output");
    EXPECT_THAT(run({"methods", "stipple"}), HasSubstr("--input target=FILE"));
}

TEST_F(Doors, ATargetGoesInByNameGivesTheSizeAndIsInTheRecipe) {
    run({"synth", "stipple", "bark.png", "--input", "target=face.png", "-o", "out.exr", "--map", "map.exr"});
    EXPECT_EQ(image("out.exr").size(), (Size{70, 50}));
    EXPECT_EQ(json("out.json").at("inputs").at("target").at(0).at("file"), "face.png");
    EXPECT_FALSE(json("out.json").at("inputs").at("target").at(0).at("sha1").get<std::string>().empty());
    run({"run", "out.json", "-o", "again.exr"});
    EXPECT_TRUE(samePixels(image("out.exr"), image("again.exr")));
    run({"apply", "map.exr", "bark.png", "-o", "applied.png"});
    EXPECT_EQ(image("applied.png").size(), (Size{70, 50}));
}

TEST_F(Doors, PortsThatAreEmptyGivenTwiceUnknownOrOfAnotherSizeAreRefused) {
    const std::vector<std::string> base = {"synth", "stipple", "bark.png", "-o", "out.png"};
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.begin(), base.begin(), base.end());
        return more;
    };
    expectRefusal(base, {"Stipple", "target"});
    expectRefusal(with({"--input", "target=face.png", "--input", "target=face.png"}), {"Stipple", "1", "2"});
    expectRefusal(with({"--input", "tarket=face.png"}), {"Stipple", "tarket"});
    expectRefusal(with({"--input", "face.png"}), {"NAME=FILE"});
    expectRefusal(with({"--input", "target=face.png", "--size", "80"}), {"70 × 50", "80 × 80"});
    expectRefusal(with({"--init", "face.png"}), {"Stipple", "start from an image"});
    EXPECT_FALSE(fs::exists(m_folder / "out.png"));
}

TEST_F(Doors, WhatTakesNothingUpCannotFollow) {
    expectRefusal({"synth", "quilting", "bark.png", "--then", "slow-diffusion", "-o", "out.png"},
                  {"Slow diffusion", "Image quilting"});
}

TEST_F(Doors, AModelIsSavedTakenUpAndInTheRecipe) {
    EXPECT_THAT(run({"methods", "learn-moments"}), HasSubstr("--save moments=FILE"));
    const std::string told = run({"synth", "learn-moments", "bark.png", "-o", "learned.png", "--save",
                                  "moments=bark.safetensors", "--report", "report.json"});
    EXPECT_THAT(told, HasSubstr("bark.safetensors: Colour moments, 12 numbers, 96 B"));
    EXPECT_EQ(json("report.json").at("outputs").at(0).at("output"), "moments");
    EXPECT_EQ(json("learned.json").at("outputs").at(1).at("file"), "bark.safetensors");
    run({"synth", "draw-moments", "--input", "moments=bark.safetensors", "--size", "40x30", "-o",
         "drawn.exr"});
    EXPECT_EQ(json("drawn.json").at("exemplars"), Json::array());
    const Json input = json("drawn.json").at("inputs").at("moments").at(0);
    EXPECT_EQ(input.at("file"), "bark.safetensors");
    EXPECT_EQ(input.at("sha1"), fileHash(m_folder / "bark.safetensors"));
    run({"run", "drawn.json", "-o", "again.exr"});
    EXPECT_TRUE(samePixels(image("drawn.exr"), image("again.exr")));
    run({"synth", "learn-moments", "bark.png", "--then", "draw-moments", "-o", "both.exr", "--save",
         "moments=both.safetensors"});
    EXPECT_EQ(readModel(m_folder / "both.safetensors").arrays,
              readModel(m_folder / "bark.safetensors").arrays);
}

TEST_F(Doors, AMethodMayTakeNoExemplar) {
    EXPECT_THAT(run({"methods", "draw-moments"}), HasSubstr("Takes no exemplar."));
    EXPECT_THAT(run({"methods", "learn-moments"}), Not(HasSubstr("Takes no exemplar.")));
    run({"synth", "learn-moments", "bark.png", "-o", "learned.png", "--save", "moments=m.safetensors"});
    const auto draw = [](std::vector<std::string> more) {
        more.insert(more.begin(), {"synth", "draw-moments", "--input", "moments=m.safetensors"});
        return more;
    };
    run(draw({"-o", "drawn.png", "--report", "report.json"}));
    EXPECT_EQ(image("drawn.png").size(), (Size{512, 512}));
    EXPECT_EQ(image("drawn.png").channels(), 3);
    EXPECT_TRUE(json("report.json").at("figures").contains("Seam, left to right"));
    EXPECT_FALSE(json("report.json").at("figures").contains("Colour histograms apart"));
    expectRefusal(draw({"bark.png", "-o", "out.png"}), {"Draw colour moments", "takes no exemplar"});
    for (const std::vector<std::string>& belonging :
         std::vector<std::vector<std::string>>{{"--mask", "bark.png"},
                                               {"--companion", "bark.png"},
                                               {"--weight", "2"},
                                               {"--edit", "turn=3"},
                                               {"--space", "linear"},
                                               {"--layer", "diffuse"}}) {
        std::vector<std::string> all = draw({"-o", "out.png"});
        all.insert(all.end(), belonging.begin(), belonging.end());
        expectRefusal(all, {belonging.front(), "exemplar"});
    }
    expectRefusal({"stress", "draw-moments", "--input", "moments=m.safetensors", "-o", "round"},
                  {"stress", "draw-moments", "no exemplar"});
    expectRefusal({"synth", "learn-moments", "-o", "out.png"}, {"no exemplar to learn from"});
    EXPECT_FALSE(fs::exists(m_folder / "out.png"));
    writeText(m_folder / "batch.json",
              R"({"batch": 1, "runs": [{"recipe": "drawn.json", "sweep": {"seed": [4, 5]},
        "output": "$name-$seed.png"}]})");
    run({"batch", "batch.json", "--quiet"});
    EXPECT_TRUE(fs::exists(m_folder / "m-4.png"));
    EXPECT_FALSE(samePixels(image("m-4.png"), image("m-5.png")));
}

TEST_F(Doors, AVolumeIsSavedAndTakenUp) {
    const std::vector<std::string> noise = {"synth", "solid-noise", "bark.png", "--size", "20x16"};
    const auto with = [](std::vector<std::string> all, std::vector<std::string> more) {
        all.insert(all.end(), more.begin(), more.end());
        return all;
    };
    run(with(noise, {"-o", "noise.exr", "--save", "volume=block.json"}));
    EXPECT_EQ(json("block.json").at("size"), (Json{20, 16, 16}));
    EXPECT_EQ(json("block.json").at("recipe").at("method"), "solid-noise");
    run(with(noise, {"-o", "noise.exr", "--save", "volume=block.tif"}));
    EXPECT_TRUE(fs::exists(m_folder / "block-0015.tif"));
    const std::vector<std::string> bend = {"synth", "bend-by-volume", "bark.png", "--size", "20x16"};
    run(with(bend, {"--input", "volume=block.json", "-o", "bent.png"}));
    run(with(noise, {"--then", "bend-by-volume", "-o", "both.png"}));
    EXPECT_TRUE(samePixels(image("bent.png"), image("both.png")));
    run({"run", "bent.json", "-o", "again.png"});
    EXPECT_TRUE(samePixels(image("bent.png"), image("again.png")));
    expectRefusal({"synth", "bend-by-volume", "bark.png", "--size", "20x17", "--input", "volume=block.json",
                   "-o", "out.png"},
                  {"y 0 to 15", "y 0 to 16"});
}

TEST_F(Doors, SlicesOfOthersAreNotReplaced) {
    const std::vector<std::string> save = {"synth", "solid-noise", "bark.png", "--size",          "20x16",
                                           "-o",    "new.png",     "--save",   "volume=block.tif"};
    writeText(m_folder / "block-0000.tif", "mine");
    writeText(m_folder / "block-0001.tif", "mine");
    writeText(m_folder / "block.tif", "no slice");
    expectRefusal(save, {"block-0000.tif", "did not write"});
    fs::remove(m_folder / "block-0000.tif");
    expectRefusal(save, {"block-0001.tif", "did not write"});
    EXPECT_EQ(readText(m_folder / "block-0001.tif"), "mine");
    EXPECT_FALSE(fs::exists(m_folder / "new.png"));
    fs::remove(m_folder / "block-0001.tif");
    run(save);
    run(save); // its own may be replaced
    EXPECT_EQ(readText(m_folder / "block.tif"), "no slice");
}

TEST_F(Doors, WhatCannotBeSavedIsRefusedBeforeTheRun) {
    const auto learn = [](const std::string& save) {
        return std::vector<std::string>{"synth",   "learn-moments", "bark.png", "-o",
                                        "out.png", "--save",        save};
    };
    expectRefusal(learn("model=m.safetensors"), {"model", "moments"});
    expectRefusal(learn("moments=m.png"), {"m.png", ".safetensors"});
    expectRefusal(learn("moments"), {"NAME=FILE"});
    expectRefusal({"synth", "quilting", "bark.png", "-o", "out.png", "--save", "volume=v.json"},
                  {"Image quilting", "volume"});
    expectRefusal({"synth", "solid-noise", "bark.png", "-o", "out.png", "--save", "volume=out.json"},
                  {"out.json", "recipe"});
    EXPECT_FALSE(fs::exists(m_folder / "out.png"));
}

TEST_F(Doors, ModelsThatDoNotFitAreRefusedAndNothingIsWritten) {
    const auto draw = [](const std::vector<std::string>& inputs) {
        std::vector<std::string> all = {"synth", "draw-moments", "-o", "out.png"};
        for (const std::string& input : inputs)
            all.insert(all.end(), {"--input", "moments=" + input});
        return all;
    };
    Model model;
    model.kind = "something-else";
    writeModel(m_folder / "other.safetensors", model);
    expectRefusal(draw({}), {"Draw colour moments", "moments"});
    expectRefusal(draw({"other.safetensors"}), {"other.safetensors", "something-else", "moments"});
    const Ended picture = ended(draw({"bark.png"}));
    EXPECT_EQ(picture.status, 1);
    EXPECT_THAT(picture.err, HasSubstr("bark.png is damaged or no model"));
    run({"synth", "learn-moments", "bark.png", "-o", "learned.png", "--save", "moments=m.safetensors"});
    expectRefusal(draw({"m.safetensors", "m.safetensors"}), {"Draw colour moments", "1", "2"});
    EXPECT_FALSE(fs::exists(m_folder / "out.png"));
}

TEST_F(Doors, EachIsListedAsOthersAre) {
    std::set<std::string> ids, absent;
    for (const Json& method : Json::parse(run({"methods", "--json"})))
        (method.contains("absent") ? absent : ids).insert(method.at("id").get<std::string>());
    const std::set<std::string> networks = {"gram-cnn", "left-out", "solid-texture", "texture-network"};
    EXPECT_TRUE(absent == std::set<std::string>{"left-out"} || absent == networks); // all of them or none
    for (const char* id : {"mirror-tile", "stipple", "learn-moments", "solid-noise"})
        EXPECT_TRUE(ids.contains(id)) << id;
    run({"methods", "--markdown", "pages"});
    EXPECT_THAT(readText(m_folder / "pages" / "learn-moments.md"), HasSubstr("--save moments=FILE"));
    run({"synth", "mirror-tile", "bark.png", "--wrap", "xy", "-o", "out.png"});
}

TEST_F(Doors, ARunThatWasKilledGoesOnAsThoughItHadNotBeen) {
    const std::vector<std::string> whole = {"synth", "slow-diffusion", "bark.png", "--size",
                                            "64",    "--set",          "rounds=40"};
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.begin(), whole.begin(), whole.end());
        return more;
    };
    run(with({"-o", "uninterrupted.exr"}));
    {
        Program slow(with({"--set", "pause=50", "-o", "out.exr"}), m_folder.path(), TEXLOOM_CLI_DOORS);
        while (slow.running() && !fs::exists(m_folder / "out.exr.checkpoint"))
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        slow.signal(SIGKILL);
        slow.wait();
    }
    ASSERT_TRUE(fs::exists(m_folder / "out.exr.checkpoint"));
    EXPECT_FALSE(fs::exists(m_folder / "out.exr"));
    expectRefusal(with({"-o", "out.exr", "--resume"}), {"checkpoint", "other settings"});
    // A value that no round gives shows that the first one is not made again.
    std::string checkpoint = readText(m_folder / "out.exr.checkpoint");
    const std::string first = R"("values":[1.0)";
    ASSERT_NE(checkpoint.find(first), std::string::npos);
    writeText(m_folder / "out.exr.checkpoint",
              checkpoint.replace(checkpoint.find(first), first.size(), R"("values":[7.5)"));
    // By the recipe that a run writes beside its result, which is another way to ask for the same.
    run(with({"--set", "pause=50", "-o", "recipe.exr"}));
    run({"run", "recipe.json", "-o", "out.exr", "--resume", "--report", "report.json"});
    EXPECT_THAT(ended(with({"-o", "out.exr", "--resume"})).err, HasSubstr("no checkpoint"));
    EXPECT_TRUE(samePixels(image("uninterrupted.exr"), image("out.exr")));
    std::vector<double> rounds(40);
    std::iota(rounds.begin(), rounds.end(), 1.0);
    rounds.front() = 7.5;
    EXPECT_EQ(json("report.json").at("curves").at("Round").get<std::vector<double>>(), rounds);
    EXPECT_FALSE(fs::exists(m_folder / "out.exr.checkpoint"));
}

TEST_F(Doors, ARunBegunAnewSaysThatItReplacesACheckpoint) {
    const std::vector<std::string> arguments = {"synth", "slow-diffusion", "bark.png", "-o", "out.exr"};
    run(arguments);
    {
        std::vector<std::string> slowly = arguments;
        slowly.insert(slowly.end(), {"--overwrite", "--set", "pause=50"});
        Program slow(slowly, m_folder.path(), TEXLOOM_CLI_DOORS);
        while (slow.running() && !fs::exists(m_folder / "out.exr.checkpoint"))
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        slow.signal(SIGKILL);
        slow.wait();
    }
    std::vector<std::string> again = arguments;
    again.emplace_back("--overwrite");
    EXPECT_THAT(ended(again).err, AllOf(HasSubstr("out.exr.checkpoint"), HasSubstr("--resume")));
}

TEST_F(Doors, ADamagedCheckpointOrAnotherFileOfItsNameIsLeftAlone) {
    const std::vector<std::string> arguments = {"synth", "slow-diffusion", "bark.png", "-o", "out.exr"};
    writeText(m_folder / "out.exr.checkpoint", "my notes");
    expectRefusal(arguments, {"out.exr.checkpoint", "damaged"});
    EXPECT_EQ(readText(m_folder / "out.exr.checkpoint"), "my notes");
}

TEST_F(Doors, AToolEditsExemplars) {
    const Json ripple = Json::parse(run({"tools", "ripple", "--json"})).front();
    EXPECT_EQ(ripple.at("actsOn"), "image-mask-and-companions");
    EXPECT_THAT(run({"tools"}), HasSubstr("--edit ripple=…"));
    const std::vector<std::string> arguments = {"synth",   "quilting", "bark.png", "-o",
                                                "out.exr", "--set",    "patch=8",  "--size",
                                                "40x40",   "--quiet",  "--edit",   "ripple=3 length=12"};
    run(arguments);
    const Json edits = json("out.json").at("exemplars").at(0).at("edits");
    EXPECT_EQ(edits, Json::parse(R"([{"length": 12, "ripple": 3.0}])"));
    run({"run", "out.json", "-o", "again.exr"});
    EXPECT_TRUE(samePixels(image("out.exr"), image("again.exr")));
    std::vector<std::string> wrong = arguments;
    wrong.back() = "ripple=9";
    expectRefusal(wrong, {"ripple = 9: Height goes from 0 to 8 px."});
    wrong.back() = "riple=3";
    expectRefusal(wrong, {"riple", "Did you mean ripple?"});
    wrong.back() = "3:ripple=3";
    expectRefusal(wrong, {"3:ripple=3", "1"});
}

} // namespace texloom::test
