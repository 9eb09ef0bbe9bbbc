#include "ui/material/material_files.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/color/color_pipeline.h"
#include "core/io/image_file.h"

#include <fmt/format.h>

#include <cstddef>
#include <numbers>
#include <vector>

namespace texloom::ui {

namespace {

namespace fs = std::filesystem;

constexpr int kSamples = 3;

Image pictureOf(const Scene& scene, const Look& look, JobContext& context) {
    Look fine = look;
    fine.samples = kSamples;
    Image picture = rendered(*scene.mesh, *scene.material, *scene.light, fine, scene.size, context);
    if (look.backdrop != Backdrop::Nothing) // then nothing shows through
        picture = Image(picture.view().channelRange(0, 3));
    return picture;
}

void write(Image picture, const fs::path& path, JobContext& context) {
    WriteOptions options;
    options.check = [&context] { context.check(); };
    if (path.extension() == ".exr" || path.extension() == ".hdr") {
        options.depth = path.extension() == ".exr" ? Depth::Half : Depth::Float;
        options.space = "linear";
    } else {
        color::toWorking(picture, "linear");
    }
    writeImage(path, picture, options);
}

} // namespace

std::vector<fs::path> turnFiles(const fs::path& folder, int pictures) {
    std::vector<fs::path> files;
    for (int i = 0; i < pictures; ++i)
        files.push_back(folder / fmt::format("turn_{:04}.png", i));
    return files;
}

int writePicture(const Scene& scene, const fs::path& path, JobContext& context) {
    write(pictureOf(scene, scene.look, context), path, context);
    return 1;
}

int writeTurn(const Scene& scene, const fs::path& folder, int pictures, JobContext& context) {
    const std::vector<fs::path> files = turnFiles(folder, pictures);
    for (const fs::path& file : files)
        if (fs::exists(file))
            failUsage("{} already exists; choose a folder without pictures of an earlier turn.",
                      file.string());
    context.stage(1, TR("Writing a turn"));
    for (int i = 0; i < pictures; ++i) {
        Look look = scene.look;
        look.camera.turn +=
            2 * std::numbers::pi_v<float> * static_cast<float>(i) / static_cast<float>(pictures);
        write(pictureOf(scene, look, context), files[static_cast<std::size_t>(i)], context);
        context.progress((i + 1.0) / pictures);
    }
    return pictures;
}

} // namespace texloom::ui
