// One reader of files, fed by libFuzzer, which looks for inputs that reach new code. TEXLOOM_FUZZ_READER says
// which; hour.sh runs them all. Whatever the input, it is read or refused by a texloom::Error.

#include "core/base/error.h"
#include "core/io/image_file.h"
#include "core/io/map_file.h"
#include "core/io/model_file.h"
#include "core/io/recipe.h"
#include "core/volume/mesh_file.h"
#include "core/volume/volume_file.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/volumes.h"

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace texloom::test {

namespace {

namespace fs = std::filesystem;

constexpr std::int64_t kLargestPixels = 1 << 18;

/// Reads the input as a file of this name.
std::function<void(std::string_view)> asFile(const char* name, std::function<void(const fs::path&)> read) {
    return [name, read = std::move(read)](std::string_view bytes) {
        static const TemporaryFolder folder;
        const fs::path path = folder / name;
        std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        read(path);
    };
}

void readAsImage(const fs::path& path) {
    readImageInfo(path);
    readImage(path, {.largestPixels = kLargestPixels});
}

void readAsMap(const fs::path& path) {
    readImage(path, {.largestPixels = kLargestPixels}); // refuses what would take much memory
    readPositionMap(path, {{40, 31}});
}

void readAsVolume(const fs::path& path) {
    TestContext context(1);
    readVolume(path, context, {{}, kLargestPixels});
}

void readAsMesh(const fs::path& path) {
    TestContext context(1);
    readMesh(path, context);
}

using Readers = std::map<std::string_view, std::function<void(std::string_view)>>;

const Readers& readers() {
    static const Readers known = {
        {"png", asFile("a.png", readAsImage)},
        {"jpeg", asFile("a.jpg", readAsImage)},
        {"tiff", asFile("a.tif", readAsImage)},
        {"exr", asFile("a.exr", readAsImage)},
        {"hdr", asFile("a.hdr", readAsImage)},
        {"map", asFile("a.exr", readAsMap)},
        {"volume", asFile("a.json", readAsVolume)},
        {"obj", asFile("a.obj", readAsMesh)},
        {"ply", asFile("a.ply", readAsMesh)},
        {"gltf", asFile("a.gltf", readAsMesh)},
        {"recipe", [](std::string_view bytes) { Recipe::fromJson(bytes, "/a"); }},
        {"model", [](std::string_view bytes) { modelFromBytes(std::string(bytes), "m.safetensors"); }}};
    return known;
}

const std::function<void(std::string_view)>& chosenReader() {
    const char* const asked = std::getenv("TEXLOOM_FUZZ_READER");
    const auto found = readers().find(asked ? asked : "");
    if (found != readers().end())
        return found->second;
    std::fputs("TEXLOOM_FUZZ_READER is one of:", stderr);
    for (const auto& [name, read] : readers())
        std::fprintf(stderr, " %s", std::string(name).c_str());
    std::fputs("\n", stderr);
    std::exit(2);
}

} // namespace

} // namespace texloom::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const auto& read = texloom::test::chosenReader();
    try {
        read(std::string_view(reinterpret_cast<const char*>(data), size));
    } catch (const texloom::Error&) {
        return 0;
    }
    return 0;
}
