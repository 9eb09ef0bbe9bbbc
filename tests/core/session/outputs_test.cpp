// What goes into and comes out of methods beside pictures and maps: models, volumes, meshes.

#include "core/io/model_file.h"
#include "core/session/export/export.h"
#include "core/session/export/output_files.h"
#include "core/session/results/result_files.h"
#include "core/session/run/asset_file.h"
#include "core/session/session.h"
#include "core/volume/mesh_file.h"
#include "core/volume/volume_file.h"
#include "tests/core/refusal.h"
#include "tests/core/session/sample_run.h"
#include "tests/support/volumes.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

namespace texloom::test {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// A run of one of the tests' own methods, with exemplars if it learns from any.
struct DoorRun : SampleRun {
    explicit DoorRun(const char* method) {
        input.steps = {{method, {}}};
        if (!findMethod(method).info().takesExemplars())
            input.exemplars.clear();
    }
};

std::shared_ptr<const Model> modelOf(const Result& result) {
    return result.synthesis.outputs.first<Model>("moments");
}

std::shared_ptr<const VolumeSource> volumeOf(const Result& result) {
    return result.synthesis.outputs.first<VolumeSource>("volume");
}

/// Learns from the run's exemplar, or another where it has none, and writes the model to a file.
fs::path writeMoments(const SampleRun& sample, const std::string& name = "bark.safetensors") {
    SampleRun learning;
    if (!sample.input.exemplars.empty())
        learning.input.exemplars = sample.input.exemplars;
    learning.input.steps = {{"learn-moments", {}}};
    const fs::path path = sample.folder / name;
    writeModel(path, *modelOf(learning.run()));
    return path;
}

const Port kMoments{.id = "moments", .title = "Moments", .help = "", .kind = AssetKind::Model};
const Port kSolid{.id = "solid", .title = "Solid", .help = "", .kind = AssetKind::Volume};
const Port kSurface{.id = "surface", .title = "Surface", .help = "", .kind = AssetKind::Mesh};

InputFile load(const Port& port, const fs::path& path) {
    return loadInput(port, {path, "", ""}, {});
}

fs::path writeSolid(const TemporaryFolder& folder, const std::string& name, const Volume& volume) {
    TestContext context;
    writeVolume(folder / name, DenseSource(volume, DenseSource::Edge::Ends), {0, 0, 0, volume.size()}, {},
                context);
    return folder / name;
}

std::shared_ptr<const Mesh> triangle() {
    auto mesh = std::make_shared<Mesh>();
    mesh->positions = {{0, 0, 0}, {2, 0, 0.125F}, {0, 3, 0}};
    mesh->normals.assign(3, Eigen::Vector3f::UnitZ());
    mesh->uvs = {{0, 0}, {0.25F, 1}, {1, 0.5F}};
    mesh->triangles = {{0, 1, 2}};
    return mesh;
}

} // namespace

TEST(Inputs, AreReadByTheKindOfTheirPort) {
    const DoorRun sample("draw-moments");
    const InputFile model = load(kMoments, writeMoments(sample));
    EXPECT_TRUE(isOf(AssetKind::Model, model.asset));
    EXPECT_EQ(model.file.hash, fileHash(model.file.path));

    const Volume volume = sampleVolume({5, 4, 3}, 2);
    for (const char* name : {"v.json", "v.tif"}) {
        writeSolid(sample.folder, name, volume);
        const fs::path path = sample.folder / (name == std::string("v.json") ? name : "v-0001.tif");
        const InputFile solid = load(kSolid, path);
        const auto source = std::get<std::shared_ptr<const VolumeSource>>(solid.asset);
        EXPECT_EQ(source->bounds(), (Box{0, 0, 0, {5, 4, 3}}));
    }
    writeMesh(sample.folder / "m.ply", *triangle());
    const auto mesh = std::get<std::shared_ptr<const Mesh>>(load(kSurface, sample.folder / "m.ply").asset);
    EXPECT_EQ(mesh->positions, triangle()->positions);
    EXPECT_EQ(mesh->uvs, triangle()->uvs);
    EXPECT_EQ(mesh->triangles, triangle()->triangles);
}

TEST(Inputs, ThatAreSeveralFilesHaveAHashOfAll) {
    const TemporaryFolder folder;
    Volume volume = sampleVolume({5, 4, 3}, 1);
    writeSolid(folder, "v.png", volume);
    const std::string before = load(kSolid, folder / "v-0000.png").file.hash;
    EXPECT_EQ(load(kSolid, folder / "v-0000.png").file.hash, before);
    volume(1, 1, 2, 0) = 1;
    writeSolid(folder, "v.png", volume);
    EXPECT_NE(load(kSolid, folder / "v-0000.png").file.hash, before) << "another slice counts, too";
}

TEST(Inputs, OfAnotherKindAreRefusedByName) {
    const DoorRun sample("draw-moments");
    const fs::path model = writeMoments(sample), picture = sample.write("picture", {9, 9}, 3);
    EXPECT_THAT([&] { load(kMoments, picture); }, refusal("picture.png", "no model"));
    EXPECT_THAT([&] { load(kSolid, model); }, refusal("bark.safetensors", "no slice of a volume"));
    EXPECT_THAT([&] { load(kSurface, picture); }, refusal("picture.png", "not a mesh"));
    EXPECT_THAT([&] { load({.id = "target", .title = "Target", .help = ""}, model); },
                refusal("bark.safetensors"));
    EXPECT_THAT([&] { load(kMoments, sample.folder / "gone.safetensors"); }, refusal("gone.safetensors"));
}

TEST(Inputs, ModelsOfAnotherKindOrANewerFormatAreRefused) {
    const DoorRun sample("draw-moments");
    const Port weights{.id = "weights", .title = "Weights", .help = "", .kind = AssetKind::Model};
    const fs::path path = writeMoments(sample);
    EXPECT_THAT([&] { load(weights, path); }, usageRefusal("bark.safetensors", "moments", "weights"));
    std::string bytes = readText(path);
    const std::string format = R"("texloom.format":"1")";
    bytes.replace(bytes.find(format), format.size(), R"("texloom.format":"2")");
    writeText(path, bytes);
    EXPECT_THAT([&] { load(kMoments, path); }, refusal("bark.safetensors", "format 2", "up to 1", "newer"));
}

TEST(Inputs, VolumesWhoseSizeOverflowsAreRefused) {
    const TemporaryFolder folder;
    const fs::path path = writeSolid(folder, "v.json", sampleVolume({5, 4, 3}, 1));
    Json head = Json::parse(readText(path));
    for (const Json& size :
         {Json{2000000000, 2000000000, 2000000000}, Json{65536, 65536, 1}, Json{1 << 20, 1 << 20, 1 << 24}}) {
        head["size"] = size;
        writeText(path, head.dump());
        EXPECT_THAT([&] { load(kSolid, path); }, refusal("v.json", "voxels", "can be opened", "536,870,912"));
    }
    head["size"] = {5, 4, 4};
    writeText(path, head.dump());
    EXPECT_THAT([&] { load(kSolid, path); }, refusal("v.raw", "240 bytes", "5 × 4 × 4", "320"));
    head["size"] = {1e30, 4, 4};
    writeText(path, head.dump());
    EXPECT_THAT([&] { load(kSolid, path); }, refusal("v.json", "size[0]"));
}

TEST(PlanRun, RefusesAModelThatIsMissingOrGivenTwice) {
    DoorRun sample("draw-moments");
    EXPECT_THAT([&] { planRun(sample.input); },
                usageRefusal("Draw colour moments needs its input moments", "not given"));
    const InputFile model = load(kMoments, writeMoments(sample));
    sample.input.inputs["moments"] = {model, model};
    EXPECT_THAT([&] { planRun(sample.input); }, usageRefusal("takes 1", "moments", "2 were given"));
    sample.input.inputs["moments"] = {model};
    EXPECT_NO_THROW(planRun(sample.input));
    sample.input.inputs["momens"] = {model};
    EXPECT_THAT([&] { planRun(sample.input); }, usageRefusal("Draw colour moments", "momens"));
}

TEST(Pipeline, HandsAModelOnAndKeepsIt) {
    DoorRun sample("learn-moments");
    sample.input.steps.push_back({"draw-moments", {}});
    const Result both = sample.run();
    ASSERT_NE(modelOf(both), nullptr) << "what was learned is not lost";
    const Result learned = [&] {
        DoorRun first("learn-moments");
        first.input.exemplars = sample.input.exemplars;
        return first.run();
    }();
    EXPECT_EQ(modelOf(both)->arrays, modelOf(learned)->arrays);
    EXPECT_FALSE(samePixels(both.synthesis.image, learned.synthesis.image));
    const std::vector<double> drawn = channelMeans(both.synthesis.image);
    const std::vector<double>& mean = modelOf(both)->values<double>("mean", {3});
    for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(drawn[c], mean[c], 0.03); // 3840 pixels, a deviation of less than 0.3

    sample.input.steps[0].parameters = {{"spread", 0}};
    EXPECT_NEAR(valueRange(sample.run().synthesis.image).largest, *std::max_element(mean.begin(), mean.end()),
                1e-6)
        << "the first method's settings reach the second through the model";
}

TEST(Pipeline, RefusesAModelFromAFileWhereTheMethodBeforeMakesOne) {
    DoorRun sample("learn-moments");
    sample.input.steps.push_back({"draw-moments", {}});
    sample.input.inputs["moments"] = {load(kMoments, writeMoments(sample))};
    EXPECT_THAT([&] { planRun(sample.input); },
                usageRefusal("moments", "Draw colour moments", "Learn colour moments", "leave one"));
}

TEST(Pipeline, LinksWhatAModelIsOf) {
    const MethodInfo &learn = findMethod("learn-moments").info(), &draw = findMethod("draw-moments").info();
    const std::vector<PortLink> links = linksBetween(learn, draw);
    ASSERT_EQ(links.size(), 1U);
    EXPECT_EQ(links.front().from, "moments");
    EXPECT_TRUE(linksBetween(draw, learn).empty());
    EXPECT_TRUE(linksBetween(findMethod("solid-noise").info(), draw).empty());
}

TEST(Pipeline, HandsAVolumeOn) {
    DoorRun sample("solid-noise");
    sample.input.steps.push_back({"bend-by-volume", {{"depth", 7}}});
    const Result bent = sample.run();
    ASSERT_NE(volumeOf(bent), nullptr);
    TestContext context;
    const Volume row = volumeOf(bent)->sample({0, 9, 7, {64, 1, 1}}, context);
    const Image& bark = *sample.input.exemplars.front().image.image;
    for (int x = 0; x < 64; ++x) {
        const int at = static_cast<int>(std::lround(x + 10 * static_cast<double>(row(x, 0, 0, 0))));
        ASSERT_EQ(bent.synthesis.image(x, 9, 1), bark(((at % 48) + 48) % 48, 9, 1)) << x;
    }
}

TEST(PlanRun, RefusesAVolumeThatDoesNotReachFarEnough) {
    DoorRun sample("bend-by-volume");
    sample.input.inputs["volume"] = {
        load({.id = "volume", .title = "", .help = "", .kind = AssetKind::Volume},
             writeSolid(sample.folder, "v.json", sampleVolume({70, 59, 3}, 1)))};
    EXPECT_THAT([&] { planRun(sample.input); }, usageRefusal("y 0 to 58", "y 0 to 59"));
    sample.input.size = {70, 59};
    EXPECT_NO_THROW(planRun(sample.input));
    sample.input.steps.front().parameters = {{"depth", 3}};
    EXPECT_THAT([&] { planRun(sample.input); }, usageRefusal("z 0 to 2", "z 3 to 3"));
}

TEST(KeptBox, IsAllOfWhatEndsAPeriodOrAsMuchAsThePictureShows) {
    const auto dense = [](DenseSource::Edge edge) {
        return DenseSource(sampleVolume({6, 5, 4}, 1), edge, -3, 2, 9);
    };
    EXPECT_EQ(keptBox(dense(DenseSource::Edge::Ends), {64, 64}, 100), (Box{-3, 2, 9, {6, 5, 4}}));
    EXPECT_EQ(keptBox(dense(DenseSource::Edge::Repeats), {64, 64}, 100), (Box{0, 0, 0, {6, 5, 4}}));
    const FunctionSource endless([](auto, auto, auto, int) { return 0.0; });
    EXPECT_EQ(keptBox(endless, {64, 48}, 1 << 22), (Box{0, 0, 0, {64, 48, 48}}));
    EXPECT_EQ(keptBox(endless, {64, 48}, 64 * 48 * 7 + 1), (Box{0, 0, 0, {64, 48, 7}}));
    EXPECT_EQ(keptBox(endless, {60000, 4}, 10), (Box{0, 0, 0, {512, 4, 1}}));
}

TEST(ResultFolder, GivesModelsVolumesAndMeshesBack) {
    DoorRun sample("solid-noise");
    auto result = std::make_shared<Result>(sample.run());
    auto model = std::make_shared<Model>();
    model->kind = "made-up";
    model->arrays["a"] = {{2}, std::vector<float>{1.5F, -2}};
    Assets& outputs = result->synthesis.outputs;
    const auto dense =
        std::make_shared<const DenseSource>(sampleVolume({6, 5, 4}, 3), DenseSource::Edge::Repeats);
    outputs.add("made-up", std::shared_ptr<const Model>(model));
    outputs.add("block", std::shared_ptr<const VolumeSource>(dense));
    outputs.add("surface", std::shared_ptr<const Mesh>(triangle()));
    outputs.add("heights", std::make_shared<const Image>(constant({3, 2}, 1, -4.5F)));
    const ResultEntry entry = entryFor(*result, false);
    EXPECT_EQ(entry.outputs.size(), 5U);
    EXPECT_GT(entry.bytes, Volume::bytesFor({6, 5, 4}, 3)) << "what is in memory counts";
    const ResultFolder folder(sample.folder / "results");
    folder.write(entry, *result);

    const ResultFolder::Scan found = folder.scan();
    ASSERT_EQ(found.entries.size(), 1U);
    EXPECT_EQ(found.entries.front().outputs.back().size, entry.outputs.back().size);
    const auto again = folder.read(found.entries.front()).result;
    const Assets& read = again->synthesis.outputs;
    EXPECT_EQ(*read.first<Model>("made-up"), *model);
    EXPECT_EQ(read.first<Mesh>("surface")->positions, triangle()->positions);
    EXPECT_TRUE(samePixels(*read.image("heights"), constant({3, 2}, 1, -4.5F)));
    TestContext context;
    const Box wide{-7, 1, 3, {20, 9, 11}};
    EXPECT_TRUE(
        sameVoxels(read.first<VolumeSource>("block")->sample(wide, context), dense->sample(wide, context)))
        << "it still repeats";
    const Box kept{0, 0, 0, {64, 60, 60}};
    EXPECT_EQ(volumeOf(*again)->bounds(), kept);
    EXPECT_TRUE(
        sameVoxels(volumeOf(*again)->sample(kept, context), volumeOf(*result)->sample(kept, context)));
    EXPECT_TRUE(samePixels(again->synthesis.image, result->synthesis.image));

    fs::remove(folder.of(entry) / "output-5.raw");
    fs::remove(folder.of(entry) / "output-1.raw");
    EXPECT_THROW(folder.read(entry), Error);
}

namespace {

/// A result of a made-up method that gives something of every kind.
std::shared_ptr<Result> resultOfEverything() {
    struct Settings {};
    const auto given = [](const char* id, AssetKind kind) {
        return Port{.id = id, .title = id, .help = "", .kind = kind, .least = 1};
    };
    static const Method everything =
        named("everything",
              method<Settings>(
                  {.title = "Everything",
                   .summary = "",
                   .citation = "",
                   .takes = {ports::exemplar()},
                   .gives = {ports::image(), given("holes", AssetKind::Mask), given("layout", AssetKind::Map),
                             given("moments", AssetKind::Model), given("block", AssetKind::Volume),
                             given("surface", AssetKind::Mesh), given("other-surface", AssetKind::Mesh)}},
                  {}, +[](const Request&, const Settings&, JobContext&) { return Synthesis(); },
                  +[](const Request&, const Settings&) {},
                  +[](const Request&, const Settings&, int) { return Estimate(); }));
    auto result = std::make_shared<Result>();
    result->plan.steps.push_back({&everything, {}, {}});
    result->synthesis.image = constant({3, 2}, 3, 0.5F);
    Assets& outputs = result->synthesis.outputs;
    outputs.add("holes", std::make_shared<const Image>(constant({3, 2}, 1, 1)));
    outputs.add("layout", std::make_shared<const PositionMap>(Size{3, 2}, std::vector<Size>{{4, 4}}));
    auto model = std::make_shared<Model>();
    model->kind = "moments";
    outputs.add("moments", std::shared_ptr<const Model>(model));
    outputs.add("block", std::shared_ptr<const VolumeSource>(std::make_shared<DenseSource>(
                             sampleVolume({2, 2, 2}, 1), DenseSource::Edge::Ends)));
    outputs.add("surface", triangle());
    outputs.add("other-surface", triangle());
    return result;
}

Port portFor(const char* id, AssetKind kind) {
    return {.id = id, .title = id, .help = "", .kind = kind};
}

} // namespace

TEST(AssetFor, FindsWhatAResultHasOfThePortsKind) {
    const std::shared_ptr<Result> result = resultOfEverything();
    const Assets& outputs = result->synthesis.outputs;
    const auto isOutput = [&](const Port& port, const char* id) {
        const std::optional<Asset> found = assetFor(result, port);
        return found && *found == outputs.at(id).front();
    };
    EXPECT_EQ(
        std::get<std::shared_ptr<const Image>>(*assetFor(result, portFor("target", AssetKind::Image))).get(),
        &result->synthesis.image);
    EXPECT_TRUE(isOutput(portFor("target-holes", AssetKind::Mask), "holes"));
    EXPECT_TRUE(isOutput(portFor("places", AssetKind::Map), "layout"));
    EXPECT_TRUE(isOutput(portFor("moments", AssetKind::Model), "moments"));
    EXPECT_TRUE(isOutput(portFor("solid", AssetKind::Volume), "block"));
    EXPECT_TRUE(isOutput(portFor("surface", AssetKind::Mesh), "surface")) << "its own name comes first";
    EXPECT_TRUE(isOutput(portFor("body", AssetKind::Mesh), "other-surface")) << "else the first";
    EXPECT_FALSE(assetFor(result, portFor("network", AssetKind::Model))) << "a model of another kind";
}

TEST(AssetFor, PrefersThePositionMapAndFindsNothingInAPicture) {
    const std::shared_ptr<Result> result = resultOfEverything();
    result->synthesis.map = PositionMap({3, 2}, {{4, 4}});
    result->synthesis.mapKind = MapKind::Exact;
    const Port places = portFor("places", AssetKind::Map);
    EXPECT_EQ(std::get<std::shared_ptr<const PositionMap>>(*assetFor(result, places)).get(),
              &result->synthesis.map);
    result->synthesis.outputs = {};
    result->synthesis.mapKind = MapKind::None;
    for (const AssetKind kind :
         {AssetKind::Mask, AssetKind::Map, AssetKind::Model, AssetKind::Volume, AssetKind::Mesh})
        EXPECT_FALSE(assetFor(result, portFor("moments", kind))) << kindId(kind);
}

TEST(ExportResult, WritesModelsWithTheirRecipe) {
    const DoorRun sample("learn-moments");
    const Result result = sample.run();
    const TemporaryFolder out;
    ExportOptions options;
    options.image = out / "made.png";
    options.outputs["moments"] = out / "made_moments.safetensors";
    std::set<fs::path> written;
    for (const ExportEntry& entry : exportResult(result, options))
        written.insert(entry.path);
    EXPECT_EQ(written,
              (std::set<fs::path>{out / "made.png", out / "made.json", out / "made_moments.safetensors"}));
    const Model model = readModel(out / "made_moments.safetensors");
    EXPECT_EQ(model.arrays, modelOf(result)->arrays);
    EXPECT_EQ(model.exemplarHashes, std::vector<std::string>{sample.input.exemplars[0].image.hash});
    EXPECT_EQ(Recipe::fromJson(model.recipe, out.path()).toJson("/"), result.plan.recipe.toJson("/"));
    const Json outputs = Json::parse(readText(out / "made.json")).at("outputs");
    EXPECT_EQ(outputs.at(1),
              (Json{{"file", "made_moments.safetensors"}, {"content", "model"}, {"output", "moments"}}));
    const Json report = Json::parse(reportJson(result, out.path())).at("outputs").at(0);
    EXPECT_EQ(report.at("sha1"), modelOf(result)->hash());
    EXPECT_EQ(report.at("size"), "12 numbers, 96 B");
}

TEST(ExportResult, WritesVolumesRawOrAsSlices) {
    const DoorRun sample("solid-noise");
    const Result result = sample.run();
    const Box box = keptBox(*volumeOf(result), {64, 60}, 1 << 22);
    TestContext context;
    const Volume volume = volumeOf(result)->sample(box, context);
    for (const auto& [name, read, step] :
         {std::tuple("made_volume.json", "made_volume.json", 0.0),
          std::tuple("made_volume.png", "made_volume-0007.png", 1.0 / 65535)}) {
        const TemporaryFolder out;
        ExportOptions options;
        options.image = out / "made.png";
        options.outputs["volume"] = out / name;
        std::set<fs::path> announced;
        for (const ExportEntry& entry : exportEntries(result, options))
            announced.insert(entry.path);
        EXPECT_EQ(out.entries(), 0);
        exportResult(result, options);
        EXPECT_EQ(announced,
                  std::set<fs::path>(fs::directory_iterator(out.path()), fs::directory_iterator()));
        const LoadedVolume again = readVolume(out / read, context);
        ASSERT_EQ(again.source->volume().size(), box.size);
        for (int c = 0; c < 3; ++c) {
            const float made = volume(5, 6, 7, c), held = step > 0 ? std::clamp(made, 0.0F, 1.0F) : made;
            EXPECT_NEAR(again.source->volume()(5, 6, 7, c), held, step);
        }
        EXPECT_EQ(Recipe::fromJson(again.recipe, out.path()).seed, result.plan.recipe.seed);
    }
}

TEST(ExportResult, RefusesOutputsThatAreNotThereAndNamesTwice) {
    const DoorRun sample("solid-noise");
    const Result result = sample.run();
    const TemporaryFolder out;
    ExportOptions options;
    options.image = out / "made.png";
    options.outputs["volume"] = out / "made.json"; // the recipe's
    EXPECT_THAT([&] { exportResult(result, options); }, usageRefusal("made.json", "same file"));
    options.outputs = {{"moments", out / "m.safetensors"}};
    EXPECT_THAT([&] { exportResult(result, options); }, usageRefusal("no output moments"));
    options.outputs = {{"volume", out / "none" / "v.json"}};
    EXPECT_THAT([&] { exportResult(result, options); }, refusal("none"));
    EXPECT_EQ(out.entries(), 0);
    EXPECT_THAT([&] { checkOutput(result.plan, "image", out / "v.json"); },
                usageRefusal("Solid noise", "image", "volume"));
    EXPECT_THAT([&] { checkOutput(planRun(SampleRun().input), "volume", out / "v.json"); },
                usageRefusal("Image quilting", "volume", "nothing beside"));
    EXPECT_THAT([&] { checkOutput(planRun(DoorRun("learn-moments").input), "moments", out / "m.txt"); },
                usageRefusal("m.txt", "a model", ".safetensors"));
}

TEST(Recipe, OfAModelRunsAgainAndNoticesAnotherFile) {
    DoorRun sample("draw-moments");
    const fs::path file = writeMoments(sample);
    sample.input.inputs["moments"] = {load(kMoments, file)};
    const Result first = sample.run();
    const Recipe recipe = Recipe::fromJson(first.plan.recipe.toJson("/"), "/");
    EXPECT_EQ(recipe.inputs.at("moments").front().hash, fileHash(file));
    DoorRun again("draw-moments");
    std::vector<fs::path> changed;
    const auto note = [&](const fs::path& path) { changed.push_back(path); };
    again.input = loadRecipe(recipe, note);
    EXPECT_TRUE(samePixels(again.run().synthesis.image, first.synthesis.image));
    EXPECT_TRUE(changed.empty());
    Model other = readModel(file);
    other.notes["by"] = "hand";
    writeModel(file, other);
    loadRecipe(recipe, note);
    EXPECT_EQ(changed, std::vector<fs::path>{file});
}

TEST(Session, PacksModelsAndAllFilesOfAVolume) {
    const DoorRun sample("draw-moments");
    const fs::path model = writeMoments(sample);
    fs::create_directory(sample.folder / "slices");
    TestContext context;
    writeVolume(sample.folder / "slices" / "v.png",
                DenseSource(sampleVolume({5, 4, 3}, 1), DenseSource::Edge::Ends), {0, 0, 0, {5, 4, 3}}, {},
                context);
    Session session;
    session.settings.steps = {{"draw-moments", {}}, {"bend-by-volume", {}}};
    session.settings.size = {64, 64};
    const fs::path slice = sample.folder / "slices" / "v-0001.png";
    session.settings.inputs["moments"] = {{model, "", assetHash(AssetKind::Model, model)}};
    session.settings.inputs["volume"] = {{slice, "", assetHash(AssetKind::Volume, slice)}};
    const TemporaryFolder target;
    packSession(target / "given.texloom", session);
    fs::remove_all(sample.folder / "slices");
    const Session packed = readSession(target / "given.texloom");
    const SessionFiles files = checkFiles(packed);
    EXPECT_TRUE(files.missing.empty() && files.changed.empty());
    const fs::path place = packed.settings.inputs.at("volume").front().path;
    EXPECT_EQ(place, target / "given_files" / "v-0000" / "v-0001.png");
    EXPECT_EQ(readVolume(place, context).source->volume().size(), (VolumeSize{5, 4, 3}));
    EXPECT_EQ(packSession(target / "given.texloom", packed).toJson("/"), packed.toJson("/"));
    writeText(target / "given_files" / "v-0000" / "v-0002.png", "another");
    EXPECT_EQ(checkFiles(packed).changed, std::vector<fs::path>{place});
}

} // namespace texloom::test
