#include "core/io/map_file.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/image/stmap.h"
#include "core/io/image_file.h"

#include <fmt/format.h>

#include <cctype>
#include <cmath>
#include <sstream>

namespace texloom {

namespace fs = std::filesystem;

namespace {

const char* const kSizesAttribute = "texloom:exemplars";

enum class MapFormat { StMap, Exact };

MapFormat mapFormatFor(const fs::path& path) {
    std::string extension = path.extension().string();
    for (char& letter : extension)
        letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    if (extension == ".exr")
        return MapFormat::StMap;
    if (extension == ".png")
        return MapFormat::Exact;
    failUsage("{} cannot hold a position map; its name ends in .exr (STMap, float) or .png (16-bit).",
              path.string());
}

/// "512x512 256x128"
std::string sizesText(const std::vector<Size>& sizes) {
    std::vector<std::string> words;
    for (const Size& size : sizes)
        words.push_back(fmt::format("{}x{}", size.width, size.height));
    return fmt::format("{}", fmt::join(words, " "));
}

std::vector<Size> parseSizes(const std::string& text) {
    std::vector<Size> sizes;
    std::istringstream words(text);
    Size size;
    char by = 0;
    while (words >> size.width >> by >> size.height)
        sizes.push_back(size);
    return sizes;
}

std::string textOf(const ImageFileInfo& info, const char* name) {
    const auto found = info.texts.find(name);
    return found == info.texts.end() ? std::string() : found->second;
}

void stMapRow(const PositionMap& map, int y, float* row) {
    for (int x = 0; x < map.width(); ++x, row += 4) {
        const Source& source = map.at(x, y);
        if (!source.valid()) {
            std::fill_n(row, 4, 0.0F);
            continue;
        }
        const Size size = map.exemplarSizes()[source.exemplar];
        row[0] = static_cast<float>((source.x + 0.5) / size.width);
        row[1] = static_cast<float>(1 - (source.y + 0.5) / size.height);
        row[2] = source.exemplar;
        row[3] = 1;
    }
}

void exactRow(const PositionMap& map, int y, float* row) {
    for (int x = 0; x < map.width(); ++x) {
        const Source& source = map.at(x, y);
        for (const std::uint16_t number : {source.x, source.y, source.exemplar})
            *row++ = static_cast<float>(number) / 65535.0F;
    }
}

/// A coordinate in pixels that must be whole and within [0, count).
std::uint16_t pixelIndex(const fs::path& path, double position, int count, int x, int y) {
    constexpr double kWhole = 1.0 / 32;
    const double whole = std::round(position);
    if (!(whole >= 0 && whole < count))
        fail("{}: output pixel ({}, {}) comes from {:.2f}, outside the exemplar's 0 to {}.", path.string(), x,
             y, position, count - 1);
    if (std::abs(position - whole) > kWhole)
        fail("{}: output pixel ({}, {}) comes from {:.2f}, between two pixels; a position map addresses "
             "whole ones (was it resampled, or is it for an exemplar of another size?).",
             path.string(), x, y, position);
    return static_cast<std::uint16_t>(whole);
}

Source stMapSource(const fs::path& path, const ImageView& image, const std::vector<Size>& sizes, int x,
                   int y) {
    if (image.channels >= 4 && image(x, y, 3) < 0.5F)
        return {};
    const int exemplar = image.channels >= 3 ? pixelIndex(path, static_cast<double>(image(x, y, 2)),
                                                          static_cast<int>(sizes.size()), x, y)
                                             : 0;
    const Size size = sizes[static_cast<std::size_t>(exemplar)];
    return {
        pixelIndex(path, static_cast<double>(image(x, y, 0)) * size.width - 0.5, size.width, x, y),
        pixelIndex(path, (1 - static_cast<double>(image(x, y, 1))) * size.height - 0.5, size.height, x, y),
        static_cast<std::uint16_t>(exemplar)};
}

Source exactSource(const fs::path& path, const ImageView& image, const std::vector<Size>& sizes, int x,
                   int y) {
    const auto number = [&](int channel) {
        return std::round(static_cast<double>(image(x, y, channel)) * 65535);
    };
    if (number(2) == Source::kNone)
        return {};
    const std::uint16_t exemplar = pixelIndex(path, number(2), static_cast<int>(sizes.size()), x, y);
    return {pixelIndex(path, number(0), sizes[exemplar].width, x, y),
            pixelIndex(path, number(1), sizes[exemplar].height, x, y), exemplar};
}

/// Whether an EXR's compression changes values.
bool losesValues(const std::string& compression) {
    const auto begins = [&](const char* name) { return compression.starts_with(name); };
    return begins("dwa") || begins("b44") || begins("pxr24");
}

void checkMapFile(const fs::path& path, MapFormat format, const ImageFileInfo& info) {
    if (format == MapFormat::StMap && losesValues(info.compression))
        fail("{} is compressed with loss ({}), which moves the places that a map addresses; save it with "
             "zip, piz or none.",
             path.string(), info.compression);
    if (format == MapFormat::StMap && (info.channels < 2 || info.depth != "float"))
        fail("{} is not a position map: an STMap has 2 to 4 channels of 32-bit floats, but this file has {} "
             "of {}.",
             path.string(), info.channels, info.depth);
    if (format == MapFormat::Exact && (info.channels != 3 || info.depth != "16-bit"))
        fail("{} is not a position map: as a PNG it has 3 channels of 16 bits, but this file has {} of {}.",
             path.string(), info.channels, info.depth);
}

} // namespace

void writePositionMap(const fs::path& path, const PositionMap& map, const std::string& recipe,
                      const std::function<void()>& check) {
    WriteOptions options;
    options.space = "raw";
    options.recipe = recipe;
    options.check = check;
    options.attributes = {{kSizesAttribute, sizesText(map.exemplarSizes())},
                          {"texloom:convention", mapConvention(path)}};
    if (mapFormatFor(path) == MapFormat::StMap) {
        options.depth = Depth::Float;
        writeImage(
            path, map.size(), 4, [&map](int y, float* row) { stMapRow(map, y, row); }, options);
    } else {
        options.depth = Depth::Bits16;
        writeImage(
            path, map.size(), 3, [&map](int y, float* row) { exactRow(map, y, row); }, options);
    }
}

PositionMap readPositionMap(const fs::path& path, const std::vector<Size>& exemplarSizes,
                            const std::string& layer) {
    const LoadedImage file = readImage(path, {kLargestFilePixels, layer, true});
    const MapFormat format = file.info.format == "openexr" ? MapFormat::StMap : mapFormatFor(path);
    checkMapFile(path, format, file.info);
    std::vector<Size> sizes = parseSizes(textOf(file.info, kSizesAttribute));
    if (sizes.empty())
        sizes = exemplarSizes;
    if (sizes.empty())
        fail("{} does not say the size of its exemplar; name the exemplar too.", path.string());
    for (const Size& size : sizes)
        if (size.empty() || size.longerSide() >= Source::kNone)
            fail("{} names an exemplar of {} × {} px; sides go from 1 to {} px.", path.string(), size.width,
                 size.height, Source::kNone - 1);
    PositionMap map(file.info.size, sizes);
    const ImageView image = file.image;
    for (int y = 0; y < map.height(); ++y)
        for (int x = 0; x < map.width(); ++x)
            map.at(x, y) = format == MapFormat::StMap ? stMapSource(path, image, sizes, x, y)
                                                      : exactSource(path, image, sizes, x, y);
    return map;
}

std::optional<Image> readFractionalMap(const fs::path& path, const std::vector<Size>& exemplarSizes,
                                       const std::string& layer) {
    LoadedImage file = readImage(path, {kLargestFilePixels, layer, true});
    if (file.info.format != "openexr" || !textOf(file.info, kSizesAttribute).empty())
        return std::nullopt;
    checkMapFile(path, MapFormat::StMap, file.info);
    if (addressesPixels(file.image, exemplarSizes))
        return std::nullopt;
    return std::move(file.image);
}

std::string mapConvention(const fs::path& path) {
    if (mapFormatFor(path) == MapFormat::StMap)
        return "STMap, 32-bit float: R = (x + 0.5) / width, G = 1 - (y + 0.5) / height with the origin at "
               "the bottom left, B = exemplar from 0, A = 1 where there is a source";
    return "16-bit RGB: R = x and G = y in pixels from the top left, B = exemplar from 0; 65535 = none";
}

} // namespace texloom
