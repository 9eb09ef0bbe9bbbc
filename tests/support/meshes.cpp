#include "tests/support/meshes.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstring>

namespace texloom::test {

namespace {

using Eigen::Vector3f;
using Indices = std::vector<std::uint32_t>;

std::vector<Vector3f> corners() {
    std::vector<Vector3f> all;
    for (int i = 0; i < 8; ++i)
        all.emplace_back(static_cast<float>((i & 1) * 2 - 1), static_cast<float>((i >> 1 & 1) * 2 - 1),
                         static_cast<float>((i >> 2) * 2 - 1));
    return all;
}

/// Turning left, seen from outside.
const std::array<std::array<std::uint32_t, 4>, 6> kFaces = {
    {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};

template <class T> void append(std::string& bytes, T value, bool bigEnd) {
    std::array<char, sizeof(T)> raw{};
    std::memcpy(raw.data(), &value, sizeof(T));
    if (bigEnd)
        std::reverse(raw.begin(), raw.end());
    bytes.append(raw.data(), raw.size());
}

std::string obj() {
    std::string text = "# a cube\nmtllib none.mtl\no cube\n";
    for (const Vector3f& corner : corners())
        text += fmt::format("v {} {} {}\n", corner.x(), corner.y(), corner.z());
    for (const auto& face : kFaces)
        text += fmt::format("f {} {} {} {}\n", face[0] + 1, face[1] + 1, face[2] + 1, face[3] + 1);
    return text;
}

std::string plyHead(const char* format) {
    return fmt::format("ply\nformat {} 1.0\nelement vertex 8\nproperty float x\nproperty float y\nproperty "
                       "float z\nelement face 6\nproperty list uchar uint vertex_indices\nend_header\n",
                       format);
}

std::string plyText() {
    std::string text = plyHead("ascii");
    for (const Vector3f& corner : corners())
        text += fmt::format("{} {} {}\n", corner.x(), corner.y(), corner.z());
    for (const auto& face : kFaces)
        text += fmt::format("4 {} {} {} {}\n", face[0], face[1], face[2], face[3]);
    return text;
}

std::string plyBinary(bool bigEnd) {
    std::string bytes = plyHead(bigEnd ? "binary_big_endian" : "binary_little_endian");
    for (const Vector3f& corner : corners())
        for (const float coordinate : corner)
            append(bytes, coordinate, bigEnd);
    for (const auto& face : kFaces) {
        append<std::uint8_t>(bytes, 4, bigEnd);
        for (const std::uint32_t index : face)
            append(bytes, index, bigEnd);
    }
    return bytes;
}

std::string base64(const std::string& bytes) {
    constexpr const char* kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k)
            group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
        for (std::size_t k = 0; k < 4; ++k)
            text += i + k > bytes.size() ? '=' : kDigits[group >> (18 - 6 * k) & 63U];
    }
    return text;
}

Indices cubeIndices() {
    Indices indices;
    for (const auto& face : kFaces)
        indices.insert(indices.end(), {face[0], face[1], face[2], face[0], face[2], face[3]});
    return indices;
}

std::string glb() {
    const std::string data = gltfBytes(corners(), cubeIndices());
    nlohmann::json json = nlohmann::json::parse(gltfWith("", data.size(), 8, 36, R"([{"mesh":0}])"));
    json["buffers"][0].erase("uri");
    std::string head = json.dump();
    head.resize((head.size() + 3) / 4 * 4, ' ');
    std::string bytes = "glTF";
    append<std::uint32_t>(bytes, 2, false);
    append(bytes, static_cast<std::uint32_t>(12 + 8 + head.size() + 8 + data.size()), false);
    append(bytes, static_cast<std::uint32_t>(head.size()), false);
    bytes += "JSON" + head;
    append(bytes, static_cast<std::uint32_t>(data.size()), false);
    return bytes + std::string("BIN\0", 4) + data;
}

} // namespace

std::string gltfBytes(const std::vector<Vector3f>& positions, const Indices& indices) {
    std::string bytes;
    for (const Vector3f& position : positions)
        for (const float coordinate : position)
            append(bytes, coordinate, false);
    for (const std::uint32_t index : indices)
        append(bytes, index, false);
    return bytes;
}

std::string gltfWith(const std::string& uri, std::size_t bytes, std::size_t positions, std::size_t indices,
                     const std::string& nodes) {
    return fmt::format(
        R"({{"asset":{{"version":"2.0"}},"buffers":[{{"uri":"{0}","byteLength":{1}}}],)"
        R"("bufferViews":[{{"buffer":0,"byteLength":{2}}},{{"buffer":0,"byteOffset":{2},"byteLength":{3}}}],)"
        R"("accessors":[{{"bufferView":0,"componentType":5126,"count":{4},"type":"VEC3"}},)"
        R"({{"bufferView":1,"componentType":5125,"count":{5},"type":"SCALAR"}}],)"
        R"("meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}},"indices":1}}]}}],)"
        R"("nodes":{6},"scenes":[{{"nodes":[0]}}],"scene":0}})",
        uri, bytes, positions * 12, indices * 4, positions, indices, nodes);
}

std::string gltfText(const std::vector<Vector3f>& positions, const std::string& indices,
                     const std::string& nodes) {
    const Indices numbers = nlohmann::json::parse(indices).get<Indices>();
    const std::string bytes = gltfBytes(positions, numbers);
    return gltfWith("data:application/octet-stream;base64," + base64(bytes), bytes.size(), positions.size(),
                    numbers.size(), nodes);
}

std::map<std::string, std::string> cubes() {
    return {{"cube.obj", obj()},
            {"text.ply", plyText()},
            {"little.ply", plyBinary(false)},
            {"big.ply", plyBinary(true)},
            {"cube.gltf", gltfText(corners(), nlohmann::json(cubeIndices()).dump(), R"([{"mesh":0}])")},
            {"cube.glb", glb()}};
}

} // namespace texloom::test
