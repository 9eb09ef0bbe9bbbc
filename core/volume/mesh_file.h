#pragma once

#include "core/job/job_context.h"
#include "core/volume/mesh.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

namespace texloom {

/// Longer files are refused.
inline constexpr std::uint64_t kLargestMeshFile = 2ULL << 30;

/// Reads OBJ, PLY (text or binary) and glTF 2 (.gltf or .glb), told apart by their first bytes. Of a scene
/// all surfaces become one mesh, each where its node puts it. Colours, materials and animations are not read,
/// and nothing that a file names but the buffers of a .gltf in its own folder.
/// @throws Error in one sentence if the file is missing, none of these or damaged, has no face with an area,
/// or more of anything than MeshBuilder allows.
Mesh readMesh(const std::filesystem::path& path, JobContext& context);

/// The files that readMesh() reads for this name: itself, and the buffers of a .gltf.
std::vector<std::filesystem::path> filesOfMesh(const std::filesystem::path& path);

/// Writes a mesh as a binary .ply, whole or not at all. readMesh() gives the same surface again, though its
/// vertices may come in another order. @param check called now and then; what it throws leaves no file.
/// @throws Error; UsageError where the name has another extension.
void writeMesh(const std::filesystem::path& path, const Mesh& mesh, const std::function<void()>& check = {});

} // namespace texloom
