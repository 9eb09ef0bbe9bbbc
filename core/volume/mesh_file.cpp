#include "core/volume/mesh_file.h"

#include "core/base/error.h"
#include "core/io/image_file.h"
#include "core/volume/mesh_formats.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <string_view>

namespace texloom {

namespace {

/// Whether the first word of a text is one that OBJ files begin lines with.
bool looksLikeObj(std::string_view text) {
    constexpr std::size_t kLook = 1 << 16;
    text = text.substr(0, kLook);
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        line.remove_prefix(std::min(line.find_first_not_of(" \t\r"), line.size()));
        if (line.starts_with("v ") || line.starts_with("v\t") || line.starts_with("vn ") ||
            line.starts_with("vt "))
            return true;
    }
    return false;
}

constexpr std::size_t kCheckEvery = 1 << 16; ///< elements written between two questions whether to go on

/// Puts the bytes of numbers one after the other, little-endian as memory is (see raw_volume.cpp).
class Bytes {
public:
    template <class T> void add(const T& number) {
        m_bytes.append(reinterpret_cast<const char*>(&number), sizeof(number));
    }
    void add(const Eigen::Vector3f& vector) {
        for (const float coordinate : vector)
            add(coordinate);
    }
    const std::string& text() const { return m_bytes; }

private:
    std::string m_bytes;
};

std::string plyHead(const Mesh& mesh) {
    std::string head = "ply\nformat binary_little_endian 1.0\ncomment Texloom\n";
    head += fmt::format("element vertex {}\n", mesh.positions.size());
    for (const char* name : {"x", "y", "z", "nx", "ny", "nz"})
        head += fmt::format("property float {}\n", name);
    if (!mesh.uvs.empty())
        head += "property float s\nproperty float t\n";
    head += fmt::format("element face {}\n", mesh.triangles.size());
    return head + "property list uchar int vertex_indices\nend_header\n";
}

} // namespace

std::vector<std::filesystem::path> filesOfMesh(const std::filesystem::path& path) {
    std::vector<std::filesystem::path> files = {path};
    if (path.extension() != ".gltf")
        return files;
    try {
        const std::vector<std::filesystem::path> buffers =
            buffersOfGltf(path, readText(path, kLargestMeshFile));
        files.insert(files.end(), buffers.begin(), buffers.end());
    } catch (const Error&) { // it is not there, or must not be read: its reader says so
    }
    return files;
}

void writeMesh(const std::filesystem::path& path, const Mesh& mesh, const std::function<void()>& check) {
    if (path.extension() != ".ply")
        failUsage("{}: meshes are written as .ply.", path.string());
    const auto checkAt = [&check](std::size_t i) {
        if (check && i % kCheckEvery == 0)
            check();
    };
    Bytes bytes;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        checkAt(i);
        bytes.add(mesh.positions[i]);
        bytes.add(mesh.normals[i]);
        if (!mesh.uvs.empty()) {
            bytes.add(mesh.uvs[i].x());
            bytes.add(1 - mesh.uvs[i].y()); // PLY counts v from the bottom
        }
    }
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        checkAt(i);
        bytes.add(std::uint8_t{3});
        for (const std::uint32_t vertex : mesh.triangles[i])
            bytes.add(vertex);
    }
    writeText(path, plyHead(mesh) + bytes.text());
}

Mesh readMesh(const std::filesystem::path& path, JobContext& context) {
    const std::string bytes = readText(path, kLargestMeshFile);
    MeshBuilder builder(path, [&context] { context.check(); });
    const std::size_t first = std::min(bytes.find_first_not_of(" \t\r\n"), bytes.size());
    if (bytes.starts_with("ply"))
        readPly(path, bytes, builder);
    else if (bytes.starts_with("glTF") || bytes.compare(first, 1, "{") == 0)
        readGltf(path, bytes, builder);
    else if (looksLikeObj(bytes))
        readObj(path, bytes, builder);
    else
        fail("{} is not a mesh that Texloom reads (OBJ, PLY or glTF).", path.string());
    return builder.finish();
}

} // namespace texloom
