#include "core/io/file_reader.h"

#include "core/base/error.h"

#include <sys/types.h>

#include <cerrno>
#include <cstring>
#include <system_error>

namespace texloom {

namespace fs = std::filesystem;

FileReader::FileReader(const fs::path& path) : m_path(path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (fs::is_directory(status))
        fail("{} is a folder, not a file.", path.string());
    if (fs::exists(status) && !fs::is_regular_file(status))
        fail("{} is not an ordinary file, so it is not read.", path.string());
    m_file.reset(std::fopen(path.c_str(), "rb"));
    if (!m_file)
        fail("{} cannot be read: {}.", path.string(), std::strerror(errno));
    const std::uintmax_t size = fs::file_size(path, error);
    m_size = error ? 0 : size;
}

std::size_t FileReader::next(void* data, std::size_t size) {
    const std::size_t count = std::fread(data, 1, size, m_file.get());
    if (std::ferror(m_file.get()))
        fail("{} cannot be read: {}.", m_path.string(), std::strerror(errno));
    return count;
}

void FileReader::read(void* data, std::size_t size, std::uint64_t offset) {
    if (::fseeko(m_file.get(), static_cast<off_t>(offset), SEEK_SET) != 0)
        fail("{} cannot be read: {}.", m_path.string(), std::strerror(errno));
    if (next(data, size) != size)
        fail("{} became shorter while it was read.", m_path.string());
}

} // namespace texloom
