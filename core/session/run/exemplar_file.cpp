#include "core/session/run/exemplar_file.h"

#include "core/color/color_pipeline.h"

#include <utility>

namespace texloom {

namespace {

ExemplarFile load(const std::filesystem::path& path, const std::string& space) {
    LoadedImage loaded = readImage(path);
    ExemplarFile file{path, space.empty() ? loaded.info.space : space, fileHash(path), loaded.info, nullptr};
    file.role = mapNameFrom(file.name()).role;
    color::toWorking(loaded.image, file.space);
    file.image = std::make_shared<const Image>(std::move(loaded.image));
    return file;
}

} // namespace

ExemplarFile loadExemplar(const std::filesystem::path& path, const std::string& space) {
    return load(path, space);
}

ExemplarFile loadData(const std::filesystem::path& path) {
    return load(path, "raw");
}

ExemplarFile loadMask(const std::filesystem::path& path) {
    ExemplarFile file = loadData(path);
    if (file.image->channels() > 1) {
        ImageView first = *file.image;
        first.channels = 1;
        file.image = std::make_shared<const Image>(first);
    }
    return file;
}

} // namespace texloom
