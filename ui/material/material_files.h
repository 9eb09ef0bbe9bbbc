#pragma once

#include "core/render/render.h"

#include <filesystem>
#include <memory>
#include <vector>

namespace texloom::ui {

/// All that a picture of a material shows.
struct Scene {
    std::shared_ptr<const RenderMesh> mesh;
    std::shared_ptr<const MaterialTexture> material;
    std::shared_ptr<const Environment> light;
    Look look;
    Size size;
};

/// Writes a picture of a scene, with three samples along each side of a pixel; the extension says in which
/// format, and formats of real numbers keep the light as it is. @return 1, the number of files. @throws
/// Error, UsageError
int writePicture(const Scene& scene, const std::filesystem::path& path, JobContext& context);

/// turn_0000.png and so on: the files of a turn.
std::vector<std::filesystem::path> turnFiles(const std::filesystem::path& folder, int pictures);

/// Writes `pictures` of a whole turn around the mesh as turnFiles(); files of these names that
/// are in the folder already are refused before anything is written. @return their number. @throws Error,
/// UsageError
int writeTurn(const Scene& scene, const std::filesystem::path& folder, int pictures, JobContext& context);

} // namespace texloom::ui
