#include "tests/core/io/foreign_files.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <fstream>
#include <stdexcept>
#include <string_view>
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

void writePng(const std::filesystem::path& path, std::uint32_t width, std::uint32_t height,
              std::uint8_t colorType, const Bytes& palette, const Bytes& rows) {
    Bytes png;
    append(png, "\x89PNG\r\n\x1a\n");
    Bytes header;
    append(header, width);
    append(header, height);
    header.insert(header.end(), {8, colorType, 0, 0, 0});
    appendChunk(png, "IHDR", header);
    if (!palette.empty())
        appendChunk(png, "PLTE", palette);
    appendChunk(png, "IDAT", stored(rows));
    appendChunk(png, "IEND", {});
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(png.data()), static_cast<std::streamsize>(png.size()));
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
    std::vector<float> samples;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (int c = 0; c < image.channels; ++c)
                samples.push_back(image(x, y, c));
    const auto output = OIIO::ImageOutput::create(path.string());
    if (!output || !output->open(path.string(), spec) ||
        !output->write_image(OIIO::TypeDesc::FLOAT, samples.data()) || !output->close())
        throw std::runtime_error("no foreign file: " + (output ? output->geterror() : OIIO::geterror()));
}

void writePalettePng(const std::filesystem::path& path) {
    writePng(path, 3, 2, 3, {255, 0, 0, 0, 255, 0, 0, 0, 255}, {0, 0, 1, 2, 0, 2, 1, 0});
}

void writeHugePngHeader(const std::filesystem::path& path, std::uint32_t width, std::uint32_t height) {
    writePng(path, width, height, 2, {}, {0, 0, 0, 0});
}

} // namespace texloom::test
