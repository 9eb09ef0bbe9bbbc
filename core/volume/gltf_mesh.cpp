#include "core/base/error.h"
#include "core/base/text.h"
#include "core/io/image_file.h"
#include "core/volume/mesh_formats.h"

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>
#include <tiny_gltf.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <exception>
#include <optional>

namespace texloom {

namespace fs = std::filesystem;

namespace {

using Eigen::Matrix4d;
using Eigen::Vector3d;

constexpr int kDeepestNode = 64;
constexpr std::size_t kMostNodes = 1 << 16; // visited: a node may be the child of several
constexpr std::uint64_t kLargestBuffer = 2ULL << 30;

/// The first line of what the library says, without a closing stop.
std::string reason(const std::string& message) {
    std::string line = message.substr(0, message.find('\n')).substr(0, 200);
    std::replace_if(
        line.begin(), line.end(), [](unsigned char c) { return c < ' ' || c > '~'; }, '?');
    while (!line.empty() && (line.back() == '.' || line.back() == ' '))
        line.pop_back();
    return line.empty() ? "it is damaged" : line;
}

/// Files that a .gltf names lie in its own folder, or are not read.
class Files {
public:
    explicit Files(fs::path folder) : m_folder(std::move(folder)) {}

    tinygltf::FsCallbacks callbacks() {
        return {
            [](const std::string& name, void* self) { return of(self).find(name).has_value(); },
            [](const std::string& name, void*) { return name; },
            [](std::vector<unsigned char>* bytes, std::string* error, const std::string& name, void* self) {
                return of(self).read(name, *bytes, *error);
            },
            [](std::string*, const std::string&, const std::vector<unsigned char>&, void*) { return false; },
            this};
    }

private:
    static const Files& of(void* self) { return *static_cast<const Files*>(self); }

    std::optional<fs::path> find(const std::string& name) const {
        const fs::path path = m_folder / fs::path(name).filename();
        std::error_code error;
        const bool plain = fs::path(name) == fs::path(name).filename() || fs::path(name) == path;
        return plain && fs::is_regular_file(path, error) ? std::optional(path) : std::nullopt;
    }
    bool read(const std::string& name, std::vector<unsigned char>& bytes, std::string& error) const {
        const std::optional<fs::path> path = find(name);
        try {
            const std::string text = path ? readText(*path, kLargestBuffer) : std::string();
            bytes.assign(text.begin(), text.end());
        } catch (const Error& failure) {
            error = failure.what();
        }
        return !bytes.empty();
    }

    fs::path m_folder;
};

/// Numbers of a buffer, as one accessor describes them; every place in it was held against the buffer's size.
class Accessor {
public:
    Accessor(const std::string& file, const tinygltf::Model& model, int index, int type);

    std::size_t count() const { return m_count; }
    double at(std::size_t element, int component) const;
    std::uint32_t indexAt(std::size_t element) const { return static_cast<std::uint32_t>(at(element, 0)); }
    bool real() const { return m_component == TINYGLTF_COMPONENT_TYPE_FLOAT; }

private:
    template <class T> double number(const unsigned char* data) const {
        T value{};
        std::memcpy(&value, data, sizeof(T));
        return static_cast<double>(value);
    }

    const unsigned char* m_data = nullptr;
    std::size_t m_count = 0, m_stride = 0, m_componentBytes = 0;
    int m_component = 0;
    double m_scale = 1;
};

template <class T> const T* entry(const std::vector<T>& list, int index) {
    return index >= 0 && static_cast<std::size_t>(index) < list.size()
               ? &list[static_cast<std::size_t>(index)]
               : nullptr;
}

Accessor::Accessor(const std::string& file, const tinygltf::Model& model, int index, int type) {
    const tinygltf::Accessor* accessor = entry(model.accessors, index);
    if (!accessor || accessor->type != type || accessor->sparse.isSparse)
        fail("{}: the numbers of a surface are missing, sparse or of another kind than they must be.", file);
    const tinygltf::BufferView* view = entry(model.bufferViews, accessor->bufferView);
    const tinygltf::Buffer* buffer = view ? entry(model.buffers, view->buffer) : nullptr;
    const int componentBytes =
        tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(accessor->componentType));
    const int components = tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(type));
    if (!buffer || componentBytes < 1 || componentBytes > 4)
        fail("{}: the numbers of a surface lie in no buffer, or are of no known type.", file);
    m_component = accessor->componentType;
    m_componentBytes = static_cast<std::size_t>(componentBytes);
    m_count = accessor->count;
    const std::size_t element = m_componentBytes * static_cast<std::size_t>(components);
    m_stride = view->byteStride != 0 ? view->byteStride : element;
    std::uint64_t end = 0, offset = 0;
    const bool overflows = m_count == 0 || m_stride < element ||
                           __builtin_mul_overflow(m_count - 1, m_stride, &end) ||
                           __builtin_add_overflow(end, element, &end) ||
                           __builtin_add_overflow(end, accessor->byteOffset, &end) ||
                           __builtin_add_overflow(view->byteOffset, accessor->byteOffset, &offset);
    std::uint64_t viewEnd = 0;
    if (overflows || end > view->byteLength ||
        __builtin_add_overflow(view->byteOffset, view->byteLength, &viewEnd) || viewEnd > buffer->data.size())
        fail("{} is damaged: {} numbers of a surface do not lie within the {} bytes of their buffer.", file,
             grouped(m_count), grouped(buffer->data.size()));
    m_data = buffer->data.data() + offset;
    if (accessor->normalized && m_component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE)
        m_scale = 255;
    if (accessor->normalized && m_component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT)
        m_scale = 65535;
}

double Accessor::at(std::size_t element, int component) const {
    const unsigned char* data =
        m_data + element * m_stride + static_cast<std::size_t>(component) * m_componentBytes;
    switch (m_component) {
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return number<std::uint8_t>(data) / m_scale;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return number<std::uint16_t>(data) / m_scale;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        return number<std::uint32_t>(data);
    case TINYGLTF_COMPONENT_TYPE_BYTE:
        return number<std::int8_t>(data);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
        return number<std::int16_t>(data);
    default:
        return number<float>(data);
    }
}

/// Where a node puts what is in it, within its parent.
Matrix4d placeOf(const tinygltf::Node& node) {
    if (node.matrix.size() == 16)
        return Eigen::Map<const Matrix4d>(node.matrix.data());
    Eigen::Affine3d place = Eigen::Affine3d::Identity();
    if (node.translation.size() == 3)
        place.translate(Vector3d(node.translation[0], node.translation[1], node.translation[2]));
    if (node.rotation.size() == 4)
        place.rotate(
            Eigen::Quaterniond(node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2])
                .normalized());
    if (node.scale.size() == 3)
        place.scale(Vector3d(node.scale[0], node.scale[1], node.scale[2]));
    return place.matrix();
}

class GltfReader {
public:
    GltfReader(std::string file, const tinygltf::Model& model, MeshBuilder& builder)
        : m_file(std::move(file)), m_model(model), m_builder(builder) {}

    /// The default scene, or every mesh as it is where there is none.
    void read() {
        const int scene = m_model.defaultScene >= 0 ? m_model.defaultScene : 0;
        if (const tinygltf::Scene* shown = entry(m_model.scenes, scene)) {
            for (const int node : shown->nodes)
                readNode(node, Matrix4d::Identity(), 0);
            return;
        }
        for (const tinygltf::Mesh& mesh : m_model.meshes)
            readSurfaces(mesh, Matrix4d::Identity());
    }

private:
    void readNode(int index, const Matrix4d& parent, int depth) {
        const tinygltf::Node* node = entry(m_model.nodes, index);
        if (!node || depth > kDeepestNode || ++m_visited > kMostNodes)
            fail("{}: its nodes are missing, nested more than {} deep or more than {}.", m_file, kDeepestNode,
                 grouped(kMostNodes));
        const Matrix4d place = parent * placeOf(*node);
        if (const tinygltf::Mesh* mesh = entry(m_model.meshes, node->mesh))
            readSurfaces(*mesh, place);
        for (const int child : node->children)
            readNode(child, place, depth + 1);
    }

    void readSurfaces(const tinygltf::Mesh& mesh, const Matrix4d& place) {
        for (const tinygltf::Primitive& surface : mesh.primitives)
            if (surface.mode == TINYGLTF_MODE_TRIANGLES || surface.mode == -1)
                readTriangles(surface, place);
    }

    std::optional<Accessor> find(const tinygltf::Primitive& surface, const char* name, int type) const {
        const auto found = surface.attributes.find(name);
        return found == surface.attributes.end()
                   ? std::nullopt
                   : std::optional(Accessor(m_file, m_model, found->second, type));
    }

    void readTriangles(const tinygltf::Primitive& surface, const Matrix4d& place) {
        const std::optional<Accessor> positions = find(surface, "POSITION", TINYGLTF_TYPE_VEC3),
                                      normals = find(surface, "NORMAL", TINYGLTF_TYPE_VEC3),
                                      uvs = find(surface, "TEXCOORD_0", TINYGLTF_TYPE_VEC2);
        if (!positions || !positions->real() || (normals && normals->count() != positions->count()) ||
            (uvs && uvs->count() != positions->count()))
            fail("{}: a surface has no positions of 32-bit floats, or other numbers of normals or texture "
                 "coordinates.",
                 m_file);
        const Base base{m_builder.positions(), m_builder.normals(), m_builder.uvs()};
        addVertices(*positions, normals, uvs, place);
        std::optional<Accessor> indices;
        if (surface.indices >= 0)
            indices = Accessor(m_file, m_model, surface.indices, TINYGLTF_TYPE_SCALAR);
        const std::size_t count = indices ? indices->count() : positions->count();
        std::array<MeshBuilder::Corner, 3> corners;
        // A mirroring node turns the order of the corners round.
        const bool mirrored = place.topLeftCorner<3, 3>().determinant() < 0;
        for (std::size_t i = 0; i + 2 < count; i += 3) {
            for (std::size_t k = 0; k < 3; ++k) {
                const std::size_t index = indices ? indices->indexAt(i + k) : i + k;
                if (index >= positions->count())
                    fail("{}: a face uses vertex {}; there are {}.", m_file, index + 1, positions->count());
                corners.at(mirrored ? 2 - k : k) = base.corner(index, normals.has_value(), uvs.has_value());
            }
            m_builder.addPolygon(corners);
        }
    }

    /// Where the numbers of one surface begin among all.
    struct Base {
        std::size_t positions, normals, uvs;
        MeshBuilder::Corner corner(std::size_t index, bool normal, bool uv) const {
            return {static_cast<std::int64_t>(positions + index),
                    normal ? static_cast<std::int64_t>(normals + index) : -1,
                    uv ? static_cast<std::int64_t>(uvs + index) : -1};
        }
    };

    void addVertices(const Accessor& positions, const std::optional<Accessor>& normals,
                     const std::optional<Accessor>& uvs, const Matrix4d& place) {
        const Eigen::Matrix3d turn = place.topLeftCorner<3, 3>();
        // Normals stay square to surfaces that are stretched.
        const Eigen::Matrix3d turnNormals =
            turn.determinant() != 0 ? Eigen::Matrix3d(turn.inverse().transpose()) : turn;
        for (std::size_t i = 0; i < positions.count(); ++i) {
            const Vector3d position(positions.at(i, 0), positions.at(i, 1), positions.at(i, 2));
            m_builder.addPosition((turn * position + place.topRightCorner<3, 1>()).cast<float>());
            if (normals)
                m_builder.addNormal(
                    (turnNormals * Vector3d(normals->at(i, 0), normals->at(i, 1), normals->at(i, 2)))
                        .cast<float>());
            if (uvs)
                m_builder.addUv({static_cast<float>(uvs->at(i, 0)), static_cast<float>(uvs->at(i, 1))});
        }
    }

    std::string m_file;
    const tinygltf::Model& m_model;
    MeshBuilder& m_builder;
    std::size_t m_visited = 0;
};

tinygltf::Model parsed(const fs::path& path, const std::string& bytes) {
    constexpr std::size_t kLargest = 0xffffffff; // the library counts in 32 bits
    if (bytes.size() > kLargest)
        fail("{} is {} long; a glTF file can have up to {}.", path.string(), byteText(bytes.size()),
             byteText(kLargest));
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    Files files(folder);
    tinygltf::TinyGLTF loader;
    loader.SetFsCallbacks(files.callbacks());
    // Pictures are not looked at.
    loader.SetImageLoader([](tinygltf::Image*, int, std::string*, std::string*, int, int,
                             const unsigned char*, int, void*) { return true; },
                          nullptr);
    tinygltf::Model model;
    std::string error, warning;
    bool good = false;
    const auto size = static_cast<unsigned>(bytes.size());
    try {
        good =
            bytes.starts_with("glTF")
                ? loader.LoadBinaryFromMemory(&model, &error, &warning,
                                              reinterpret_cast<const unsigned char*>(bytes.data()), size,
                                              folder.string())
                : loader.LoadASCIIFromString(&model, &error, &warning, bytes.data(), size, folder.string());
    } catch (const std::exception& failure) {
        error = failure.what();
    }
    if (!good)
        fail("{} cannot be read: {}.", path.string(), reason(error));
    if (!model.extensionsRequired.empty())
        fail("{} needs the extension {}, which Texloom does not read; save it without compression.",
             path.string(), reason(model.extensionsRequired.front()));
    return model;
}

} // namespace

void readGltf(const fs::path& path, const std::string& bytes, MeshBuilder& builder) {
    GltfReader(path.string(), parsed(path, bytes), builder).read();
}

std::vector<fs::path> buffersOfGltf(const fs::path& path, const std::string& bytes) {
    const auto json = nlohmann::json::parse(bytes, nullptr, false);
    std::vector<fs::path> files;
    if (!json.is_object() || !json.contains("buffers") || !json["buffers"].is_array())
        return files;
    for (const auto& buffer : json["buffers"]) {
        if (!buffer.is_object() || !buffer.contains("uri") || !buffer["uri"].is_string())
            continue;
        const fs::path name = buffer["uri"].get<std::string>();
        std::error_code error;
        if (name == name.filename() && fs::is_regular_file(path.parent_path() / name, error))
            files.push_back(path.parent_path() / name);
    }
    return files;
}

} // namespace texloom
