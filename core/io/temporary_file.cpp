#include "core/io/temporary_file.h"

#include "core/base/error.h"

#include <OpenImageIO/hash.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

namespace texloom {

namespace fs = std::filesystem;

namespace {

constexpr mode_t kPermissions = 0666; // less what the user's mask takes away

[[noreturn]] void failWriting(const fs::path& file, int error) {
    fail("{} cannot be written: {}.", file.string(), std::strerror(error));
}

} // namespace

TemporaryFile::TemporaryFile(const fs::path& target) : m_target(target) {
    const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
    std::error_code error;
    if (!fs::is_directory(folder, error))
        fail("{} cannot be written: there is no folder {}.", target.string(), folder.string());
    static std::atomic<int> count = 0;
    // In a shared folder a process of another machine may have this one's number.
    do {
        m_path = folder / fmt::format(".texloom-{}-{}{}", ::getpid(), count++, target.extension().string());
        m_handle = ::open(m_path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, kPermissions);
    } while (m_handle < 0 && errno == EEXIST);
    if (m_handle < 0)
        failWriting(target, errno);
}

TemporaryFile::~TemporaryFile() {
    if (m_handle >= 0)
        ::close(m_handle);
    std::error_code ignored;
    fs::remove(m_path, ignored);
}

std::size_t TemporaryFile::write(const void* data, std::size_t size, std::int64_t offset) {
    std::size_t written = 0;
    while (written < size) {
        const ssize_t count = ::pwrite(m_handle, static_cast<const char*>(data) + written, size - written,
                                       offset + static_cast<std::int64_t>(written));
        if (count < 0 && errno == EINTR)
            continue;
        if (count <= 0) {
            m_error = m_error != 0 ? m_error : count < 0 ? errno : ENOSPC;
            break;
        }
        written += static_cast<std::size_t>(count);
    }
    return written;
}

std::size_t TemporaryFile::read(void* data, std::size_t size, std::int64_t offset) const {
    const ssize_t count = ::pread(m_handle, data, size, offset);
    return count > 0 ? static_cast<std::size_t>(count) : 0;
}

std::size_t TemporaryFile::size() const {
    struct stat status {};
    return ::fstat(m_handle, &status) == 0 ? static_cast<std::size_t>(status.st_size) : 0;
}

std::string TemporaryFile::hash() const {
    OIIO::SHA1 hash;
    std::array<char, 1 << 16> block{};
    std::int64_t offset = 0;
    while (const std::size_t count = read(block.data(), block.size(), offset)) {
        hash.append(block.data(), count);
        offset += static_cast<std::int64_t>(count);
    }
    return hash.digest();
}

void TemporaryFile::commit() {
    if (m_error != 0)
        failWriting(m_target, m_error);
    if (::fsync(m_handle) != 0)
        failWriting(m_target, errno);
    if (::close(std::exchange(m_handle, -1)) != 0)
        failWriting(m_target, errno);
    std::error_code error;
    fs::rename(m_path, m_target, error);
    if (error)
        failWriting(m_target, error.value());
}

} // namespace texloom
