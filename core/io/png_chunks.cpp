#include "core/io/png_chunks.h"

#include <cstdint>
#include <fstream>
#include <string>
#include <string_view>

namespace texloom {

namespace {

std::uint32_t numberAt(std::string_view bytes, std::size_t at) {
    std::uint32_t number = 0;
    for (std::size_t i = 0; i < 4; ++i)
        number = number << 8 | static_cast<unsigned char>(bytes[at + i]);
    return number;
}

void take(PngColor& color, std::string_view name, std::string_view data) {
    constexpr double kUnit = 100000;
    if (name == "sRGB") {
        color.srgb = true;
    } else if (name == "gAMA" && data.size() == 4) {
        if (const std::uint32_t gamma = numberAt(data, 0); gamma > 0)
            color.gamma = gamma / kUnit;
    } else if (name == "cHRM" && data.size() == 32) {
        const auto at = [data](std::size_t i) { return numberAt(data, 4 * i) / kUnit; };
        color.primaries = Chromaticities{at(2), at(3), at(4), at(5), at(6), at(7), at(0), at(1)};
    } else if (name == "cICP" && data.size() == 4) {
        color.codes.emplace();
        for (std::size_t i = 0; i < 4; ++i)
            (*color.codes)[i] = static_cast<unsigned char>(data[i]);
    }
}

} // namespace

PngColor readPngColor(const std::filesystem::path& path) {
    constexpr std::streamoff kSignature = 8;
    constexpr std::uint32_t kLongest = 64; // of the chunks that count here
    PngColor color;
    std::ifstream file(path, std::ios::binary);
    file.seekg(kSignature);
    std::string head(8, '\0');
    while (file.read(head.data(), 8) && head.substr(4) != "IDAT") {
        const std::uint32_t length = numberAt(head, 0);
        if (length > kLongest) {
            file.seekg(static_cast<std::streamoff>(length) + 4, std::ios::cur);
            continue;
        }
        std::string data(length + 4, '\0'); // with its checksum
        if (file.read(data.data(), static_cast<std::streamsize>(data.size())))
            take(color, std::string_view(head).substr(4), std::string_view(data).substr(0, length));
    }
    return color;
}

} // namespace texloom
