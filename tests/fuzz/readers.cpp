#include "tests/fuzz/readers.h"

#include "core/base/error.h"
#include "core/io/image_file.h"
#include "core/io/map_file.h"
#include "core/io/model_file.h"
#include "core/io/recipe.h"
#include "core/io/zip_file.h"
#include "core/network/descriptor.h"
#include "core/network/weights_file.h"
#include "core/session/batch/batch.h"
#include "core/session/preset.h"
#include "core/session/run/checkpoint_file.h"
#include "core/session/session.h"
#include "core/volume/mesh_file.h"
#include "core/volume/volume_file.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/volumes.h"

#include <algorithm>
#include <fstream>
#include <stdexcept>
#include <utility>

namespace texloom::test {

namespace {

namespace fs = std::filesystem;

constexpr std::int64_t kMostPixels = 1 << 18;

void store(const fs::path& path, std::string_view bytes) {
    std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

/// Reads the input as a file of this name.
Reader asFile(const char* name, std::function<void(const fs::path&)> read) {
    return [name, read = std::move(read)](std::string_view bytes) {
        static const TemporaryFolder folder;
        store(folder / name, bytes);
        read(folder / name);
    };
}

void readAsImage(const fs::path& path) {
    readImageInfo(path);
    readImage(path, {.largestPixels = kMostPixels});
}

void readAsMap(const fs::path& path) {
    readImage(path, {.largestPixels = kMostPixels}); // refuses what would take much memory
    readPositionMap(path, {{40, 31}});
}

void readAsVolume(const fs::path& path) {
    TestContext context(1);
    readVolume(path, context, {{}, kMostPixels});
}

void readAsMesh(const fs::path& path) {
    TestContext context(1);
    readMesh(path, context);
}

/// What was read and written must be read as the same again.
template <class Read, class Write>
void expectKept(std::string_view bytes, const Read& read, const Write& write) {
    const auto first = read(bytes);
    const std::string written = write(first);
    std::string again;
    try {
        again = write(read(written));
    } catch (const Error& error) {
        throw std::logic_error("what was written is refused: " + std::string(error.what()) + "\n" + written);
    }
    if (again != written)
        throw std::logic_error("what was written is read as something else:\n" + written + "\n" + again);
}

void readAsRecipe(std::string_view bytes) {
    expectKept(
        bytes, [](std::string_view text) { return Recipe::fromJson(text, "/a"); },
        [](const Recipe& recipe) { return recipe.toJson("/a"); });
}

void readAsSession(std::string_view bytes) {
    expectKept(
        bytes, [](std::string_view text) { return Session::fromJson(text, "/a"); },
        [](const Session& session) { return session.toJson("/a"); });
}

void readAsPreset(std::string_view bytes) {
    expectKept(
        bytes, [](std::string_view text) { return Preset::fromJson("a", text); },
        [](const Preset& preset) { return preset.toJson(); });
}

void readAsModel(std::string_view bytes) {
    expectKept(
        bytes, [](std::string_view text) { return modelFromBytes(text, "m.safetensors"); },
        [](const Model& model) { return model.bytes(); });
}

void readAsDescriptor(std::string_view bytes) {
    const Descriptor read = Descriptor::from(modelFromBytes(bytes, "d.safetensors"));
    if (4 * read.parameters() > bytes.size())
        throw std::logic_error("more weights than the file holds");
    expectKept(
        read.model().bytes(),
        [](std::string_view text) { return Descriptor::from(modelFromBytes(text, "d.safetensors")); },
        [](const Descriptor& descriptor) { return descriptor.model().bytes(); });
}

/// The first and last items of a batch, which are made when they are asked for.
void readAsBatch(std::string_view bytes) {
    constexpr std::size_t kMost = 16;
    const Batch batch = Batch::fromJson(bytes, "/a");
    batch.sources();
    for (std::size_t i = 0; i < std::min(batch.size(), kMost); ++i)
        for (const std::size_t index : {i, batch.size() - 1 - i})
            batch.item(index).whole();
}

void readAsCheckpoint(const fs::path& path) {
    const CheckpointFile file = readCheckpoint(path);
    writeCheckpoint(path, file.recipe, file.checkpoint);
    if (readCheckpoint(path).checkpoint.state != file.checkpoint.state)
        throw std::logic_error("a checkpoint's state was not kept");
}

/// A session up to the first zero, behind which stand the bytes of the picture that it may have packed with
/// it: looked through, moved and packed once more, as the window does with one that it is given.
void readAsPacked(std::string_view bytes) {
    const TemporaryFolder folder;
    const std::size_t end = std::min(bytes.find('\0'), bytes.size());
    fs::create_directory(folder / "work_files");
    store(folder / "work_files/bark.png", bytes.substr(std::min(end + 1, bytes.size())));
    store(folder / "work.texloom", bytes.substr(0, end));
    Session session = readSession(folder / "work.texloom");
    const SessionFiles files = checkFiles(session);
    for (const fs::path& missing : files.missing)
        relocate(session, missing, folder / "work_files/bark.png");
    const Session packed = packSession(folder / "again.texloom", session, folder.path());
    if (readSession(folder / "again.texloom").toJson("/") != packed.toJson("/"))
        throw std::logic_error("a packed session is not as it was written");
    for (const fs::path& changed : files.changed)
        leaveOut(session, changed);
    readRun(folder / "again.texloom");
}

void readAsArchive(const fs::path& path) {
    constexpr ZipLimits kLimits{64, 1U << 20U};
    const fs::path to = path.parent_path() / "unpacked";
    const auto any = [](const fs::path&) { return true; };
    const std::vector<fs::path> files = unzip(path, to, any, kLimits);
    for (const fs::path& file : files)
        if (file.parent_path() != to || !fs::remove(file))
            throw std::logic_error("an archive put a file where none belongs: " + file.string());
}

void readAsWeights(const fs::path& path) {
    store(fs::path(path).replace_extension(".bin"), std::string(56 * sizeof(float), '\0'));
    importWeights(path, {});
}

} // namespace

const std::map<std::string, Reader, std::less<>>& readers() {
    static const std::map<std::string, Reader, std::less<>> known = {
        {"archive", asFile("a.zip", readAsArchive)},
        {"batch", readAsBatch},
        {"checkpoint", asFile("a.checkpoint", readAsCheckpoint)},
        {"descriptor", readAsDescriptor},
        {"exr", asFile("a.exr", readAsImage)},
        {"gltf", asFile("a.gltf", readAsMesh)},
        {"hdr", asFile("a.hdr", readAsImage)},
        {"jpeg", asFile("a.jpg", readAsImage)},
        {"map", asFile("a.exr", readAsMap)},
        {"model", readAsModel},
        {"obj", asFile("a.obj", readAsMesh)},
        {"packed", readAsPacked},
        {"ply", asFile("a.ply", readAsMesh)},
        {"png", asFile("a.png", readAsImage)},
        {"preset", readAsPreset},
        {"recipe", readAsRecipe},
        {"session", readAsSession},
        {"tiff", asFile("a.tif", readAsImage)},
        {"volume", asFile("a.json", readAsVolume)},
        {"weights", asFile("a.json", readAsWeights)}};
    return known;
}

} // namespace texloom::test
