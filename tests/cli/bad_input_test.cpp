#include "core/io/image_file.h"
#include "core/io/map_file.h"
#include "core/session/run/run.h"
#include "tests/cli/program.h"
#include "tests/support/textures.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include <fstream>
#include <limits>
#include <ostream>
#include <set>

namespace texloom::test {

namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using Json = nlohmann::json;

enum Status { kFailed = 1, kUsage = 2 };

/// Something that cannot be done, and what the one line about it must hold.
struct Row {
    const char* label;
    std::vector<std::string> arguments;
    int status;
    std::vector<std::string> parts;

    friend void PrintTo(const Row& row, std::ostream* out) { *out << row.label; }
};

/// synth with these in place of the usual exemplar and output.
std::vector<std::string> synth(const std::string& exemplar, std::vector<std::string> options,
                               const std::string& output = "out.png") {
    options.insert(options.begin(), {"synth", "quilting", exemplar, "-o", output});
    return options;
}

const std::vector<Row>& rows() {
    static const std::vector<Row> all = {
        {"ExemplarSmallerThanThePatch",
         synth("bark.png", {"--set", "patch=45"}),
         kUsage,
         {"bark", "48 × 44", "45"}},
        {"PatchOfOne", synth("bark.png", {"--set", "patch=1"}), kUsage, {"patch = 1", "4 to 512 px"}},
        {"OverlapTooLarge",
         synth("bark.png", {"--set", "overlap=0.7"}),
         kUsage,
         {"overlap = 0.7", "0.02 to 0.5"}},
        {"NegativeTolerance",
         synth("bark.png", {"--set", "tolerance=-1"}),
         kUsage,
         {"tolerance = -1", "0 to 10"}},
        {"NoNumber", synth("bark.png", {"--set", "patch=big"}), kUsage, {"patch = big", "4 to 512"}},
        {"NoValue", synth("bark.png", {"--set", "patch"}), kUsage, {"--set patch", "name=value"}},
        {"EmptyValue", synth("bark.png", {"--set", "patch="}), kUsage, {"patch", "4 to 512"}},
        {"UnknownParameter", synth("bark.png", {"--set", "pach=12"}), kUsage, {"pach", "patch"}},
        {"UnknownMethod", {"synth", "quiltin", "bark.png", "-o", "out.png"}, kUsage, {"quiltin", "quilting"}},
        {"UnknownMethodListed", {"methods", "quiltin"}, kUsage, {"quiltin", "quilting"}},
        {"UnknownOption", synth("bark.png", {"--sise", "64"}), kUsage, {"--sise"}},
        {"UnknownCommand", {"synthesise"}, kUsage, {"synthesise"}},
        {"NoCommand", {}, kUsage, {"--help"}},
        {"SizeZero", synth("bark.png", {"--size", "0x0"}), kUsage, {"0x0", "1 to 65,536"}},
        {"SizeTooLarge", synth("bark.png", {"--size", "200000x200000"}), kUsage, {"200000x200000", "65,536"}},
        {"SizeNoSize", synth("bark.png", {"--size", "64by64"}), kUsage, {"64by64", "512x256"}},
        {"SizeWithoutAHeight", synth("bark.png", {"--size", "64x"}), kUsage, {"--size", "\"64x\"", "65,536"}},
        {"SizeOfThree", synth("bark.png", {"--size", "64x64x64"}), kUsage, {"64x64x64", "512x256"}},
        {"RegionOfThree",
         synth("bark.png", {"--region", "1,2,3"}),
         kUsage,
         {"\"1,2,3\"", "x,y,width,height"}},
        {"RegionOfFive", synth("bark.png", {"--region", "1,2,3,4,5"}), kUsage, {"1,2,3,4,5", "65,536"}},
        {"RegionOfNothing", synth("bark.png", {"--region", "1,2,0,4"}), kUsage, {"1,2,0,4", "width"}},
        {"WrapOnNoAxis", synth("bark.png", {"--wrap", "z"}), kUsage, {"--wrap", "\"z\"", "x, y and xy"}},
        {"NegativeSeed", synth("bark.png", {"--seed", "-1"}), kUsage, {"--seed", "-1"}},
        {"SeedTooLarge",
         synth("bark.png", {"--seed", "18446744073709551616"}),
         kUsage,
         {"--seed", "18446744073709551616"}},
        {"SeedNoNumber", synth("bark.png", {"--seed", "lucky"}), kUsage, {"--seed", "lucky", "from 0 to"}},
        {"NoThreads", synth("bark.png", {"--threads", "0"}), kUsage, {"--threads", "1"}},
        {"MissingOutput", {"synth", "quilting", "bark.png"}, kUsage, {"--output", "required"}},
        {"MissingExemplar", {"synth", "quilting", "-o", "out.png"}, kUsage, {"exemplar"}},
        {"ExemplarNotThere", synth("gone.png", {}), kFailed, {"gone.png"}},
        {"ExemplarIsAFolder", synth(".", {}), kFailed, {"folder"}},
        {"ZeroBytes", synth("zero.png", {}), kFailed, {"zero.png", "0 bytes"}},
        {"Truncated", synth("truncated.png", {}), kFailed, {"truncated.png"}},
        {"TextNamedPng", synth("text.png", {}), kFailed, {"text.png", "not an image"}},
        {"NotANumber", synth("nan.exr", {}), kFailed, {"nan.exr", "1 value", "(3, 2)"}},
        {"UnknownExtension", synth("bark.png", {}, "out.xyz"), kUsage, {"out.xyz", ".png", ".exr"}},
        {"FolderIsAFile", synth("bark.png", {}, "text.png/out.png"), kFailed, {"text.png"}},
        {"FolderNotThere", synth("bark.png", {}, "gone/out.png"), kFailed, {"gone"}},
        {"OutputIsAFolder", synth("bark.png", {}, "folder.png"), kFailed, {"folder.png", "folder"}},
        {"MapUnknownExtension", synth("bark.png", {"--map", "map.tif"}), kUsage, {"map.tif", ".exr"}},
        {"MapFolderNotThere", synth("bark.png", {"--map", "gone/map.exr"}), kFailed, {"gone"}},
        {"MapIsTheOutput", synth("bark.png", {"--map", "out.png"}), kUsage, {"out.png"}},
        {"OutputIsTheExemplar", synth("bark.png", {}, "./bark.png"), kUsage, {"bark.png"}},
        {"MapIsTheExemplar", synth("bark.png", {"--map", "bark.png"}), kUsage, {"bark.png", "overwritten"}},
        {"OutputIsTheMask", synth("bark.png", {"--mask", "white.png"}, "white.png"), kUsage, {"white.png"}},
        {"OutputIsACompanion",
         synth("bark.png", {"--companion", "white.png"}, "white.png"),
         kUsage,
         {"white.png"}},
        {"ReportIsTheExemplar",
         synth("bark.png", {"--report", "bark.png"}),
         kUsage,
         {"bark.png", "overwritten"}},
        {"ExemplarsNameIsTooLong", synth(std::string(300, 'a') + ".png", {}), kFailed, {"cannot be read"}},
        {"OutputsNameIsTooLong",
         synth("bark.png", {}, std::string(300, 'a') + ".png"),
         kFailed,
         {"cannot be written"}},
        {"ReportFolderNotThere", synth("bark.png", {"--report", "gone/report.json"}), kFailed, {"gone"}},
        {"DepthThatTheFormatDoesNotHold", synth("bark.png", {"--depth", "half"}), kUsage, {".png", "half"}},
        {"UnknownDepth", synth("bark.png", {"--depth", "12"}), kUsage, {"12", "16"}},
        {"UnknownOutputSpace", synth("bark.png", {"--out-space", "rec2020"}), kUsage, {"rec2020", "srgb"}},
        {"UnknownExemplarSpace", synth("bark.png", {"--space", "rec2020"}), kUsage, {"rec2020", "srgb"}},
        {"CompanionOfAnotherSize",
         synth("bark.png", {"--companion", "small.png"}),
         kUsage,
         {"small", "20 × 20", "48 × 44"}},
        {"WeightTooLarge", synth("bark.png", {"--weight", "1000"}), kUsage, {"bark", "1000", "100"}},
        {"MoreWeightsThanExemplars",
         synth("bark.png", {"--weight", "1", "--weight", "2"}),
         kUsage,
         {"2 weights", "1 exemplar"}},
        {"MaskOfAnotherSize", synth("bark.png", {"--mask", "small.png"}), kUsage, {"20 × 20", "48 × 44"}},
        {"EmptyMask", synth("bark.png", {"--mask", "black.png"}), kUsage, {"mask"}},
        {"InitialOfAnotherSize",
         synth("bark.png", {"--init", "small.png", "--size", "64"}),
         kUsage,
         {"20 × 20", "64 × 64"}},
        {"FollowedByAnUnknownMethod",
         synth("bark.png", {"--then", "quiltin"}),
         kUsage,
         {"quiltin", "Did you mean quilting?"}},
        {"FollowedByWhatCannotStartFromAnImage",
         synth("bark.png", {"--then", "random-phase"}),
         kUsage,
         {"Random phase", "uses nothing"}},
        {"SettingOfAMethodThatIsNotRun",
         synth("bark.png", {"--set", "random-phase.model=spot-noise"}),
         kUsage,
         {"random-phase"}},
        {"RecipeWithAnUnknownMethod",
         {"run", "method.json", "-o", "out.png"},
         kUsage,
         {"quiltin", "quilting"}},
        {"RecipeWithAnUnknownParameter",
         {"run", "parameter.json", "-o", "out.png"},
         kUsage,
         {"pach", "patch"}},
        {"RecipeWithAValueOutOfRange",
         {"run", "range.json", "-o", "out.png"},
         kUsage,
         {"patch = 1", "4 to 512"}},
        {"RecipeCutShort", {"run", "short.json", "-o", "out.png"}, kUsage, {"short.json", "JSON"}},
        {"RecipeNotThere", {"run", "gone.json", "-o", "out.png"}, kFailed, {"gone.json"}},
        {"ImageWithoutARecipe", {"run", "bark.png", "-o", "out.png"}, kFailed, {"bark.png", "recipe"}},
        {"MapThatIsNone", {"apply", "bark.png", "bark.png", "-o", "out.png"}, kFailed, {"bark.png", "map"}},
        {"AppliedToItself",
         {"apply", "map.png", "bark.png", "-o", "bark.png"},
         kUsage,
         {"bark.png", "overwritten"}},
        {"AppliedOverTheMap",
         {"apply", "map.png", "bark.png", "-o", "map.png"},
         kUsage,
         {"map.png", "overwritten"}},
        {"MapNotThere", {"apply", "gone.exr", "bark.png", "-o", "out.png"}, kFailed, {"gone.exr"}},
    };
    return all;
}

void put(const fs::path& path, std::string_view bytes) {
    std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

void putRecipe(const fs::path& path, const std::string& method, const Json& parameters) {
    const Json recipe = {{"texloom", 1},
                         {"method", method},
                         {"parameters", parameters},
                         {"exemplars", {{{"file", "bark.png"}}}},
                         {"size", {64, 64}}};
    put(path, recipe.dump());
}

void putTruncated(const fs::path& whole, const fs::path& path) {
    std::ifstream file(whole, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    put(path, std::string_view(bytes).substr(0, bytes.size() / 2));
}

/// Every file with its content: what must be as it was.
std::set<std::pair<fs::path, std::string>> everything(const fs::path& folder) {
    std::set<std::pair<fs::path, std::string>> files;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
        files.emplace(entry.path(), entry.is_regular_file() ? fileHash(entry.path()) : "folder");
    return files;
}

class BadInput : public ::testing::TestWithParam<Row> {
protected:
    BadInput() {
        writeImage(m_folder / "bark.png", blobs({48, 44}, 3), {});
        writeImage(m_folder / "small.png", blobs({20, 20}, 3), {});
        writeImage(m_folder / "black.png", constant({48, 44}, 1, 0), {});
        writeImage(m_folder / "white.png", constant({48, 44}, 1, 1), {});
        writePositionMap(m_folder / "map.png", PositionMap::identity({48, 44}));
        Image broken = blobs({48, 44}, 3);
        broken(3, 2, 1) = std::numeric_limits<float>::quiet_NaN();
        WriteOptions options;
        options.depth = Depth::Float;
        writeImage(m_folder / "nan.exr", broken, options);
        put(m_folder / "zero.png", "");
        put(m_folder / "text.png", "Dear Sir or Madam,\n");
        putTruncated(m_folder / "bark.png", m_folder / "truncated.png");
        fs::create_directory(m_folder / "folder.png");
        putRecipe(m_folder / "method.json", "quiltin", Json::object());
        putRecipe(m_folder / "parameter.json", "quilting", {{"pach", 12}});
        putRecipe(m_folder / "range.json", "quilting", {{"patch", 1}});
        put(m_folder / "short.json", "{\"texloom\": 1, \"method\"");
    }

    TemporaryFolder m_folder;
};

} // namespace

INSTANTIATE_TEST_SUITE_P(Cli, BadInput, ::testing::ValuesIn(rows()),
                         [](const auto& test) { return test.param.label; });

TEST_P(BadInput, GetsOneClearLineAndLeavesNothing) {
    const auto before = everything(m_folder.path());
    const Ended ended = runCli(GetParam().arguments, m_folder.path());
    EXPECT_EQ(ended.status, GetParam().status);
    EXPECT_EQ(ended.complaints(), 1) << ended.err;
    for (const std::string& part : GetParam().parts)
        EXPECT_THAT(ended.err, HasSubstr(part));
    EXPECT_EQ(ended.out, "");
    EXPECT_EQ(everything(m_folder.path()), before);
}

TEST_F(BadInput, NamesTheMemoryThatIsMissing) {
    const std::int64_t memory = ::sysconf(_SC_PHYS_PAGES) * ::sysconf(_SC_PAGE_SIZE);
    if (memory > 64LL << 30)
        GTEST_SKIP() << "skipped: the output may fit into this machine's memory";
    const Ended ended = runCli(synth("bark.png", {"--size", "65536x65536"}), m_folder.path());
    EXPECT_EQ(ended.status, kFailed);
    EXPECT_EQ(ended.complaints(), 1) << ended.err;
    for (const char* part : {"65536 × 65536", "GiB", "smaller"})
        EXPECT_THAT(ended.err, HasSubstr(part));
}

/// What can be known to fail is refused before minutes of work, not after them.
class BadOutput : public BadInput {};

INSTANTIATE_TEST_SUITE_P(Cli, BadOutput,
                         ::testing::Values(Row{"Space", {"--out-space", "rec2020"}, kUsage, {}},
                                           Row{"Depth", {"--depth", "half"}, kUsage, {}},
                                           Row{"Report", {"--report", "gone/report.json"}, kFailed, {}}),
                         [](const auto& test) { return test.param.label; });

TEST_P(BadOutput, IsRefusedBeforeTheWork) {
    std::vector<std::string> arguments = synth("bark.png", {"--set", "patch=4", "--size", "8192"});
    arguments.insert(arguments.end(), GetParam().arguments.begin(), GetParam().arguments.end());
    Program program(arguments, m_folder.path());
    EXPECT_EQ(program.wait(std::chrono::seconds(10)).status, GetParam().status);
}

} // namespace texloom::test
