#include "core/io/temporary_file.h"

#include "core/base/error.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <system_error>

namespace texloom {

namespace fs = std::filesystem;

namespace {

fs::path folderOf(const fs::path& file) {
    return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

void flushToDisk(const fs::path& file) {
    const int handle = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
    const bool flushed = handle >= 0 && ::fsync(handle) == 0;
    const int error = errno;
    if (handle >= 0)
        ::close(handle);
    if (!flushed)
        throw std::system_error(error, std::generic_category());
}

} // namespace

TemporaryFile::TemporaryFile(const fs::path& target) : m_target(target) {
    const fs::path folder = folderOf(target);
    if (!fs::is_directory(folder))
        fail("{} cannot be written: there is no folder {}.", target.string(), folder.string());
    static std::atomic<int> count = 0;
    m_path = folder / fmt::format(".{}.{}-{}{}", target.stem().string(), ::getpid(), count++,
                                  target.extension().string());
}

TemporaryFile::~TemporaryFile() {
    std::error_code ignored;
    fs::remove(m_path, ignored);
}

void TemporaryFile::commit() {
    try {
        flushToDisk(m_path);
        fs::rename(m_path, m_target);
    } catch (const std::system_error& error) {
        fail("{} cannot be written: {}.", m_target.string(), error.code().message());
    }
}

} // namespace texloom
