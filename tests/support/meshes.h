#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace texloom::test {

/// The cube from −1 to 1, by the name of a file: as OBJ, as PLY in text and in both byte orders, and as glTF
/// in text and in binary.
std::map<std::string, std::string> cubes();

/// Positions and then 32-bit indices, as the buffer of a glTF file.
std::string gltfBytes(const std::vector<Eigen::Vector3f>& positions,
                      const std::vector<std::uint32_t>& indices);

/// A .gltf whose buffer is at `uri`: one mesh, and these nodes in one scene.
std::string gltfWith(const std::string& uri, std::size_t bytes, std::size_t positions, std::size_t indices,
                     const std::string& nodes);

/// The same with the buffer in it. @param indices as JSON.
std::string gltfText(const std::vector<Eigen::Vector3f>& positions, const std::string& indices,
                     const std::string& nodes);

} // namespace texloom::test
