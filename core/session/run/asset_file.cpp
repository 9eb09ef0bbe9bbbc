#include "core/session/run/asset_file.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/color/color_pipeline.h"
#include "core/image/channel_text.h"
#include "core/io/image_file.h"
#include "core/io/map_file.h"
#include "core/io/model_json.h"
#include "core/volume/mesh_file.h"
#include "core/volume/volume_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace texloom {

namespace fs = std::filesystem;

namespace {

constexpr std::array<const char*, 6> kKindIds = {"image", "mask", "map", "model", "volume", "mesh"};
constexpr const char* kModelExtension = ".safetensors";
constexpr const char* kTableExtension = ".json"; ///< of models for other programs

/// Lets work that wants a job's context run on this thread, as long as `check` does not throw.
template <class Work> auto inPlace(const std::function<void()>& check, const Work& work) {
    JobMonitor monitor;
    const auto stopped = [&check] {
        if (check)
            check();
        return false;
    };
    JobContext context({}, stopped, monitor);
    return work(context);
}

/// Calls `use` with what the asset holds, whatever that is.
template <class Use> auto with(const Asset& asset, const Use& use) {
    return std::visit([&use](const auto& held) { return use(*held); }, asset);
}

std::uint64_t numbersOf(const Model& model) {
    std::uint64_t count = 0;
    for (const auto& [name, array] : model.arrays)
        count += std::visit([](const auto& values) { return values.size(); }, array.values);
    return count;
}

std::uint64_t arrayBytes(const Model& model) {
    std::uint64_t bytes = 0;
    for (const auto& [name, array] : model.arrays)
        bytes += std::visit([](const auto& values) { return values.size() * sizeof(values.front()); },
                            array.values);
    return bytes;
}

/// Small models are told apart by less than byteText() tells.
std::string smallByteText(std::uint64_t bytes) {
    constexpr std::uint64_t kKibi = 1024;
    return bytes < kKibi           ? fmt::format("{} B", bytes)
           : bytes < kKibi * kKibi ? fmt::format("{} KiB", (bytes + kKibi / 2) / kKibi)
                                   : byteText(bytes);
}

struct SizeText {
    Message operator()(const Image& image) const {
        return message("{}, {}", message("{} × {} px", image.width(), image.height()),
                       channelText(image.channels()));
    }
    Message operator()(const PositionMap& map) const {
        return message("{} × {} px", map.width(), map.height());
    }
    Message operator()(const Model& model) const {
        return message("{} numbers, {}", grouped(numbersOf(model)), smallByteText(arrayBytes(model)));
    }
    Message operator()(const VolumeSource& source) const {
        if (const std::optional<Box> bounds = source.bounds())
            return message("{} voxels, {}", texloom::sizeText(bounds->size), channelText(source.channels()));
        const VolumeSize period = source.period();
        return period.empty() ? message("without end, {}", channelText(source.channels()))
                              : message("repeats after {} voxels, {}", texloom::sizeText(period),
                                        channelText(source.channels()));
    }
    Message operator()(const Mesh& mesh) const {
        return message("{} triangles", grouped(mesh.triangles.size()));
    }
};

template <class Element> std::uint64_t vectorBytes(const std::vector<Element>& elements) {
    return elements.size() * sizeof(Element);
}

struct Bytes {
    std::uint64_t operator()(const Image& image) const {
        return image.empty() ? 0 : Image::bytesFor(image.size(), image.channels());
    }
    std::uint64_t operator()(const PositionMap& map) const { return PositionMap::bytesFor(map.size()); }
    std::uint64_t operator()(const Model& model) const { return arrayBytes(model); }
    std::uint64_t operator()(const VolumeSource& source) const {
        const auto* dense = dynamic_cast<const DenseSource*>(&source);
        return dense ? Volume::bytesFor(dense->volume().size(), source.channels()) : 0;
    }
    std::uint64_t operator()(const Mesh& mesh) const {
        return vectorBytes(mesh.positions) + vectorBytes(mesh.normals) + vectorBytes(mesh.uvs) +
               vectorBytes(mesh.triangles);
    }
};

bool isRawVolume(const fs::path& path) {
    return path.extension() == ".json";
}

bool isReal(Depth depth) {
    return depth == Depth::Half || depth == Depth::Float;
}

/// The depth that is wanted, where the format of `path` holds it.
Depth depthIn(const fs::path& path, Depth wanted) {
    const std::vector<Depth> held = depthsFor(path);
    return std::find(held.begin(), held.end(), wanted) != held.end() ? wanted : held.front();
}

WriteOptions imageOptions(const fs::path& path, Depth depth, const AssetWriteOptions& options) {
    WriteOptions write;
    write.depth = depthIn(path, depth);
    write.space = options.space != "raw" && isReal(write.depth) ? "linear" : options.space;
    write.recipe = options.recipe;
    write.check = options.check;
    return write;
}

bool repeatsBy(const VolumeSource& source, const Box& box) {
    return !source.period().empty() && source.period() == box.size;
}

/// Writes each kind in its own way.
struct Writer {
    const fs::path& path;
    const AssetWriteOptions& options;

    void operator()(const Image& image) const {
        const WriteOptions write = imageOptions(path, options.depth, options);
        Image converted(image);
        color::fromWorking(converted, write.space, options.check);
        writeImage(path, converted, write);
    }
    void operator()(const PositionMap& map) const {
        writePositionMap(path, map, options.recipe, options.check);
    }
    void operator()(const Model& model) const {
        if (path.extension() == kTableExtension)
            return writeText(path, jsonOf(model));
        if (!model.recipe.empty() || options.recipe.empty())
            return writeModel(path, model);
        Model told = model;
        told.recipe = options.recipe;
        told.exemplarHashes = options.exemplarHashes;
        writeModel(path, told);
    }
    void operator()(const VolumeSource& source) const {
        VolumeWriteOptions write;
        write.space = options.space;
        if (!isRawVolume(path)) {
            const WriteOptions each = imageOptions(path, Depth::Bits16, options);
            write.depth = each.depth;
            write.space = each.space;
        }
        write.recipe = options.recipe;
        const Box box = keptBox(source, options.size, options.mostVoxels);
        write.repeats = repeatsBy(source, box);
        inPlace(options.check, [&](JobContext& context) { writeVolume(path, source, box, write, context); });
    }
    void operator()(const Mesh& mesh) const { writeMesh(path, mesh, options.check); }
};

} // namespace

std::string kindId(AssetKind kind) {
    return kKindIds.at(static_cast<std::size_t>(kind));
}

AssetKind kindFrom(const std::string& id) {
    const auto found = std::find(kKindIds.begin(), kKindIds.end(), id);
    if (found == kKindIds.end())
        failUsage("There is nothing of the kind {}; there are {}.", id,
                  listOf({kKindIds.begin(), kKindIds.end()}));
    return static_cast<AssetKind>(found - kKindIds.begin());
}

AssetKind kindOf(const Asset& asset) {
    for (const AssetKind kind : {AssetKind::Map, AssetKind::Model, AssetKind::Volume, AssetKind::Mesh})
        if (isOf(kind, asset))
            return kind;
    return AssetKind::Image;
}

Message sizeText(const Asset& asset) {
    return with(asset, SizeText());
}

std::uint64_t bytesOf(const Asset& asset) {
    return with(asset, Bytes());
}

std::vector<fs::path> filesOf(AssetKind kind, const fs::path& path) {
    return kind == AssetKind::Volume ? filesOfVolume(path)
           : kind == AssetKind::Mesh ? filesOfMesh(path)
                                     : std::vector<fs::path>{path};
}

std::string assetHash(AssetKind kind, const fs::path& path) {
    const std::vector<fs::path> files = filesOf(kind, path);
    if (files.size() == 1)
        return fileHash(path);
    std::string hashes;
    for (const fs::path& file : files)
        hashes += fileHash(file);
    return bytesHash(hashes);
}

Asset readAsset(AssetKind kind, const fs::path& path, const std::function<void()>& check) {
    switch (kind) {
    case AssetKind::Model:
        return std::make_shared<const Model>(readModel(path));
    case AssetKind::Volume:
        return inPlace(check, [&](JobContext& context) -> Asset {
            return std::shared_ptr<const VolumeSource>(readVolume(path, context).source);
        });
    case AssetKind::Mesh:
        return inPlace(check, [&](JobContext& context) -> Asset {
            return std::make_shared<const Mesh>(readMesh(path, context));
        });
    case AssetKind::Image:
    case AssetKind::Mask:
        return std::make_shared<const Image>(readImage(path).image);
    case AssetKind::Map:
        break;
    }
    return std::make_shared<const PositionMap>(readPositionMap(path));
}

std::string usualExtension(AssetKind kind) {
    static constexpr std::array<const char*, 6> extensions = {".png",          ".png",  ".png",
                                                              kModelExtension, ".json", ".ply"};
    return extensions.at(static_cast<std::size_t>(kind));
}

void checkAssetFile(AssetKind kind, const fs::path& path) {
    checkFolder(path);
    const std::string extension = path.extension().string(), usual = usualExtension(kind);
    switch (kind) {
    case AssetKind::Model:
    case AssetKind::Mesh:
        if (extension != usual && (kind != AssetKind::Model || extension != kTableExtension))
            failUsage("{}: {} is written as {}; give the file that extension.", path.string(), kindText(kind),
                      usual);
        break;
    case AssetKind::Volume:
        if (!isRawVolume(path)) // slices
            depthsFor(path);
        break;
    case AssetKind::Map:
        mapConvention(path);
        break;
    case AssetKind::Image:
    case AssetKind::Mask:
        depthsFor(path);
        break;
    }
}

std::vector<fs::path> filesFor(AssetKind kind, const Asset& asset, const fs::path& path,
                               const AssetWriteOptions& options) {
    const auto* source = std::get_if<std::shared_ptr<const VolumeSource>>(&asset);
    if (kind != AssetKind::Volume || source == nullptr)
        return {path};
    std::vector<fs::path> files =
        volumeFiles(path, keptBox(**source, options.size, options.mostVoxels).size.depth);
    if (isRawVolume(path))
        std::reverse(files.begin(), files.end());
    return files;
}

void writeAsset(AssetKind kind, const Asset& asset, const fs::path& path, const AssetWriteOptions& options) {
    checkAssetFile(kind, path);
    with(asset, Writer{path, options});
}

Box keptBox(const VolumeSource& source, Size picture, std::int64_t mostVoxels) {
    if (const std::optional<Box> bounds = source.bounds())
        return *bounds;
    const auto side = [](int period, std::int64_t otherwise) {
        return period > 0 ? period
                          : static_cast<int>(std::clamp<std::int64_t>(otherwise, 1, kLongestKeptSide));
    };
    const VolumeSize period = source.period();
    Box box;
    box.size.width = side(period.width, picture.width);
    box.size.height = side(period.height, picture.height);
    const std::int64_t fitting = mostVoxels / (std::int64_t{box.size.width} * box.size.height);
    box.size.depth =
        side(period.depth, std::min<std::int64_t>(fitting, std::min(box.size.width, box.size.height)));
    return box;
}

} // namespace texloom
