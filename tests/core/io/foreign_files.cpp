#include "tests/core/io/foreign_files.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

namespace texloom::test {

namespace {

using Bytes = std::vector<std::uint8_t>;

void append(Bytes& bytes, std::uint32_t number) {
    for (const int shift : {24, 16, 8, 0})
        bytes.push_back(static_cast<std::uint8_t>(number >> shift));
}

void append(Bytes& bytes, std::string_view text) {
    bytes.insert(bytes.end(), text.begin(), text.end());
}

/// What an ICC profile of so many bytes begins with; the list of its tags follows.
Bytes profileHead(std::uint32_t whole) {
    Bytes bytes;
    append(bytes, whole);
    append(bytes, "lcms");
    append(bytes, 0x02400000);
    append(bytes, "mntrRGB XYZ ");
    bytes.resize(36);
    append(bytes, "acsp");
    bytes.resize(68);
    for (const std::uint32_t illuminant : {0xf6d6U, 0x10000U, 0xd32dU}) // D50
        append(bytes, illuminant);
    bytes.resize(128);
    return bytes;
}

/// The smallest ICC profile with a description.
Bytes profile(const std::string& description) {
    Bytes tag;
    append(tag, "desc");
    append(tag, 0);
    append(tag, static_cast<std::uint32_t>(description.size() + 1));
    append(tag, description);
    tag.resize(12 + description.size() + 1 + 78);
    Bytes bytes = profileHead(static_cast<std::uint32_t>(128 + 16 + tag.size()));
    append(bytes, 1);
    append(bytes, "desc");
    append(bytes, 128 + 16);
    append(bytes, static_cast<std::uint32_t>(tag.size()));
    bytes.insert(bytes.end(), tag.begin(), tag.end());
    return bytes;
}

std::uint32_t crc(const Bytes& bytes, std::size_t first) {
    std::uint32_t sum = 0xffffffff;
    for (std::size_t i = first; i < bytes.size(); ++i) {
        sum ^= bytes[i];
        for (int bit = 0; bit < 8; ++bit)
            sum = (sum >> 1) ^ ((sum & 1U) != 0 ? 0xedb88320U : 0U);
    }
    return ~sum;
}

void appendChunk(Bytes& png, std::string_view name, const Bytes& content) {
    append(png, static_cast<std::uint32_t>(content.size()));
    const std::size_t first = png.size();
    append(png, name);
    png.insert(png.end(), content.begin(), content.end());
    append(png, crc(png, first));
}

/// A zlib stream that holds the bytes as they are.
Bytes stored(const Bytes& plain) {
    const auto length = static_cast<std::uint8_t>(plain.size());
    Bytes bytes = {0x78, 0x01, 0x01, length, 0, static_cast<std::uint8_t>(~length), 0xff};
    std::uint32_t a = 1, b = 0;
    for (const std::uint8_t byte : plain) {
        bytes.push_back(byte);
        a = (a + byte) % 65521;
        b = (b + a) % 65521;
    }
    append(bytes, (b << 16) | a);
    return bytes;
}

void put(const std::filesystem::path& path, const Bytes& bytes) {
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

/// A TIFF of Intel's order as it grows.
struct LittleTiff {
    explicit LittleTiff(std::uint32_t entries) { number(entries, 2); }

    void number(std::uint32_t value, int size) {
        for (int i = 0; i < size; ++i)
            bytes.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
    }
    void entry(std::uint32_t tag, std::uint32_t type, std::uint32_t count, std::uint32_t value) {
        number(tag, 2);
        number(type, 2);
        number(count, 4);
        number(value, 4);
    }

    Bytes bytes = {'I', 'I', 42, 0, 8, 0, 0, 0};
};

using Chunks = std::vector<std::pair<std::string, Bytes>>;

void writePng(const std::filesystem::path& path, std::uint32_t width, std::uint32_t height,
              std::uint8_t colorType, const Chunks& chunks, const Bytes& rows, std::uint8_t bits = 8) {
    Bytes png;
    append(png, "\x89PNG\r\n\x1a\n");
    Bytes header;
    append(header, width);
    append(header, height);
    header.insert(header.end(), {bits, colorType, 0, 0, 0});
    appendChunk(png, "IHDR", header);
    for (const auto& [name, content] : chunks)
        appendChunk(png, name, content);
    appendChunk(png, "IDAT", stored(rows));
    appendChunk(png, "IEND", {});
    put(path, png);
}

std::vector<float> samplesOf(const ImageView& image) {
    std::vector<float> samples;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (int c = 0; c < image.channels; ++c)
                samples.push_back(image(x, y, c));
    return samples;
}

void check(bool done, OIIO::ImageOutput* output) {
    if (!done)
        throw std::runtime_error("no foreign file: " + (output ? output->geterror() : OIIO::geterror()));
}

} // namespace

void writeForeign(const std::filesystem::path& path, const ImageView& image, const ForeignFile& file) {
    const bool floating = path.extension() == ".exr";
    OIIO::ImageSpec spec(image.width, image.height, image.channels,
                         !file.type.empty() ? OIIO::TypeDesc(file.type)
                         : floating         ? OIIO::TypeDesc::FLOAT
                                            : OIIO::TypeDesc::UINT8);
    if (!file.compression.empty())
        spec.attribute("compression", file.compression);
    if (file.progressive)
        spec.attribute("jpeg:progressive", 1);
    if (file.bits > 0)
        spec.attribute("oiio:BitsPerSample", file.bits);
    if (file.straightAlpha)
        spec.attribute("oiio:UnassociatedAlpha", 1);
    if (!file.profileBytes.empty())
        spec.attribute("ICCProfile",
                       OIIO::TypeDesc(OIIO::TypeDesc::UINT8, static_cast<int>(file.profileBytes.size())),
                       file.profileBytes.data());
    spec.attribute("Orientation", file.orientation);
    spec.x = file.x;
    spec.y = file.y;
    if (file.tiled)
        spec.tile_width = spec.tile_height = 16;
    if (!file.iccProfile.empty()) {
        const Bytes bytes = profile(file.iccProfile);
        spec.attribute("ICCProfile", OIIO::TypeDesc(OIIO::TypeDesc::UINT8, static_cast<int>(bytes.size())),
                       bytes.data());
    }
    if (!file.channelNames.empty())
        spec.channelnames = file.channelNames;
    if (!file.chromaticities.empty())
        spec.attribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8),
                       file.chromaticities.data());
    const std::vector<float> samples = samplesOf(image);
    const auto output = OIIO::ImageOutput::create(path.string());
    check(output && output->open(path.string(), spec) &&
              output->write_image(OIIO::TypeDesc::FLOAT, samples.data()) && output->close(),
          output.get());
}

std::vector<std::uint8_t> matrixProfile(double gamma) {
    const auto fixed = [](double number) { return static_cast<std::uint32_t>(std::lround(number * 65536)); };
    const auto xyz = [&](double x, double y, double z) {
        Bytes tag;
        append(tag, "XYZ ");
        append(tag, 0);
        for (const double value : {x, y, z})
            append(tag, fixed(value));
        return tag;
    };
    Bytes curve;
    append(curve, "curv");
    append(curve, 0);
    append(curve, 1);
    const auto power = static_cast<std::uint32_t>(std::lround(gamma * 256));
    curve.insert(curve.end(),
                 {static_cast<std::uint8_t>(power >> 8), static_cast<std::uint8_t>(power), 0, 0});
    const std::vector<std::pair<std::string_view, Bytes>> tags = {{"rXYZ", xyz(0.43607, 0.22249, 0.01392)},
                                                                  {"gXYZ", xyz(0.38515, 0.71687, 0.09708)},
                                                                  {"bXYZ", xyz(0.14307, 0.06061, 0.7141)},
                                                                  {"wtpt", xyz(0.9642, 1, 0.82491)},
                                                                  {"rTRC", curve},
                                                                  {"gTRC", curve},
                                                                  {"bTRC", curve}};
    std::uint32_t at = 128 + 4 + 12 * static_cast<std::uint32_t>(tags.size()), whole = at;
    for (const auto& [name, tag] : tags)
        whole += static_cast<std::uint32_t>(tag.size());
    Bytes bytes = profileHead(whole);
    append(bytes, static_cast<std::uint32_t>(tags.size()));
    for (const auto& [name, tag] : tags) {
        append(bytes, name);
        append(bytes, at);
        append(bytes, static_cast<std::uint32_t>(tag.size()));
        at += static_cast<std::uint32_t>(tag.size());
    }
    for (const auto& [name, tag] : tags)
        bytes.insert(bytes.end(), tag.begin(), tag.end());
    return bytes;
}

void writeGreyPng(const std::filesystem::path& path, int bits, const std::vector<std::uint8_t>& bytes) {
    Bytes row = {0};
    row.insert(row.end(), bytes.begin(), bytes.end());
    writePng(path, static_cast<std::uint32_t>(bytes.size() * 8) / static_cast<std::uint32_t>(bits), 1, 0, {},
             row, static_cast<std::uint8_t>(bits));
}

void writeTurnedPng(const std::filesystem::path& path) {
    constexpr std::uint8_t kTag = 0x12, kShort = 3, kToTheRight = 6;
    const Bytes exif = {'M',    'M', 0, 42, 0, 0, 0,           8, 0, 1, 1, kTag, 0,
                        kShort, 0,   0, 0,  1, 0, kToTheRight, 0, 0, 0, 0, 0,    0};
    writePng(path, 3, 1, 2, {{"eXIf", exif}}, {0, 255, 255, 255, 0, 0, 0, 0, 0, 0});
}

void writeOrderedHdr(const std::filesystem::path& path, const std::string& order) {
    Bytes file;
    append(file, "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n" + order + "\n");
    file.insert(file.end(), {128, 128, 128, 129});
    file.resize(file.size() + 5 * 4);
    put(path, file);
}

void writePages(const std::filesystem::path& path, const std::vector<ImageView>& pages) {
    const auto output = OIIO::ImageOutput::create(path.string());
    for (std::size_t i = 0; i < pages.size(); ++i) {
        const OIIO::ImageSpec spec(pages[i].width, pages[i].height, pages[i].channels, OIIO::TypeDesc::UINT8);
        const std::vector<float> samples = samplesOf(pages[i]);
        check(output &&
                  output->open(path.string(), spec,
                               i == 0 ? OIIO::ImageOutput::Create : OIIO::ImageOutput::AppendSubimage) &&
                  output->write_image(OIIO::TypeDesc::FLOAT, samples.data()),
              output.get());
    }
    check(output->close(), output.get());
}

void writeParts(const std::filesystem::path& path, const std::vector<ImageView>& images,
                const std::vector<std::string>& names) {
    std::vector<OIIO::ImageSpec> specs;
    for (std::size_t i = 0; i < images.size(); ++i) {
        specs.emplace_back(images[i].width, images[i].height, images[i].channels, OIIO::TypeDesc::FLOAT);
        specs.back().attribute("oiio:subimagename", names[i]);
    }
    const auto output = OIIO::ImageOutput::create(path.string());
    check(output && output->open(path.string(), static_cast<int>(specs.size()), specs.data()), output.get());
    for (std::size_t i = 0; i < images.size(); ++i) {
        const std::vector<float> samples = samplesOf(images[i]);
        check(i == 0 || output->open(path.string(), specs[i], OIIO::ImageOutput::AppendSubimage),
              output.get());
        check(output->write_image(OIIO::TypeDesc::FLOAT, samples.data()), output.get());
    }
    check(output->close(), output.get());
}

void writeWideTiff(const std::filesystem::path& path, Size size, const std::vector<std::uint32_t>& numbers) {
    const OIIO::ImageSpec spec(size.width, size.height, 1, OIIO::TypeDesc::UINT32);
    const auto output = OIIO::ImageOutput::create(path.string());
    check(output && output->open(path.string(), spec) &&
              output->write_image(OIIO::TypeDesc::UINT32, numbers.data()) && output->close(),
          output.get());
}

void writeWideExr(const std::filesystem::path& path, Size size, const std::vector<std::uint32_t>& numbers) {
    OIIO::ImageSpec spec(size.width, size.height, 1, OIIO::TypeDesc::UINT32);
    spec.channelnames = {"Y"};
    const auto output = OIIO::ImageOutput::create(path.string());
    check(output && output->open(path.string(), spec) &&
              output->write_image(OIIO::TypeDesc::UINT32, numbers.data()) && output->close(),
          output.get());
}

void writeBilevelTiff(const std::filesystem::path& path, const std::vector<std::uint8_t>& bytes) {
    constexpr std::uint32_t kEntries = 9, kShort = 3, kLong = 4;
    const auto length = static_cast<std::uint32_t>(bytes.size());
    LittleTiff tiff(kEntries);
    tiff.entry(256, kLong, 1, 8 * length);
    tiff.entry(257, kLong, 1, 1);
    tiff.entry(258, kShort, 1, 1);
    tiff.entry(259, kShort, 1, 1); // not compressed
    tiff.entry(262, kShort, 1, 1); // 0 is black
    tiff.entry(273, kLong, 1, 8 + 2 + kEntries * 12 + 4);
    tiff.entry(277, kShort, 1, 1);
    tiff.entry(278, kLong, 1, 1);
    tiff.entry(279, kLong, 1, length);
    tiff.number(0, 4);
    tiff.bytes.insert(tiff.bytes.end(), bytes.begin(), bytes.end());
    put(path, tiff.bytes);
}

void writePaletteTiff(const std::filesystem::path& path) {
    constexpr std::uint32_t kWidth = 64, kHeight = 48, kEntries = 10, kShort = 3, kLong = 4;
    constexpr std::uint32_t kColours = 8 + 2 + kEntries * 12 + 4, kPixels = kColours + 12;
    LittleTiff tiff(kEntries);
    tiff.entry(256, kLong, 1, kWidth);
    tiff.entry(257, kLong, 1, kHeight);
    tiff.entry(258, kShort, 1, 1);
    tiff.entry(259, kShort, 1, 1); // not compressed
    tiff.entry(262, kShort, 1, 3); // palette
    tiff.entry(273, kLong, 1, kPixels);
    tiff.entry(277, kShort, 1, 1);
    tiff.entry(278, kLong, 1, kHeight);
    tiff.entry(279, kLong, 1, kWidth / 8 * kHeight);
    tiff.entry(320, kShort, 6, kColours);
    tiff.number(0, 4);
    for (const std::uint32_t level : {0xffffU, 0U, 0U, 0U, 0U, 0xffffU}) // both reds, greens, blues
        tiff.number(level, 2);
    for (std::uint32_t y = 0; y < kHeight; ++y)
        for (std::uint32_t byte = 0; byte < kWidth / 8; ++byte)
            tiff.bytes.push_back(byte < kWidth / 16 ? 0 : 0xff);
    put(path, tiff.bytes);
}

void writeEmptyTiff(const std::filesystem::path& path, std::uint32_t side, bool whole) {
    constexpr std::uint32_t kEntries = 9, kBits = 8 + 2 + kEntries * 12 + 4, kPixels = kBits + 6;
    constexpr std::uint32_t kShort = 3, kLong = 4;
    LittleTiff tiff(kEntries);
    tiff.entry(256, kLong, 1, side);
    tiff.entry(257, kLong, 1, side);
    tiff.entry(258, kShort, 3, kBits);
    tiff.entry(259, kShort, 1, 1); // not compressed
    tiff.entry(262, kShort, 1, 2); // RGB
    tiff.entry(273, kLong, 1, kPixels);
    tiff.entry(277, kShort, 1, 3);
    tiff.entry(278, kLong, 1, side);
    tiff.entry(279, kLong, 1, side * side * 3);
    tiff.number(0, 4);
    for (int i = 0; i < 3; ++i)
        tiff.number(8, 2);
    put(path, tiff.bytes);
    if (whole)
        std::filesystem::resize_file(path, kPixels + std::uintmax_t{side} * side * 3);
}

namespace {

/// A baseline JPEG of four channels, all of one value: the shortest tables there are.
Bytes plainInkJpeg(std::uint8_t side) {
    Bytes jpeg = {0xff, 0xd8, 0xff, 0xdb, 0, 67, 0};
    jpeg.insert(jpeg.end(), 64, 1);                      // each value as it is
    for (const std::uint8_t table : Bytes{0x00, 0x10}) { // one code each: no difference, end of block
        jpeg.insert(jpeg.end(), {0xff, 0xc4, 0, 20, table, 1});
        jpeg.insert(jpeg.end(), 16, 0);
    }
    jpeg.insert(jpeg.end(), {0xff, 0xc0, 0, 20, 8, 0, side, 0, side, 4});
    for (std::uint8_t channel = 1; channel <= 4; ++channel)
        jpeg.insert(jpeg.end(), {channel, 0x11, 0});
    jpeg.insert(jpeg.end(), {0xff, 0xda, 0, 14, 4, 1, 0, 2, 0, 3, 0, 4, 0, 0, 63, 0});
    const std::size_t blocks = 4U * (side / 8U) * (side / 8U);
    jpeg.insert(jpeg.end(), 2 * blocks / 8, 0); // two codes of one bit each
    jpeg.insert(jpeg.end(), {0xff, 0xd9});
    return jpeg;
}

} // namespace

void writeTiledInkTiff(const std::filesystem::path& path) {
    constexpr std::uint32_t kSide = 64, kTile = 32, kTiles = 4, kShort = 3, kLong = 4, kEntries = 11;
    constexpr std::uint32_t kBits = 8 + 2 + kEntries * 12 + 4, kOffsets = kBits + 8,
                            kCounts = kOffsets + 4 * kTiles, kFirst = kCounts + 4 * kTiles;
    const Bytes tile = plainInkJpeg(kTile);
    const auto length = static_cast<std::uint32_t>(tile.size());
    LittleTiff tiff(kEntries);
    tiff.entry(256, kLong, 1, kSide);
    tiff.entry(257, kLong, 1, kSide);
    tiff.entry(258, kShort, 4, kBits);
    tiff.entry(259, kShort, 1, 7); // JPEG
    tiff.entry(262, kShort, 1, 5); // ink
    tiff.entry(277, kShort, 1, 4);
    tiff.entry(284, kShort, 1, 1);
    tiff.entry(322, kLong, 1, kTile);
    tiff.entry(323, kLong, 1, kTile);
    tiff.entry(324, kLong, kTiles, kOffsets);
    tiff.entry(325, kLong, kTiles, kCounts);
    tiff.number(0, 4);
    for (int i = 0; i < 4; ++i)
        tiff.number(8, 2);
    for (std::uint32_t i = 0; i < kTiles; ++i)
        tiff.number(kFirst + i * length, 4);
    for (std::uint32_t i = 0; i < kTiles; ++i)
        tiff.number(length, 4);
    for (std::uint32_t i = 0; i < kTiles; ++i)
        tiff.bytes.insert(tiff.bytes.end(), tile.begin(), tile.end());
    put(path, tiff.bytes);
}

void writeTaggedPng(const std::filesystem::path& path, const std::array<std::uint8_t, 3>& color,
                    const std::vector<std::pair<std::string, std::vector<std::uint8_t>>>& chunks) {
    writePng(path, 1, 1, 2, chunks, {0, color[0], color[1], color[2]});
}

void writePalettePng(const std::filesystem::path& path) {
    writePng(path, 3, 2, 3, {{"PLTE", {255, 0, 0, 0, 255, 0, 0, 0, 255}}}, {0, 0, 1, 2, 0, 2, 1, 0});
}

void writeHugePngHeader(const std::filesystem::path& path, std::uint32_t width, std::uint32_t height) {
    writePng(path, width, height, 2, {}, {0, 0, 0, 0});
}

} // namespace texloom::test
