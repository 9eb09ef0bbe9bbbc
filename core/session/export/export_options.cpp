#include "core/session/export/export_options.h"

#include "core/image/map_name.h"

#include <fmt/format.h>

#include <algorithm>

namespace texloom {

namespace fs = std::filesystem;

NameWords nameWords(const Result& result, const std::string& map) {
    const Size size = result.plan.request.part().size;
    const std::optional<Region>& region = result.plan.request.region;
    const std::string width = std::to_string(size.width), height = std::to_string(size.height);
    return {{"name", mapNameFrom(result.plan.name()).base},
            {"method", result.plan.methodIds("_")},
            {"seed", std::to_string(result.plan.request.seed)},
            {"w", width},
            {"h", height},
            {"size", size.width == size.height ? width : width + "x" + height},
            {"place", region ? fmt::format("_at_{}_{}", region->x, region->y) : ""},
            {"map", map}};
}

Depth depthLike(const ImageFileInfo& source, const fs::path& path) {
    const std::vector<Depth> depths = depthsFor(path);
    const auto named = std::find_if(depths.begin(), depths.end(),
                                    [&](Depth depth) { return depthName(depth) == source.depth; });
    return named != depths.end() ? *named : depths.front();
}

std::string extensionLike(const ImageFileInfo& source) {
    const std::string& format = source.format;
    return format == "openexr" ? ".exr" : format == "tiff" ? ".tif" : format == "hdr" ? ".hdr" : ".png";
}

} // namespace texloom
