#pragma once

#include "core/volume/mesh_builder.h"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace texloom {

/// The formats of readMesh(), each given a file's bytes. They add to `builder`; `path` is for messages, and
/// the folder of a .gltf's buffers. @throws Error
void readObj(const std::filesystem::path& path, const std::string& bytes, MeshBuilder& builder);
void readPly(const std::filesystem::path& path, const std::string& bytes, MeshBuilder& builder);
void readGltf(const std::filesystem::path& path, const std::string& bytes, MeshBuilder& builder);

/// The files in its own folder that a .gltf names as its buffers.
std::vector<std::filesystem::path> buffersOfGltf(const std::filesystem::path& path, const std::string& bytes);

} // namespace texloom
