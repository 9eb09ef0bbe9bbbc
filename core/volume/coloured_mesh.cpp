#include "core/volume/coloured_mesh.h"

#include "core/base/error.h"
#include "core/io/image_file.h"
#include "core/volume/point_colours.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace texloom {

namespace {

constexpr std::size_t kAskEvery = 1 << 16; ///< vertices between two questions whether to go on

/// Appends numbers as memory has them, which is little-endian (see raw_volume.cpp).
template <class T> void append(std::string& bytes, const T& number) {
    bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

void ask(const std::function<void()>& check, std::size_t i) {
    if (check && i % kAskEvery == 0)
        check();
}

std::uint8_t byteOf(float value) {
    return static_cast<std::uint8_t>(std::lround(255 * std::clamp(value, 0.0F, 1.0F)));
}

/// Comments end with their line; between two words of JSON a blank means the same.
std::string inOneLine(const std::string& recipe) {
    std::string line = recipe;
    for (char& letter : line)
        if (letter == '\n' || letter == '\r')
            letter = ' ';
    return line;
}

std::string plyOf(const Mesh& mesh, const std::vector<float>& colours, const std::string& recipe,
                  const std::function<void()>& check) {
    std::string bytes =
        fmt::format("ply\nformat binary_little_endian 1.0\ncomment Texloom {}\nelement vertex {}\n", recipe,
                    mesh.positions.size());
    for (const char* name : {"x", "y", "z", "nx", "ny", "nz"})
        bytes += fmt::format("property float {}\n", name);
    for (const char* name : {"red", "green", "blue"})
        bytes += fmt::format("property uchar {}\n", name);
    bytes += fmt::format("element face {}\nproperty list uchar int vertex_indices\nend_header\n",
                         mesh.triangles.size());
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        ask(check, i);
        for (const Eigen::Vector3f& vector : {mesh.positions[i], mesh.normals[i]})
            for (const float coordinate : vector)
                append(bytes, coordinate);
        for (std::size_t c = 0; c < 3; ++c)
            append(bytes, byteOf(colours[3 * i + c]));
    }
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        ask(check, i);
        append(bytes, std::uint8_t{3});
        for (const std::uint32_t vertex : mesh.triangles[i])
            append(bytes, vertex);
    }
    return bytes;
}

std::string objOf(const Mesh& mesh, const std::vector<float>& colours, const std::string& recipe,
                  const std::function<void()>& check) {
    std::string text = fmt::format("# Texloom {}\n", recipe);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        ask(check, i);
        const Eigen::Vector3f& p = mesh.positions[i];
        text += fmt::format("v {} {} {} {:.5f} {:.5f} {:.5f}\n", p.x(), p.y(), p.z(), colours[3 * i],
                            colours[3 * i + 1], colours[3 * i + 2]);
    }
    for (const Eigen::Vector3f& n : mesh.normals)
        text += fmt::format("vn {} {} {}\n", n.x(), n.y(), n.z());
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        ask(check, i);
        const Mesh::Triangle& t = mesh.triangles[i];
        text += fmt::format("f {}//{} {}//{} {}//{}\n", t[0] + 1, t[0] + 1, t[1] + 1, t[1] + 1, t[2] + 1,
                            t[2] + 1);
    }
    return text;
}

std::string glbOf(const Mesh& mesh, const std::vector<float>& colours, const std::string& recipe,
                  const std::function<void()>& check) {
    using Json = nlohmann::json;
    const Image light = lightOfPoints(colours, 3); // which is what COLOR_0 holds
    std::string data;
    Json views = Json::array(), accessors = Json::array();
    const auto close = [&](std::size_t begin, int target, int component, const char* type,
                           std::size_t count) {
        views.push_back(
            {{"buffer", 0}, {"byteOffset", begin}, {"byteLength", data.size() - begin}, {"target", target}});
        accessors.push_back({{"bufferView", views.size() - 1},
                             {"componentType", component},
                             {"count", count},
                             {"type", type}});
    };
    constexpr int kFloat = 5126, kUnsigned = 5125, kVertices = 34962, kIndices = 34963;
    const std::size_t count = mesh.positions.size();
    for (const auto* vectors : {&mesh.positions, &mesh.normals}) {
        const std::size_t begin = data.size();
        for (std::size_t i = 0; i < count; ++i) {
            ask(check, i);
            for (const float coordinate : (*vectors)[i])
                append(data, coordinate);
        }
        close(begin, kVertices, kFloat, "VEC3", count);
    }
    const Mesh::Bounds bounds = mesh.bounds();
    accessors[0]["min"] = {bounds.lowest.x(), bounds.lowest.y(), bounds.lowest.z()};
    accessors[0]["max"] = {bounds.highest.x(), bounds.highest.y(), bounds.highest.z()};
    std::size_t begin = data.size();
    for (std::size_t i = 0; i < count; ++i)
        for (int c = 0; c < 3; ++c)
            append(data, std::clamp(light(static_cast<int>(i), 0, c), 0.0F, 1.0F));
    close(begin, kVertices, kFloat, "VEC3", count);
    begin = data.size();
    for (const Mesh::Triangle& triangle : mesh.triangles)
        for (const std::uint32_t vertex : triangle)
            append(data, vertex);
    close(begin, kIndices, kUnsigned, "SCALAR", 3 * mesh.triangles.size());
    const Json primitive = {{"attributes", {{"POSITION", 0}, {"NORMAL", 1}, {"COLOR_0", 2}}}, {"indices", 3}};
    Json head;
    head["asset"] = {{"version", "2.0"}, {"generator", "Texloom"}};
    if (!recipe.empty())
        head["asset"]["extras"]["texloom"] = recipe;
    head["scene"] = 0;
    head["scenes"][0]["nodes"] = Json::array({0});
    head["nodes"][0]["mesh"] = 0;
    head["meshes"][0]["primitives"] = Json::array({primitive});
    head["buffers"][0]["byteLength"] = data.size();
    head["bufferViews"] = views;
    head["accessors"] = accessors;
    std::string text = head.dump();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    std::string bytes = "glTF";
    append(bytes, std::uint32_t{2});
    append(bytes, static_cast<std::uint32_t>(28 + text.size() + data.size()));
    append(bytes, static_cast<std::uint32_t>(text.size()));
    bytes += "JSON" + text;
    append(bytes, static_cast<std::uint32_t>(data.size()));
    bytes.append("BIN\0", 4);
    return bytes + data;
}

} // namespace

void checkColouredMeshFile(const std::filesystem::path& path) {
    const std::string extension = path.extension().string();
    if (extension != ".ply" && extension != ".obj" && extension != ".glb")
        failUsage("{}: meshes with colours are written as .ply, .obj or .glb.", path.string());
}

void writeColouredMesh(const std::filesystem::path& path, const Mesh& mesh, const std::vector<float>& colours,
                       const std::function<void()>& check, const std::string& recipe) {
    checkColouredMeshFile(path);
    if (colours.size() != 3 * mesh.positions.size())
        failUsage("{}: {} vertices want three numbers each, and there are {}.", path.string(),
                  mesh.positions.size(), colours.size());
    const std::string extension = path.extension().string();
    writeText(path, extension == ".ply"   ? plyOf(mesh, colours, inOneLine(recipe), check)
                    : extension == ".obj" ? objOf(mesh, colours, inOneLine(recipe), check)
                                          : glbOf(mesh, colours, recipe, check));
}

} // namespace texloom
