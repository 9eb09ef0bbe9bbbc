#include "core/base/error.h"
#include "core/base/text.h"
#include "core/io/image_file.h"
#include "core/io/temporary_file.h"

#include <OpenImageIO/hash.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

namespace texloom {

namespace fs = std::filesystem;

namespace {

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using FileHandle = std::unique_ptr<std::FILE, CloseFile>;

FileHandle openForReading(const fs::path& path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (fs::exists(status) && !fs::is_regular_file(status))
        fail("{} is {}.", path.string(), fs::is_directory(status) ? "a folder" : "no ordinary file");
    FileHandle file(std::fopen(path.c_str(), "rb"));
    if (!file)
        fail("{} cannot be read: {}.", path.string(), std::strerror(errno));
    return file;
}

} // namespace

std::string fileHash(const fs::path& path) {
    const FileHandle file = openForReading(path);
    OIIO::SHA1 hash;
    std::array<char, 1 << 16> block{};
    while (const std::size_t count = std::fread(block.data(), 1, block.size(), file.get()))
        hash.append(block.data(), count);
    if (std::ferror(file.get()))
        fail("{} cannot be read: {}.", path.string(), std::strerror(errno));
    return hash.digest();
}

std::string bytesHash(std::string_view bytes) {
    return OIIO::SHA1(bytes.data(), bytes.size()).digest();
}

void writeText(const fs::path& path, std::string_view text) {
    TemporaryFile temporary(path);
    temporary.write(text.data(), text.size(), 0);
    temporary.commit();
}

std::string readText(const fs::path& path, std::uintmax_t largestBytes) {
    const FileHandle file = openForReading(path);
    std::string text;
    std::array<char, 1 << 16> block{};
    while (const std::size_t count = std::fread(block.data(), 1, block.size(), file.get())) {
        text.append(block.data(), count);
        if (text.size() > largestBytes)
            fail("{} is longer than {}, too long for what it should be.", path.string(),
                 byteText(largestBytes));
    }
    if (std::ferror(file.get()))
        fail("{} cannot be read: {}.", path.string(), std::strerror(errno));
    return text;
}

} // namespace texloom
