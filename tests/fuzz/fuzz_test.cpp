#include "core/io/image_file.h"
#include "core/io/map_file.h"
#include "core/io/model_file.h"
#include "core/io/recipe.h"
#include "core/network/filter_banks.h"
#include "core/network/weights_file.h"
#include "core/session/batch/batch.h"
#include "core/session/run/checkpoint_file.h"
#include "core/session/session.h"
#include "core/volume/mesh_file.h"
#include "core/volume/volume_file.h"
#include "tests/core/tools/sample_edits.h"
#include "tests/fuzz/fuzzed.h"
#include "tests/support/meshes.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/textures.h"
#include "tests/support/volumes.h"

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <ostream>

namespace texloom::test {

namespace {

namespace fs = std::filesystem;

constexpr std::int64_t kLargestPixels = 1 << 20;

std::string get(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

void put(const fs::path& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

/// The bytes of one small image in this format.
std::string sample(const TemporaryFolder& folder, const char* name, Depth depth, int channels) {
    WriteOptions options;
    options.depth = depth;
    options.recipe = R"({"texloom": 1, "method": "quilting"})";
    writeImage(folder / name, blobs({40, 31}, channels), options);
    std::string bytes = get(folder / name);
    fs::remove(folder / name);
    return bytes;
}

} // namespace

struct FuzzFormat {
    const char* name;
    std::vector<std::pair<Depth, int>> kinds;

    friend void PrintTo(const FuzzFormat& format, std::ostream* out) { *out << format.name; }
};

class FuzzImages : public ::testing::TestWithParam<FuzzFormat> {};

INSTANTIATE_TEST_SUITE_P(
    Fuzz, FuzzImages,
    ::testing::Values(FuzzFormat{"a.png", {{Depth::Bits8, 3}, {Depth::Bits16, 4}, {Depth::Bits8, 1}}},
                      FuzzFormat{"a.jpg", {{Depth::Bits8, 3}, {Depth::Bits8, 1}}},
                      FuzzFormat{"a.tif", {{Depth::Bits8, 3}, {Depth::Float, 4}, {Depth::Bits16, 1}}},
                      FuzzFormat{"a.exr", {{Depth::Half, 3}, {Depth::Float, 4}, {Depth::Half, 1}}},
                      FuzzFormat{"a.hdr", {{Depth::Float, 3}}}),
    [](const auto& test) { return fs::path(test.param.name).extension().string().substr(1); });

TEST_P(FuzzImages, AreReadOrRefused) {
    const TemporaryFolder folder;
    const char* name = GetParam().name;
    std::vector<std::string> originals;
    for (const auto& [depth, channels] : GetParam().kinds)
        originals.push_back(sample(folder, name, depth, channels));
    fuzz(name, originals, iterations(), [&](const std::string& bytes) {
        put(folder / name, bytes);
        expectReadOrRefused([&] { readImageInfo(folder / name); });
        readImage(folder / name, {.largestPixels = kLargestPixels});
    });
}

TEST(Fuzz, PositionMapsAreReadOrRefused) {
    for (const char* name : {"map.exr", "map.png"}) {
        const TemporaryFolder folder;
        writePositionMap(folder / name, PositionMap::identity({40, 31}));
        const std::string original = get(folder / name);
        fuzz(name, {original}, iterations() / 2, [&](const std::string& bytes) {
            put(folder / name, bytes);
            readImage(folder / name,
                      {.largestPixels = kLargestPixels}); // refuses what would take much memory
            const PositionMap map = readPositionMap(folder / name, {{40, 31}});
            for (int y = 0; y < map.height(); ++y)
                for (int x = 0; x < map.width(); ++x)
                    if (const Source source = map.at(x, y); source.valid()) {
                        ASSERT_LT(source.exemplar, map.exemplarSizes().size());
                        ASSERT_LT(source.x, map.exemplarSizes()[source.exemplar].width);
                        ASSERT_LT(source.y, map.exemplarSizes()[source.exemplar].height);
                    }
        });
    }
}

TEST(Fuzz, RecipesAreReadOrRefused) {
    Recipe recipe;
    recipe.steps.front().method = "quilting";
    recipe.steps.front().parameters = {
        {"patch", 40}, {"overlap", 0.25}, {"stitch", std::string("cut")}, {"on", true}};
    recipe.exemplars = {{{"/a/bark.png", "srgb", "00FF"}, RecipeFile{"/a/mask.png", "raw", ""}, {}}};
    recipe.exemplars.front().edits = {crop(1, 2, 30, 40), turn(-12.5),
                                      rectify({{0, 0}, {20, 0}, {20, 20}, {0, 20}}), flatten("smooth")};
    recipe.size = {512, 256};
    recipe.seed = 18446744073709551615ULL;
    const std::vector<std::string> originals = {
        recipe.toJson("/a"), R"({"texloom":1,"size":[1,2],"seed":1e9,"parameters":{"a":-1.5e+308}})",
        R"([[[{"a":[1e400,"\ud800",null]}]]])"};
    fuzz("recipe", originals, 20 * iterations(),
         [&](const std::string& text) { Recipe::fromJson(text, "/a"); });
}

TEST(Fuzz, BatchesAreReadOrRefused) {
    const std::vector<std::string> originals = {
        R"({"batch":1,"runs":[{"recipe":{"texloom":1,"method":"quilting","exemplars":[{"file":"a"}],"size":[9,9]},
            "output":"$name_${patch}_$w.png","sweep":{"patch":[8,12],"seed":[1,2]},"seeds":"varied"}]})",
        R"({"batch":1,"runs":[{"recipe":"gone.json","output":"${a}$$.png","maps":["m.exr"],"depth":"half"}]})"};
    fuzz("batch", originals, 10 * iterations(), [](const std::string& text) { Batch::fromJson(text, "/a"); });
}

TEST(Fuzz, SessionsAreReadOrRefused) {
    Session session;
    session.settings.exemplars = {{{"/a/bark.png", "srgb", "00FF"}, {}, {}}};
    session.settings.size = {512, 256};
    session.used = {true};
    fuzz("session",
         {session.toJson("/a"), R"({"session":1,"settings":{"texloom":1},"used":[],"current":-1})"},
         10 * iterations(), [](const std::string& text) { Session::fromJson(text, "/a"); });
}

TEST(Fuzz, CheckpointsAreReadOrRefused) {
    const TemporaryFolder folder;
    Recipe recipe;
    recipe.steps.front().method = "sparse";
    recipe.size = {64, 48};
    const fs::path file = folder / "a.png.checkpoint";
    writeCheckpoint(file, recipe, {1, 0.4, std::string("state\0\n{}", 9), {{TR("Energy"), {3, 2, 1}}}});
    const std::string original = get(file);
    fuzz("checkpoint", {original}, 5 * iterations(), [&](const std::string& bytes) {
        put(file, bytes);
        // What is read was not damaged, as its hash says.
        EXPECT_EQ(readCheckpoint(file).checkpoint.state, std::string("state\0\n{}", 9));
    });
}

TEST(Fuzz, RecipesInFilesAreReadOrRefused) {
    const TemporaryFolder folder;
    const std::string original = sample(folder, "a.png", Depth::Bits8, 3);
    fuzz("embedded", {original}, iterations() / 2, [&](const std::string& bytes) {
        put(folder / "a.png", bytes);
        readRecipe(folder / "a.png");
    });
}

TEST(Fuzz, ModelsAreReadOrRefused) {
    Model model;
    model.kind = "solid-texture";
    model.recipe = R"({"texloom": 1, "method": "solid-texture"})";
    model.exemplarHashes = {"00FF"};
    model.notes = {{"loss", "0.25"}};
    model.arrays["block.0.weight"] = {{2, 3}, std::vector<float>{1, -2, 3.5F, 0.1F, 1e-30F, 0}};
    model.arrays["adam.moment"] = {{3}, std::vector<double>{0.1, 1.0 / 3, 1e300}};
    model.arrays["step"] = {{}, std::vector<std::int64_t>{-7}};
    Model small;
    small.kind = "wei";
    small.arrays["w"] = {{64}, std::vector<float>(64, 0.5F)};
    fuzz("model", {model.bytes(), small.bytes()}, 20 * iterations(), [](const std::string& bytes) {
        const Model read = modelFromBytes(bytes, "m.safetensors");
        for (const auto& [name, array] : read.arrays)
            ASSERT_LE(std::visit([](const auto& values) { return values.size(); }, array.values),
                      bytes.size());
    });
}

TEST(Fuzz, DescriptorsAreReadOrRefused) {
    const std::string first = randomDescriptor(1).model().bytes();
    Descriptor two;
    two.name = "two";
    const auto filters = [](int outputs, int inputs, int side) {
        return Filters::zero(outputs, inputs, side);
    };
    using Kind = DescriptorLayer::Kind;
    two.chains = {{{Kind::Convolution, "a", filters(2, 3, 3)},
                   {Kind::Rectifier, "", {}},
                   {Kind::Pool, "", {}},
                   {Kind::Convolution, "b", filters(2, 2, 1)},
                   {Kind::Tap, "t", {}}}};
    fuzz("descriptor", {two.model().bytes(), first}, 10 * iterations(), [](const std::string& bytes) {
        const Descriptor read = Descriptor::from(modelFromBytes(bytes, "d.safetensors"));
        ASSERT_LE(4 * read.parameters(), bytes.size());
    });
}

TEST(Fuzz, WeightsAreReadOrRefused) {
    const TemporaryFolder folder;
    const std::string head =
        R"({"tensors": [{"name": "conv1_1.weight", "shape": [2, 3, 3, 3], "offset": 0, "count": 54},)"
        R"( {"name": "conv1_1.bias", "shape": [2], "offset": 54, "count": 2}]})";
    put(folder / "w.bin", std::string(56 * sizeof(float), '\0'));
    fuzz("weights", {head}, 5 * iterations(), [&](const std::string& bytes) {
        put(folder / "w.json", bytes);
        importWeights(folder / "w.json", {});
    });
}

TEST(Fuzz, RawVolumesAreReadOrRefused) {
    const TemporaryFolder folder;
    TestContext context(1);
    const DenseSource source(sampleVolume({5, 4, 3}, 2), DenseSource::Edge::Repeats);
    VolumeWriteOptions options;
    options.recipe = R"({"texloom": 1, "method": "solid-texture"})";
    writeVolume(folder / "v.json", source, {-1, 2, 3, {5, 4, 3}}, options, context);
    const std::string head = get(folder / "v.json");
    std::string unchecked = head; // so that what the hash would find is met, too
    unchecked.replace(unchecked.find("\"hash\""), 6, "\"hush\"");
    const std::string data = get(folder / "v.raw");
    fuzz("volume", {head, unchecked}, 5 * iterations(), [&](const std::string& bytes) {
        put(folder / "v.json", bytes);
        readVolume(folder / "v.json", context, {{}, kLargestPixels});
    });
    put(folder / "v.json", unchecked);
    fuzz("voxels", {data}, iterations(), [&](const std::string& bytes) {
        put(folder / "v.raw", bytes);
        readVolume(folder / "v.json", context, {{}, kLargestPixels});
    });
}

TEST(Fuzz, SlicesOfVolumesAreReadOrRefused) {
    const TemporaryFolder folder;
    TestContext context(1);
    writeVolume(folder / "v.png", DenseSource(sampleVolume({5, 4, 3}, 3), DenseSource::Edge::Ends),
                {0, 0, 0, {5, 4, 3}}, {}, context);
    const std::string original = get(folder / "v-0001.png");
    fuzz("slices", {original}, iterations() / 2, [&](const std::string& bytes) {
        put(folder / "v-0001.png", bytes);
        readVolume(folder / "v-0000.png", context, {{}, kLargestPixels});
    });
}

TEST(Fuzz, MeshesAreReadOrRefused) {
    std::map<std::string, std::vector<std::string>> byExtension;
    for (const auto& [name, bytes] : cubes())
        byExtension[fs::path(name).extension().string()].push_back(bytes);
    byExtension[".obj"].push_back("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvn 0 0 1\n"
                                  "f 1/1/1 2/2/1 3/1/-1 -1/-1/-1\nf 1//1 2//1 3//1\n");
    for (const auto& [extension, originals] : byExtension) {
        SCOPED_TRACE(extension);
        const TemporaryFolder folder;
        TestContext context(1);
        fuzz("mesh", originals, 5 * iterations(), [&](const std::string& bytes) {
            put(folder / ("m" + extension), bytes);
            const Mesh mesh = readMesh(folder / ("m" + extension), context);
            ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
            ASSERT_TRUE(mesh.uvs.empty() || mesh.uvs.size() == mesh.positions.size());
            for (const Mesh::Triangle& triangle : mesh.triangles)
                for (const std::uint32_t vertex : triangle)
                    ASSERT_LT(vertex, mesh.positions.size());
        });
    }
}

} // namespace texloom::test
