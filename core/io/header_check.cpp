#include "core/io/header_check.h"

#include "core/base/error.h"
#include "core/base/text.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <span>
#include <string_view>
#include <system_error>

namespace texloom {

namespace fs = std::filesystem;

namespace {

/// The decoder makes a table of all lines before anyone can ask for the size, so that a forged header of a
/// few bytes would take gigabytes: the data window is read here first.
void checkExrWindow(const fs::path& path) {
    constexpr std::size_t kHead = 1 << 16;
    constexpr std::int64_t kLongestSide = 1 << 17;
    constexpr std::string_view kName("dataWindow\0box2i\0\x10\0\0\0", 21);
    std::string head(kHead, '\0');
    std::ifstream file(path, std::ios::binary);
    file.read(head.data(), static_cast<std::streamsize>(head.size()));
    for (std::size_t at = head.find(kName); at != std::string::npos; at = head.find(kName, at + 1)) {
        std::array<std::int32_t, 4> box{};
        if (at + kName.size() + sizeof(box) > head.size())
            return;
        std::memcpy(box.data(), head.data() + at + kName.size(), sizeof(box));
        const std::int64_t width = std::int64_t{box[2]} - box[0] + 1,
                           height = std::int64_t{box[3]} - box[1] + 1;
        if (width > kLongestSide || height > kLongestSide)
            fail("{} says it is {} × {} px; an EXR's sides can go up to {} px.", path.string(), width, height,
                 grouped(kLongestSide));
    }
}

/// Decoders take memory for as many bytes as an entry of a header says that it has, before they find out that
/// the file is shorter: sizes are held against the file's before it is decoded.
class HeaderEntries {
public:
    /// @param first offset of the first entry.
    HeaderEntries(const fs::path& path, std::streamoff first) : m_path(path), m_file(path, std::ios::binary) {
        std::error_code error;
        m_whole = fs::file_size(path, error);
        m_file.seekg(first);
    }

    /// Whether there was as much to read.
    bool read(std::span<char> bytes) {
        return static_cast<bool>(m_file.read(bytes.data(), static_cast<std::streamsize>(bytes.size())));
    }
    /// Up to the next zero, which is read, too.
    std::string word() {
        std::string text;
        std::getline(m_file, text, '\0');
        return text;
    }
    /// Goes on behind an entry of this size and `more` bytes. @throws Error if the file cannot hold it.
    void skip(std::int64_t size, int more = 0) {
        if (size < 0 || static_cast<std::uintmax_t>(size) > m_whole)
            fail("{} is damaged: an entry of its header says that it has {} bytes, but the file has {}.",
                 m_path.string(), size, m_whole);
        m_file.seekg(size + more, std::ios::cur);
    }

private:
    const fs::path& m_path;
    std::ifstream m_file;
    std::uintmax_t m_whole = 0;
};

/// The attributes of an EXR's first header: name, type, size and value behind eight bytes of its own.
void checkExrAttributes(const fs::path& path) {
    HeaderEntries entries(path, 8);
    while (!entries.word().empty()) {
        entries.word(); // type
        std::array<char, 4> bytes{};
        if (!entries.read(bytes))
            return;
        std::int32_t size = 0;
        std::memcpy(&size, bytes.data(), sizeof(size));
        entries.skip(size);
    }
}

/// The chunks of a PNG before its pixels: size, type, value and a checksum of four bytes behind the
/// signature.
void checkPngChunks(const fs::path& path) {
    HeaderEntries entries(path, 8);
    std::array<char, 8> head{};
    while (entries.read(head) && std::string_view(head.data() + 4, 4) != "IDAT") {
        std::uint32_t size = 0;
        for (int i = 0; i < 4; ++i)
            size = size << 8U | static_cast<unsigned char>(head.at(static_cast<std::size_t>(i)));
        entries.skip(size, 4);
    }
}

} // namespace

void checkHeader(const fs::path& path, const std::string& format) {
    if (format == "openexr") {
        checkExrAttributes(path);
        checkExrWindow(path);
    }
    if (format == "png")
        checkPngChunks(path);
}

} // namespace texloom
