#include "tests/core/io/foreign_files.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
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

/// The smallest ICC profile with a description.
Bytes profile(const std::string& description) {
    Bytes tag;
    append(tag, "desc");
    append(tag, 0);
    append(tag, static_cast<std::uint32_t>(description.size() + 1));
    append(tag, description);
    tag.resize(12 + description.size() + 1 + 78);
    Bytes bytes;
    append(bytes, static_cast<std::uint32_t>(128 + 16 + tag.size()));
    append(bytes, "lcms");
    append(bytes, 0x02400000);
    append(bytes, "mntrRGB XYZ ");
    bytes.resize(36);
    append(bytes, "acsp");
    bytes.resize(68);
    for (const std::uint32_t illuminant : {0xf6d6U, 0x10000U, 0xd32dU}) // D50
        append(bytes, illuminant);
    bytes.resize(128);
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

using Chunks = std::vector<std::pair<std::string, Bytes>>;

void writePng(const std::filesystem::path& path, std::uint32_t width, std::uint32_t height,
              std::uint8_t colorType, const Chunks& chunks, const Bytes& rows) {
    Bytes png;
    append(png, "\x89PNG\r\n\x1a\n");
    Bytes header;
    append(header, width);
    append(header, height);
    header.insert(header.end(), {8, colorType, 0, 0, 0});
    appendChunk(png, "IHDR", header);
    for (const auto& [name, content] : chunks)
        appendChunk(png, name, content);
    appendChunk(png, "IDAT", stored(rows));
    appendChunk(png, "IEND", {});
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(png.data()), static_cast<std::streamsize>(png.size()));
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
                         floating ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8);
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

namespace {

void appendLittle(Bytes& bytes, std::uint32_t number, int count) {
    for (int i = 0; i < count; ++i)
        bytes.push_back(static_cast<std::uint8_t>(number >> (8 * i)));
}

} // namespace

void writePaletteTiff(const std::filesystem::path& path) {
    constexpr std::uint32_t kWidth = 64, kHeight = 48, kEntries = 10;
    constexpr std::uint32_t kColours = 8 + 2 + kEntries * 12 + 4, kPixels = kColours + 12;
    constexpr std::uint32_t kShort = 3, kLong = 4;
    const std::array<std::array<std::uint32_t, 4>, kEntries> entries = {
        {{256, kLong, 1, kWidth},
         {257, kLong, 1, kHeight},
         {258, kShort, 1, 1},
         {259, kShort, 1, 1}, // not compressed
         {262, kShort, 1, 3}, // palette
         {273, kLong, 1, kPixels},
         {277, kShort, 1, 1},
         {278, kLong, 1, kHeight},
         {279, kLong, 1, kWidth / 8 * kHeight},
         {320, kShort, 6, kColours}}};
    Bytes tiff = {'I', 'I', 42, 0, 8, 0, 0, 0, kEntries, 0};
    for (const auto& [tag, type, count, value] : entries) {
        appendLittle(tiff, tag, 2);
        appendLittle(tiff, type, 2);
        appendLittle(tiff, count, 4);
        appendLittle(tiff, value, 4);
    }
    appendLittle(tiff, 0, 4);
    for (const std::uint32_t level : {0xffffU, 0U, 0U, 0U, 0U, 0xffffU}) // both reds, greens, blues
        appendLittle(tiff, level, 2);
    for (std::uint32_t y = 0; y < kHeight; ++y)
        for (std::uint32_t byte = 0; byte < kWidth / 8; ++byte)
            tiff.push_back(byte < kWidth / 16 ? 0 : 0xff);
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(tiff.data()), static_cast<std::streamsize>(tiff.size()));
}

void writeEmptyTiff(const std::filesystem::path& path, std::uint32_t side, bool whole) {
    Bytes tiff = {'I', 'I', 42, 0, 8, 0, 0, 0, 9, 0};
    const auto little = [&tiff](std::uint32_t number, int bytes) { appendLittle(tiff, number, bytes); };
    constexpr std::uint32_t kBits = 8 + 2 + 9 * 12 + 4, kPixels = kBits + 6;
    const auto entry = [&](std::uint32_t tag, std::uint32_t type, std::uint32_t count, std::uint32_t value) {
        little(tag, 2);
        little(type, 2);
        little(count, 4);
        little(value, 4);
    };
    constexpr std::uint32_t kShort = 3, kLong = 4;
    entry(256, kLong, 1, side);
    entry(257, kLong, 1, side);
    entry(258, kShort, 3, kBits);
    entry(259, kShort, 1, 1); // not compressed
    entry(262, kShort, 1, 2); // RGB
    entry(273, kLong, 1, kPixels);
    entry(277, kShort, 1, 3);
    entry(278, kLong, 1, side);
    entry(279, kLong, 1, side * side * 3);
    little(0, 4);
    for (int i = 0; i < 3; ++i)
        little(8, 2);
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(tiff.data()), static_cast<std::streamsize>(tiff.size()));
    if (whole)
        std::filesystem::resize_file(path, kPixels + std::uintmax_t{side} * side * 3);
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
