#include "ui/material/material_files.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/color/color_pipeline.h"
#include "core/io/image_file.h"

#include <fmt/format.h>

#include <numbers>

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

fs::path turnFile(const fs::path& folder, int number) {
    return folder / fmt::format("turn_{:04}.png", number);
}

} // namespace

int writePicture(const Scene& scene, const fs::path& path, JobContext& context) {
    write(pictureOf(scene, scene.look, context), path, context);
    return 1;
}

int writeTurn(const Scene& scene, const fs::path& folder, int pictures, JobContext& context) {
    for (int i = 0; i < pictures; ++i)
        if (fs::exists(turnFile(folder, i)))
            failUsage("{} already exists; choose a folder without pictures of an earlier turn.",
                      turnFile(folder, i).string());
    context.stage(1, TR("Writing a turn"));
    for (int i = 0; i < pictures; ++i) {
        Look look = scene.look;
        look.camera.turn +=
            2 * std::numbers::pi_v<float> * static_cast<float>(i) / static_cast<float>(pictures);
        write(pictureOf(scene, look, context), turnFile(folder, i), context);
        context.progress((i + 1.0) / pictures);
    }
    return pictures;
}

} // namespace texloom::ui
