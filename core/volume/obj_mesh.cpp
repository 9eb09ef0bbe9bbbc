#include "core/base/error.h"
#include "core/volume/mesh_formats.h"

#include <tiny_obj_loader.h>

#include <istream>
#include <streambuf>

namespace texloom {

namespace {

/// Lets a stream read bytes that are in memory already.
class BytesBuffer : public std::streambuf {
public:
    explicit BytesBuffer(const std::string& bytes) {
        char* begin = const_cast<char*>(bytes.data()); // streams read through pointers that are not const
        setg(begin, begin, begin + bytes.size());
    }
};

/// Indices count from 1, or back from the newest if they are negative; 0 stands for none.
std::int64_t fromZero(int index, std::size_t count) {
    return index >= 0 ? std::int64_t{index} - 1 : static_cast<std::int64_t>(count) + index;
}

/// Back references that lead before the first must not pass for "none".
std::int64_t optional(int index, std::size_t count) {
    const std::int64_t found = fromZero(index, count);
    return index < 0 && found < 0 ? static_cast<std::int64_t>(count) : found;
}

MeshBuilder& builderOf(void* data) {
    return *static_cast<MeshBuilder*>(data);
}

void addFace(void* data, tinyobj::index_t* indices, int count) {
    MeshBuilder& builder = builderOf(data);
    std::vector<MeshBuilder::Corner> corners;
    corners.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i)
        corners.push_back({fromZero(indices[i].vertex_index, builder.positions()),
                           optional(indices[i].normal_index, builder.normals()),
                           optional(indices[i].texcoord_index, builder.uvs())});
    builder.addPolygon(corners);
}

} // namespace

void readObj(const std::filesystem::path& path, const std::string& bytes, MeshBuilder& builder) {
    tinyobj::callback_t callbacks;
    callbacks.vertex_cb = [](void* data, float x, float y, float z, float) {
        builderOf(data).addPosition({x, y, z});
    };
    callbacks.normal_cb = [](void* data, float x, float y, float z) { builderOf(data).addNormal({x, y, z}); };
    callbacks.texcoord_cb = [](void* data, float u, float v, float) {
        builderOf(data).addUv({u, 1 - v}); // OBJ counts v from the bottom
    };
    callbacks.index_cb = addFace;
    BytesBuffer buffer(bytes);
    std::istream stream(&buffer);
    std::string warning, error;
    if (!tinyobj::LoadObjWithCallback(stream, callbacks, &builder, nullptr, &warning, &error))
        fail("{} is a damaged OBJ file.", path.string());
}

} // namespace texloom
