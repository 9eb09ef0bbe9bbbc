#include "core/io/image_file.h"
#include "core/io/map_file.h"
#include "core/methods/method.h"
#include "core/methods/registry.h"
#include "tests/cli/program.h"
#include "tests/support/textures.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <tuple>

namespace texloom::test {

namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using Json = nlohmann::json;

/// A folder with bark.png, 48 × 44 px, and bark_normal.png beside it.
class Cli : public ::testing::Test {
protected:
    Cli() {
        writeImage(m_folder / "bark.png", blobs({48, 44}, 3), {});
        writeImage(m_folder / "bark_normal.png", blobs({48, 44}, 3, 8), {});
    }

    /// Runs, expects success, and gives what it printed.
    std::string run(const std::vector<std::string>& arguments) const {
        const Ended ended = runCli(arguments, m_folder.path());
        EXPECT_EQ(ended.status, 0) << ended.err;
        EXPECT_EQ(ended.err, "");
        return ended.out;
    }
    /// Runs a small synth with further options; gives out.png.
    Image synth(std::vector<std::string> options, const std::string& output = "out.png") const {
        std::vector<std::string> arguments = {"synth",    "quilting", "bark.png", "--set",
                                              "patch=12", "-o",       output};
        if (std::find(options.begin(), options.end(), "--size") == options.end())
            options.insert(options.end(), {"--size", "64x60"});
        arguments.insert(arguments.end(), options.begin(), options.end());
        run(arguments);
        return image(output);
    }
    Image image(const std::string& name) const { return readImage(m_folder / name).image; }
    Json json(const std::string& name) const { return Json::parse(readText(m_folder / name)); }

    TemporaryFolder m_folder;
};

} // namespace

TEST_F(Cli, SaysItsVersion) {
    EXPECT_THAT(run({"--version"}), HasSubstr("texloom-cli "));
}

TEST_F(Cli, SaysThatAnotherBuildMadeARecipe) {
    synth({});
    const Image made = image("out.png");
    Json recipe = json("out.json");
    const std::string own = recipe.at("version");
    recipe["version"] = "0.0.9+abc";
    writeText(m_folder / "older.json", recipe.dump());
    const Ended ended = runCli({"run", "older.json", "-o", "again.png"}, m_folder.path());
    EXPECT_EQ(ended.status, 0);
    EXPECT_THAT(ended.err, AllOf(HasSubstr("0.0.9+abc"), HasSubstr(own)));
    EXPECT_TRUE(samePixels(image("again.png"), made));
}

TEST_F(Cli, WritesAPageForEveryMethod) {
    run({"methods", "--markdown", "pages"});
    for (const Method& method : methods()) {
        const std::string page = readText(m_folder / "pages" / (method.id() + ".md"));
        EXPECT_THAT(page, AllOf(HasSubstr("# " + method.info().title), HasSubstr(method.info().citation)));
        for (const Param& param : method.params())
            EXPECT_THAT(page, HasSubstr("| `" + param.name() + "` |"));
    }
}

TEST_F(Cli, ExplainsItselfInHelp) {
    const std::string help = run({"--help"});
    for (const char* command : {"methods", "synth", "run", "batch", "apply", "blend", "analyze"})
        EXPECT_THAT(help, HasSubstr(command));
    EXPECT_THAT(run({"synth", "--help"}), HasSubstr("--wrap"));
}

TEST_F(Cli, ListsEveryMethodAndParameter) {
    const std::string text = run({"methods"});
    for (const Method& method : methods()) {
        EXPECT_THAT(text, HasSubstr(method.id()));
        for (const Param& param : method.params()) {
            EXPECT_THAT(text, HasSubstr("--set " + param.name() + "="));
            EXPECT_THAT(text, HasSubstr(param.limits().text()));
        }
    }
}

TEST_F(Cli, ListsEveryMethodAndParameterAsJson) {
    const Json all = Json::parse(run({"methods", "--json"}));
    ASSERT_EQ(all.size(), methods().size() + absentMethods().size());
    for (std::size_t i = 0; i < methods().size(); ++i) {
        const Method& method = *methodsByCategory()[i];
        EXPECT_EQ(all[i].at("id"), method.id());
        EXPECT_EQ(all[i].at("cancelsWithinMilliseconds"), method.info().cancelsWithin.count());
        const Json& params = all[i].at("parameters");
        ASSERT_EQ(params.size(), method.params().size());
        for (std::size_t k = 0; k < params.size(); ++k) {
            const Param& param = method.params()[k];
            EXPECT_EQ(params[k].at("name"), param.name());
            EXPECT_EQ(params[k].at("help"), param.help());
            EXPECT_EQ(params[k].at("unit"), param.unit());
            EXPECT_TRUE(params[k].contains("type"));
            EXPECT_TRUE(params[k].contains("default"));
            EXPECT_EQ(params[k].contains("range"), param.hasRange());
        }
    }
}

TEST_F(Cli, ListsOneMethod) {
    EXPECT_EQ(Json::parse(run({"methods", "quilting", "--json"})).size(), 1U);
}

TEST_F(Cli, MakesAnOutputOfTheSize) {
    EXPECT_EQ(synth({"--size", "70x33"}).size(), (Size{70, 33}));
    EXPECT_EQ(synth({"--size", "50"}).size(), (Size{50, 50}));
}

TEST_F(Cli, MakesTwiceTheExemplarWithoutASize) {
    run({"synth", "quilting", "bark.png", "-o", "out.png"});
    EXPECT_EQ(image("out.png").size(), (Size{96, 88}));
}

TEST_F(Cli, SameSeedSamePixelsOnAnyNumberOfThreads) {
    const Image first = synth({"--seed", "5", "--threads", "1"});
    EXPECT_TRUE(samePixels(first, synth({"--seed", "5", "--threads", "1"}, "again.png")));
    EXPECT_TRUE(samePixels(first, synth({"--seed", "5", "--threads", "7"}, "seven.png")));
    EXPECT_FALSE(samePixels(first, synth({"--seed", "6"}, "other.png")));
}

TEST_F(Cli, SameSeedSameBytes) {
    synth({"--no-sidecar"});
    const std::string hash = fileHash(m_folder / "out.png");
    synth({"--no-sidecar", "--threads", "7"});
    EXPECT_EQ(fileHash(m_folder / "out.png"), hash);
}

TEST_F(Cli, TakesTheLargestSeed) {
    synth({"--seed", "18446744073709551615"});
    EXPECT_EQ(json("out.json").at("seed"), 18446744073709551615ULL);
}

TEST_F(Cli, SetsEveryParameter) {
    synth({"--set", "overlap=0.5", "--set", "tolerance=1.5", "--set", "stitch=smooth-cut", "--set",
           "softness=2", "--set", "contrast=0.5", "--set", "variety=2"});
    EXPECT_EQ(json("out.json").at("parameters"),
              Json::parse(R"({"patch": 12, "overlap": 0.5, "tolerance": 1.5, "contrast": 0.5,
                              "variety": 2.0, "stitch": "smooth-cut", "softness": 2, "radius": 0, "context": 200,
                              "seams": true, "tone": true, "companion-weight": 0.0})"));
}

TEST_F(Cli, Wraps) {
    synth({"--wrap", "xy", "--report", "report.json"});
    EXPECT_EQ(json("out.json").at("wrap"), "xy");
    EXPECT_LT(json("report.json").at("figures").at("Seam, left to right").get<double>(), 2);
    EXPECT_LT(json("report.json").at("figures").at("Seam, top to bottom").get<double>(), 2);
}

TEST_F(Cli, LeavesOutWhatTheMaskHides) {
    Image mask = constant({48, 44}, 1, 1);
    for (int y = 0; y < 44; ++y)
        for (int x = 0; x < 20; ++x)
            mask(x, y, 0) = 0;
    writeImage(m_folder / "mask.png", mask, {});
    synth({"--mask", "mask.png", "--map", "map.png"});
    const PositionMap map = readPositionMap(m_folder / "map.png");
    for (int y = 0; y < map.height(); ++y)
        for (int x = 0; x < map.width(); ++x)
            ASSERT_GE(map.at(x, y).x, 20);
}

TEST_F(Cli, StartsFromAnImageOfItsSize) {
    writeImage(m_folder / "start.png", blobs({57, 51}, 3, 4), {});
    run({"synth", "quilting", "bark.png", "--set", "patch=12", "--init", "start.png", "-o", "out.png"});
    EXPECT_EQ(image("out.png").size(), (Size{57, 51}));
    EXPECT_EQ(json("out.json").at("initial").at("file"), "start.png");
}

TEST_F(Cli, LearnsFromSeveralExemplars) {
    writeImage(m_folder / "moss.png", blobs({40, 40}, 3, 4), {});
    run({"synth", "quilting", "bark.png", "moss.png", "--set", "patch=12", "--size", "64", "-o", "out.png"});
    EXPECT_EQ(json("out.json").at("exemplars").size(), 2U);
}

TEST_F(Cli, WeighsExemplars) {
    writeImage(m_folder / "moss.png", blobs({40, 40}, 3, 4), {});
    run({"synth", "quilting", "bark.png", "moss.png", "--weight", "1", "--weight", "50", "--set", "patch=12",
         "--set", "tolerance=10", "--size", "64", "-o", "out.png"});
    EXPECT_EQ(json("out.json").at("exemplars").at(1).at("weight"), 50);
    run({"run", "out.json", "-o", "again.png"});
    EXPECT_TRUE(samePixels(image("out.png"), image("again.png")));
}

TEST_F(Cli, WritesTheDepthThatWasAsked) {
    for (const auto& [depth, file, expected] : {std::tuple{"16", "a.png", "16-bit"},
                                                {"8", "a.tif", "8-bit"},
                                                {"half", "a.exr", "half"},
                                                {"float", "b.exr", "float"}}) {
        synth({"--depth", depth}, file);
        EXPECT_EQ(readImageInfo(m_folder / file).depth, expected) << file;
    }
}

TEST_F(Cli, WritesTheSpaceThatWasAsked) {
    synth({"--out-space", "acescg"}, "a.exr");
    EXPECT_EQ(readImageInfo(m_folder / "a.exr").space, "acescg");
}

TEST_F(Cli, WritesUnderNamesThatAreNoUtf8) {
    synth({"--report", "r\xe9.json"}, "o\xe9.png");
    for (const char* name : {"o\xe9.png", "o\xe9.json", "r\xe9.json"})
        EXPECT_TRUE(fs::exists(m_folder / name)) << name;
}

TEST_F(Cli, WritesNoSidecarWhenNotWanted) {
    synth({"--no-sidecar"});
    EXPECT_FALSE(fs::exists(m_folder / "out.json"));
}

TEST_F(Cli, IsSilentWhenQuiet) {
    EXPECT_EQ(run({"synth", "quilting", "bark.png", "--size", "64", "-o", "out.png", "--quiet"}), "");
}

TEST_F(Cli, PrintsOneLineAndNoBarInAPipe) {
    const std::string text = run({"synth", "quilting", "bark.png", "--size", "64", "-o", "out.png"});
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1);
    EXPECT_THAT(text, HasSubstr("out.png"));
    EXPECT_THAT(text, ::testing::Not(HasSubstr("\r")));
}

TEST_F(Cli, RunsASidecarAgainToTheSamePixels) {
    const Image first = synth({"--seed", "9", "--wrap", "x"});
    run({"run", "out.json", "-o", "again.png"});
    EXPECT_TRUE(samePixels(image("again.png"), first));
}

TEST_F(Cli, RunsAnExportedImageAgainToTheSamePixels) {
    for (const char* name : {"a.png", "a.tif"}) {
        const Image first = synth({"--seed", "9", "--no-sidecar"}, name);
        run({"run", name, "-o", "again.png"});
        EXPECT_TRUE(samePixels(image("again.png"), first)) << name;
    }
}

TEST_F(Cli, RunsARecipeFromAnotherFolder) {
    const Image first = synth({});
    const TemporaryFolder elsewhere;
    const Ended ended =
        runCli({"run", (m_folder / "out.json").string(), "-o", "again.png"}, elsewhere.path());
    EXPECT_EQ(ended.status, 0) << ended.err;
    EXPECT_TRUE(samePixels(readImage(elsewhere / "again.png").image, first));
}

TEST_F(Cli, NamesTheOutputOfARunItself) {
    synth({"--seed", "9"});
    run({"run", "out.json"});
    EXPECT_TRUE(fs::exists(m_folder / "bark_quilting_s9_64x60.png"));
}

TEST_F(Cli, NeverOverwritesAnOutputThatItNamedItself) {
    synth({"--seed", "9"});
    writeText(m_folder / "bark_quilting_s9_64x60.png", "mine");
    EXPECT_EQ(runCli({"run", "out.json"}, m_folder.path()).status, 1);
    EXPECT_EQ(readText(m_folder / "bark_quilting_s9_64x60.png"), "mine");
}

TEST_F(Cli, WarnsThatAnExemplarHasChanged) {
    synth({});
    writeImage(m_folder / "bark.png", blobs({48, 44}, 3, 77), {});
    const Ended ended = runCli({"run", "out.json", "-o", "again.png"}, m_folder.path());
    EXPECT_EQ(ended.status, 0);
    EXPECT_EQ(ended.complaints(), 1);
    EXPECT_THAT(ended.err, HasSubstr("bark.png"));
}

TEST_F(Cli, ApplyMakesTheOutputFromEitherMap) {
    const Image first = synth({"--map", "map.exr", "--map", "map.png"});
    for (const char* map : {"map.exr", "map.png"}) {
        run({"apply", map, "bark.png", "-o", "applied.png"});
        EXPECT_TRUE(samePixels(image("applied.png"), first)) << map;
    }
}

TEST_F(Cli, ApplyLaysOutACompanionAsTheSynthDid) {
    synth({"--map", "map.exr", "--companion", "bark_normal.png"});
    run({"apply", "map.exr", "bark_normal.png", "-o", "applied.png", "--quiet"});
    EXPECT_TRUE(samePixels(image("applied.png"), image("out_normal.png")));
}

TEST_F(Cli, MethodsFollowEachOther) {
    const Ended ended = runCli({"synth", "random-phase", "bark.png", "--then", "quilting", "--set",
                                "quilting.patch=14", "--set", "model=spot-noise", "-o", "both.png"},
                               m_folder.path());
    ASSERT_EQ(ended.status, 0) << ended.err;
    const Json recipe = json("both.json");
    EXPECT_EQ(recipe.at("parameters").at("model"), "spot-noise");
    EXPECT_EQ(recipe.at("then").at(0).at("method"), "quilting");
    EXPECT_EQ(recipe.at("then").at(0).at("parameters").at("patch"), 14);
    run({"run", "both.png", "-o", "again.png"});
    EXPECT_TRUE(samePixels(image("again.png"), image("both.png")));
}

TEST_F(Cli, CompanionsAreMadeWithTheResult) {
    run({"synth", "random-phase", "bark.png", "--companion", "bark_normal.png", "-o", "field.png"});
    EXPECT_EQ(image("field_normal.png").size(), image("field.png").size());
}

TEST_F(Cli, ReportsRecipeStagesTimesMemoryAndFigures) {
    synth({"--report", "report.json", "--threads", "1"});
    const Json report = json("report.json");
    EXPECT_EQ(report.at("recipe").at("method"), "quilting");
    EXPECT_FALSE(report.at("stages").empty());
    double sum = 0;
    for (const Json& stage : report.at("stages"))
        if (stage.at("name") != "Judging the result")
            sum += stage.at("seconds").get<double>();
    EXPECT_NEAR(report.at("seconds").get<double>(), sum, 1e-4);
    EXPECT_GT(report.at("peakMemoryBytes").get<double>(), 1e7);
    EXPECT_FALSE(report.at("figures").empty());
}

TEST_F(Cli, WritesNothingButWhatWasAsked) {
    synth({"--map", "map.exr", "--companion", "bark_normal.png", "--report", "report.json"});
    // bark, its normal map, the output, its sidecar, its map, its normal map, the report.
    EXPECT_EQ(m_folder.entries(), 7);
}

} // namespace texloom::test
