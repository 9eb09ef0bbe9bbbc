#pragma once

#include "core/volume/mesh.h"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace texloom {

/// Writes a mesh with a colour at each vertex: .ply (binary, red, green, blue as 8 bits), .obj (three numbers
/// behind each position, as many programs read them) or .glb (COLOR_0, linear light as glTF wants). Whole or
/// not at all.
/// @param colours red, green and blue of each vertex in the working space. @param recipe written as a
/// comment, or in glTF's asset.extras; empty for none.
/// @throws Error; UsageError where the name has another extension or there are not three numbers a vertex.
void writeColouredMesh(const std::filesystem::path& path, const Mesh& mesh, const std::vector<float>& colours,
                       const std::function<void()>& check = {}, const std::string& recipe = {});

/// Checks that a name has one of these extensions, before a long run. @throws UsageError
void checkColouredMeshFile(const std::filesystem::path& path);

} // namespace texloom
