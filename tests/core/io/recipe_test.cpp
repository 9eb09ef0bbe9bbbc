#include "core/io/image_file.h"
#include "core/io/json_field.h"
#include "core/io/recipe.h"
#include "tests/core/io/write_as.h"
#include "tests/core/refusal.h"
#include "tests/core/tools/sample_edits.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/textures.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace texloom::test {

namespace {

namespace fs = std::filesystem;
using OrderedJson = nlohmann::ordered_json;

const fs::path kFolder = "/project/recipes";

/// Uses everything that a recipe can say.
Recipe fullRecipe() {
    Recipe recipe;
    recipe.version = "1.2.3";
    recipe.steps.front().method = "quilting";
    recipe.steps.front().parameters = {
        {"patch", 40}, {"overlap", 0.1}, {"mirror", true}, {"stitch", std::string("cut")}};
    recipe.steps.push_back({"random-phase", {{"model", std::string("spot-noise")}}});
    recipe.steps.push_back({"quilting", {}});
    RecipeExemplar bark;
    bark.image = {"/project/images/bark ü.png", "srgb", "A0B1"};
    bark.mask = RecipeFile{"/project/recipes/mask.png", "raw", "C2"};
    bark.companions = {{"/project/images/bark_normal.png", "raw", "D3"},
                       {"/elsewhere/height.exr", "raw", "", "height"}};
    bark.edits = {crop(1, 2, 30, 40),
                  turn(-12.5),
                  flip("vertical"),
                  rectify({{0.5, 1}, {20, 0}, {21, 30.25}, {0, 31}}, {64, 128}),
                  rectify({{0, 0}, {20, 0}, {20, 20}, {0, 20}}),
                  flatten("smooth", 0.75, {{"width", 0.125}}),
                  flatten("polynomial", 1, {{"order", 3}})};
    RecipeExemplar moss;
    moss.image = {"/project/images/moss.exr", "linear", ""};
    moss.weight = 2.5;
    recipe.exemplars = {bark, moss};
    recipe.inputs["initial"] = {RecipeFile{"/project/start.png", "acescg", "E4"}};
    recipe.size = {640, 480};
    recipe.wrap = {true, false};
    recipe.seed = 18446744073709551615ULL;
    recipe.region = Region{3, 5, {70, 90}};
    return recipe;
}

void expectSame(const RecipeFile& a, const RecipeFile& b) {
    EXPECT_EQ(a.path, b.path);
    EXPECT_EQ(a.space, b.space);
    EXPECT_EQ(a.hash, b.hash);
    EXPECT_EQ(a.role, b.role);
}

void expectSame(const Recipe& a, const Recipe& b) {
    EXPECT_EQ(a.version, b.version);
    ASSERT_EQ(a.steps.size(), b.steps.size());
    for (std::size_t i = 0; i < a.steps.size(); ++i) {
        EXPECT_EQ(a.steps[i].method, b.steps[i].method);
        EXPECT_EQ(a.steps[i].parameters, b.steps[i].parameters);
    }
    EXPECT_EQ(a.size, b.size);
    EXPECT_EQ(a.wrap, b.wrap);
    EXPECT_EQ(a.seed, b.seed);
    EXPECT_EQ(a.region, b.region);
    ASSERT_EQ(a.exemplars.size(), b.exemplars.size());
    for (std::size_t i = 0; i < a.exemplars.size(); ++i) {
        expectSame(a.exemplars[i].image, b.exemplars[i].image);
        ASSERT_EQ(a.exemplars[i].mask.has_value(), b.exemplars[i].mask.has_value());
        if (a.exemplars[i].mask)
            expectSame(*a.exemplars[i].mask, *b.exemplars[i].mask);
        EXPECT_EQ(a.exemplars[i].edits, b.exemplars[i].edits);
        EXPECT_EQ(a.exemplars[i].weight, b.exemplars[i].weight);
        ASSERT_EQ(a.exemplars[i].companions.size(), b.exemplars[i].companions.size());
        for (std::size_t k = 0; k < a.exemplars[i].companions.size(); ++k)
            expectSame(a.exemplars[i].companions[k], b.exemplars[i].companions[k]);
    }
    ASSERT_EQ(a.inputs.size(), b.inputs.size());
    for (const auto& [port, files] : a.inputs) {
        ASSERT_EQ(files.size(), b.inputs.at(port).size());
        for (std::size_t i = 0; i < files.size(); ++i)
            expectSame(files[i], b.inputs.at(port)[i]);
    }
}

/// The full recipe as JSON with one place changed.
std::string changed(const std::string& pointer, const OrderedJson& value) {
    OrderedJson json = OrderedJson::parse(fullRecipe().toJson(kFolder));
    json[OrderedJson::json_pointer(pointer)] = value;
    return json.dump();
}

std::string without(const std::string& field) {
    OrderedJson json = OrderedJson::parse(fullRecipe().toJson(kFolder));
    json.erase(field);
    return json.dump();
}

Recipe parsed(const std::string& text) {
    return Recipe::fromJson(text, kFolder);
}

} // namespace

TEST(Recipe, ComesBackWhole) {
    expectSame(parsed(fullRecipe().toJson(kFolder)), fullRecipe());
}

TEST(Recipe, KeepsEveryDoubleAndWhetherItIsWhole) {
    Recipe recipe = fullRecipe();
    recipe.steps.front().parameters = {
        {"a", 0.1}, {"b", 1e-300}, {"c", 1.0 / 3}, {"d", -2147483647}, {"e", 2.0}};
    const Recipe back = parsed(recipe.toJson(kFolder));
    for (const char* name : {"a", "b", "c", "e"})
        EXPECT_EQ(std::get<double>(back.steps.front().parameters.at(name)),
                  std::get<double>(recipe.steps.front().parameters.at(name)));
    EXPECT_EQ(back.steps.front().parameters.at("d"), Value(-2147483647));
}

TEST(Recipe, WritesPathsRelativeToItsFolder) {
    const OrderedJson json = OrderedJson::parse(fullRecipe().toJson(kFolder));
    EXPECT_EQ(json["exemplars"][0]["file"], "../images/bark ü.png");
    EXPECT_EQ(json["exemplars"][0]["mask"]["file"], "mask.png");
}

TEST(Recipe, FindsItsFilesFromAFolderThatWasMoved) {
    const Recipe moved = Recipe::fromJson(fullRecipe().toJson(kFolder), "/moved/recipes");
    EXPECT_EQ(moved.exemplars[0].image.path, "/moved/images/bark ü.png");
}

TEST(Recipe, NeedsNoMoreThanMethodExemplarAndSize) {
    const Recipe recipe =
        parsed(R"({"texloom": 1, "method": "quilting", "exemplars": [{"file": "a.png"}], "size": [8, 9]})");
    EXPECT_EQ(recipe.exemplars[0].image.path, kFolder / "a.png");
    EXPECT_EQ(recipe.size, (Size{8, 9}));
    EXPECT_EQ(recipe.seed, 0U);
    EXPECT_EQ(recipe.wrap, Wrap{});
}

TEST(Recipe, NamesAFieldThatIsMissing) {
    for (const char* field : {"texloom", "method", "size"})
        EXPECT_THAT([&] { parsed(without(field)); }, usageRefusal("has no " + std::string(field))) << field;
}

TEST(Recipe, NamesAFieldThatItDoesNotKnow) {
    EXPECT_THAT([&] { parsed(changed("/sede", 3)); }, usageRefusal("sede", "seed"));
    EXPECT_THAT([&] { parsed(changed("/exemplars/1/maks", "a.png")); },
                usageRefusal("exemplars[1].maks", "mask"));
}

TEST(Recipe, NamesAFieldOfTheWrongType) {
    const std::vector<std::pair<std::string, OrderedJson>> wrong = {
        {"/method", 3},       {"/version", 2},  {"/parameters", "none"}, {"/exemplars", "a.png"},
        {"/size", "640x480"}, {"/size", {640}}, {"/region", {1, 2, 3}},  {"/wrap", "z"},
        {"/seed", -1},        {"/seed", 1.5},   {"/seed", "1"},          {"/texloom", "one"},
        {"/initial", 5}};
    for (const auto& [pointer, value] : wrong)
        EXPECT_THAT(([&, at = pointer, is = value] { parsed(changed(at, is)); }),
                    usageRefusal(pointer.substr(1), value.dump()))
            << pointer;
}

TEST(Recipe, NamesAFieldDeepInside) {
    EXPECT_THAT([] { parsed(changed("/exemplars/0/companions/1/file", 7)); },
                usageRefusal("exemplars[0].companions[1].file", "7"));
    EXPECT_THAT([] { parsed(changed("/parameters/patch", OrderedJson::array())); },
                usageRefusal("parameters.patch"));
    EXPECT_THAT([] { parsed(changed("/size/1", 4.5)); }, usageRefusal("size[1]", "4.5"));
}

TEST(Recipe, RefusesWholeNumbersThatNoIntHolds) {
    for (const std::uint64_t number : {2147483648ULL, 9223372036854775808ULL, 18446744073709551615ULL}) {
        EXPECT_THAT([&] { parsed(changed("/size/0", number)); },
                    usageRefusal("size[0]", std::to_string(number)));
        EXPECT_THAT([&] { parsed(changed("/parameters/patch", number)); },
                    usageRefusal("parameters.patch", std::to_string(number)));
    }
}

TEST(Recipe, RefusesNumbersThatNoDoubleHolds) {
    EXPECT_THAT([] { parsed(R"({"texloom": 1, "parameters": {"patch": 1e999}})"); }, usageRefusal("recipe"));
}

TEST(Recipe, NamesAnUnknownColourSpace) {
    EXPECT_THAT([] { parsed(changed("/exemplars/0/space", "rec2020")); }, usageRefusal("rec2020", "srgb"));
}

TEST(Recipe, SaysThatItIsOfANewerFormat) {
    EXPECT_THAT([] { parsed(changed("/texloom", 2)); }, usageRefusal("format 2", "newer", "up to 1"));
}

TEST(Recipe, RefusesAFormatBelowTheFirst) {
    EXPECT_THAT([] { parsed(changed("/texloom", 0)); }, usageRefusal("texloom", "0"));
}

TEST(Recipe, SaysWhereTheJsonBreaksOff) {
    const std::string text = fullRecipe().toJson(kFolder);
    EXPECT_THAT([&] { parsed(text.substr(0, 50)); }, usageRefusal("not JSON", "byte 51"));
    EXPECT_THAT([&] { parsed(""); }, usageRefusal("not JSON"));
}

TEST(Recipe, RefusesJsonThatIsNoObject) {
    for (const char* text : {"[]", "3", "null", "\"recipe\""})
        EXPECT_THAT([&] { parsed(text); }, usageRefusal("object")) << text;
}

TEST(Recipe, RefusesDeepNesting) {
    for (const std::size_t depth : {std::size_t{20}, std::size_t{200000}})
        for (const char* bracket : {"[", "{\"a\":"}) {
            std::string text;
            for (std::size_t i = 0; i < depth; ++i)
                text += bracket;
            EXPECT_THROW(parsed(text), UsageError) << depth;
        }
}

TEST(Recipe, NeedsNoExemplars) {
    EXPECT_TRUE(parsed(changed("/exemplars", OrderedJson::array())).exemplars.empty());
    EXPECT_TRUE(parsed(without("exemplars")).exemplars.empty());
}

TEST(Recipe, NamesAndSpacesAreOfTheFirstExemplarOrInput) {
    Recipe recipe;
    EXPECT_EQ(recipe.name(), "texture");
    EXPECT_EQ(recipe.space(), "srgb");
    recipe.inputs["moments"] = {{"/data/bark.safetensors", "", ""}};
    EXPECT_EQ(recipe.name(), "bark");
    EXPECT_EQ(recipe.space(), "srgb");
    recipe.inputs["initial"] = {{"/data/first.png", "raw", ""}};
    EXPECT_EQ(recipe.space(), "raw");
    recipe.exemplars = {{{"/data/moss.exr", "acescg", ""}, {}, {}}};
    EXPECT_EQ(recipe.name(), "moss");
    EXPECT_EQ(recipe.space(), "acescg");
}

TEST(Recipe, SurvivesTextThatIsNotUtf8) {
    EXPECT_THROW(parsed("{\"texloom\": 1, \"method\": \"\xff\xfe\"}"), UsageError);
    Recipe recipe = fullRecipe();
    recipe.exemplars[0].image.path = "/project/images/\xff.png";
    EXPECT_NO_THROW(recipe.toJson(kFolder));
}

TEST(ReadRecipe, FindsItInEveryFormatThatEmbedsOne) {
    const TemporaryFolder folder;
    const std::string text = fullRecipe().toJson(kFolder);
    for (const char* name : {"a.png", "a.tif", "a.exr"}) {
        writeImage(folder / name, noise({8, 8}, 3), as(depthsFor(name).front(), "srgb", text));
        const Recipe back = readRecipe(folder / name);
        EXPECT_EQ(back.seed, fullRecipe().seed) << name;
        EXPECT_EQ(back.steps.front().parameters, fullRecipe().steps.front().parameters) << name;
        EXPECT_EQ(back.toJson(folder.path()), Recipe::fromJson(text, folder.path()).toJson(folder.path()))
            << name;
    }
}

TEST(ReadRecipe, FindsItInASidecar) {
    const TemporaryFolder folder;
    Recipe recipe = fullRecipe();
    recipe.exemplars[0].image.path = folder / "bark.png";
    writeText(folder / "a.json", recipe.toJson(folder.path()));
    expectSame(readRecipe(folder / "a.json"), recipe);
}

TEST(ReadRecipe, SaysThatAnImageHoldsNone) {
    const TemporaryFolder folder;
    writeImage(folder / "a.png", noise({8, 8}, 3), {});
    EXPECT_THAT([&] { readRecipe(folder / "a.png"); }, refusal("a.png", "no recipe"));
}

TEST(ReadRecipe, NamesTheFileThatIsWrong) {
    const TemporaryFolder folder;
    writeText(folder / "a.json", "{");
    EXPECT_THAT([&] { readRecipe(folder / "a.json"); }, usageRefusal("a.json", "not JSON"));
}

TEST(ReadRecipe, NamesAFileThatIsNotThere) {
    const TemporaryFolder folder;
    EXPECT_THAT([&] { readRecipe(folder / "gone.json"); }, refusal("gone.json"));
}

TEST(Recipe, RefusesAKeyThatStandsTwice) {
    EXPECT_THAT([] { Recipe::fromJson(R"({"texloom": 1, "method": "a", "method": "b"})", "/"); },
                usageRefusal("method", "twice"));
    EXPECT_NO_THROW(parseJson("recipe", R"({"a": {"b": 1}, "b": [{"a": 1}, {"a": 2}]})"));
}

TEST(Recipe, RefusesNamesThatNoFileCanHave) {
    const auto recipe = [](const std::string& file) {
        return R"({"texloom": 1, "method": "quilting", "size": [9, 9], "exemplars": [{)" + file + "}]}";
    };
    EXPECT_THAT([&] { Recipe::fromJson(recipe(R"("file": "tex.png\u0000x")"), "/"); },
                usageRefusal("exemplars[0].file", "zero"));
    EXPECT_THAT([&] { Recipe::fromJson(recipe(R"("file": "x", "fileBytes": "e")"), "/"); },
                usageRefusal("fileBytes", "hexadecimal"));
}

TEST(Recipe, KeepsNamesOfAnyBytesAndLayers) {
    Recipe recipe;
    recipe.exemplars = {{{"/data/latin\xe9.png", "srgb", ""}, {}, {}}};
    recipe.exemplars.front().image.layer = "diffuse";
    recipe.size = {8, 8};
    const Recipe again = Recipe::fromJson(recipe.toJson("/data"), "/data");
    EXPECT_EQ(again.exemplars.front().image.path, recipe.exemplars.front().image.path);
    EXPECT_EQ(again.exemplars.front().image.layer, "diffuse");
}

} // namespace texloom::test
