#include "core/io/temporary_file.h"

#include "core/base/error.h"
#include "core/base/folder_of.h"

#include <OpenImageIO/hash.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <ctime>
#include <mutex>
#include <set>
#include <system_error>
#include <utility>

namespace texloom {

namespace fs = std::filesystem;

namespace {

constexpr mode_t kPermissions = 0666; // less what the user's mask takes away

constexpr const char* kPrefix = ".texloom-";

/// What a name stands for behind all symbolic links, so that writing replaces the file and not the link.
fs::path linkTarget(fs::path file) {
    constexpr int kMostLinks = 40; // as many as the system follows
    std::error_code error;
    for (int links = 0; links < kMostLinks && fs::is_symlink(file, error); ++links) {
        const fs::path next = fs::read_symlink(file, error);
        file = next.is_absolute() ? next : folderOf(file) / next;
    }
    return file;
}

/// A file that replaces another belongs to the same people, as far as the system lets us.
void takeRights(int handle, const fs::path& target) {
    struct stat status {};
    if (::stat(target.c_str(), &status) != 0)
        return;
    if (::fchown(handle, status.st_uid, status.st_gid) != 0 && ::fchown(handle, status.st_uid, -1U) != 0)
        errno = 0; // only the system's keeper may give files away
    ::fchmod(handle, status.st_mode & 07777U);
}

/// Whether nobody holds a temporary file that has not changed for a while: its program was killed.
bool isAbandoned(const fs::path& file) {
    struct stat status {};
    constexpr time_t kOldest = 60;
    const int handle = ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
    if (handle < 0)
        return false;
    const bool abandoned = ::fstat(handle, &status) == 0 && S_ISREG(status.st_mode) &&
                           ::time(nullptr) - status.st_mtime > kOldest &&
                           ::flock(handle, LOCK_EX | LOCK_NB) == 0;
    ::close(handle);
    return abandoned;
}

/// Removes what killed programs left in a folder; once for each folder that this one writes to.
void sweepOnce(const fs::path& folder) {
    static std::mutex mutex;
    static std::set<fs::path> swept;
    std::error_code error;
    {
        const std::lock_guard<std::mutex> lock(mutex);
        if (!swept.insert(fs::weakly_canonical(folder, error)).second)
            return;
    }
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
        if (entry->path().filename().string().starts_with(kPrefix) && isAbandoned(entry->path()))
            ::unlink(entry->path().c_str());
}

/// Makes sure that a rename in a folder outlives a power cut.
void syncFolder(const fs::path& folder) {
    const int handle = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (handle < 0)
        return; // a folder that may be written to but not read
    ::fsync(handle);
    ::close(handle);
}

[[noreturn]] void failWriting(const fs::path& file, int error) {
    fail("{} cannot be written: {}.", file.string(), std::strerror(error));
}

} // namespace

TemporaryFile::TemporaryFile(const fs::path& target) : m_name(target), m_target(linkTarget(target)) {
    const fs::path folder = folderOf(m_target);
    std::error_code error;
    if (!fs::is_directory(folder, error))
        fail("{} cannot be written: there is no folder {}.", target.string(), folder.string());
    sweepOnce(folder);
    static std::atomic<int> count = 0;
    // In a shared folder a process of another machine may have this one's number.
    do {
        m_path =
            folder / fmt::format("{}{}-{}{}", kPrefix, ::getpid(), count++, m_target.extension().string());
        m_handle = ::open(m_path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, kPermissions);
    } while (m_handle < 0 && errno == EEXIST);
    if (m_handle < 0)
        failWriting(m_name, errno);
    ::flock(m_handle, LOCK_EX | LOCK_NB); // tells a sweep that someone is at work on it
    takeRights(m_handle, m_target);
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
        failWriting(m_name, m_error);
    if (::fsync(m_handle) != 0)
        failWriting(m_name, errno);
    std::error_code error;
    fs::rename(m_path, m_target, error);
    if (error)
        failWriting(m_name, error.value());
    syncFolder(folderOf(m_target));
    if (::close(std::exchange(m_handle, -1)) != 0)
        failWriting(m_name, errno);
}

} // namespace texloom
