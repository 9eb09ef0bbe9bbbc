#include "core/volume/mesh_file.h"

#include "core/base/error.h"
#include "core/io/image_file.h"
#include "core/volume/mesh_formats.h"

#include <algorithm>
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

} // namespace

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
