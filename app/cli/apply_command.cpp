#include "app/cli/commands.h"
#include "app/cli/console.h"
#include "app/cli/layer_choice.h"
#include "core/image/normal_map.h"
#include "core/image/stmap.h"
#include "core/io/image_file.h"
#include "core/io/map_file.h"
#include "core/session/export/export_options.h"
#include "core/session/run/exemplar_file.h"

#include <fmt/format.h>

namespace texloom::cli {

namespace fs = std::filesystem;

namespace {

/// Files of exemplars under a map whose places lie between pixels; normal maps' vectors are turned.
Image laidOut(const Image& stmap, const std::vector<ExemplarFile>& files,
              const std::vector<ImageView>& images) {
    Image image = appliedStMap(stmap, images, checkInterrupt);
    const ExemplarFile& first = files.front();
    if (isNormal(first.role))
        turnNormals(
            image, *first.image, first.role,
            [&](int x, int y) { return stMapJacobian(stmap, first.image->size(), x, y); }, checkInterrupt);
    return image;
}

} // namespace

void applyMap(const ApplyOptions& options) {
    std::vector<ExemplarFile> files;
    std::vector<ImageView> images;
    std::vector<Size> sizes;
    LayerChoice layers(options.layers);
    const std::string layerOfMap = layers.of("map");
    for (const fs::path& path : options.exemplars) {
        files.push_back(
            loadUnconverted(path, layers.of(LayerChoice::kPictures, files.size(), options.exemplars.size())));
        images.push_back(*files.back().image);
        sizes.push_back(files.back().image->size());
    }
    layers.checkUsed();
    checkWritable(options.output, images.front().channels, depthLike(files.front().info, options.output));
    std::vector<fs::path> sources = options.exemplars;
    sources.push_back(options.map);
    checkOnlyOutput(sources, options.output, options.overwrite);
    const std::optional<Image> between = readFractionalMap(options.map, sizes, layerOfMap);
    const Image image = between ? laidOut(*between, files, images)
                                : readPositionMap(options.map, sizes, layerOfMap).apply(images);
    checkInterrupt();
    WriteOptions write;
    write.depth = depthLike(files.front().info, options.output);
    write.space = files.front().space;
    write.channelNames = files.front().info.channelNames;
    write.check = checkInterrupt;
    writeImage(options.output, image, write);
    if (!options.quiet)
        fmt::print("{}: {} × {} px\n", options.output.string(), image.width(), image.height());
}

} // namespace texloom::cli
