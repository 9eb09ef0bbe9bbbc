#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

namespace texloom {

/// A file written beside its final place and renamed when it is whole; removed if that never comes.
/// It remembers every write that failed, since encoders do not tell of all. A file that is replaced keeps its
/// owner and rights, and links to it stay links. What killed programs left in the folder is removed.
class TemporaryFile {
public:
    /// @throws Error if no file can be made beside `target`.
    explicit TemporaryFile(const std::filesystem::path& target);
    ~TemporaryFile();
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    /// Writes or reads bytes at an offset. @return how many; fewer than `size` after a failure or at the end.
    std::size_t write(const void* data, std::size_t size, std::int64_t offset);
    std::size_t read(void* data, std::size_t size, std::int64_t offset) const;
    std::size_t size() const;
    /// SHA-1 of what was written, as fileHash() will give it.
    std::string hash() const;

    /// Makes sure that all of it reached the disk and puts it in the target's place.
    /// @throws Error if that fails or any write before failed.
    void commit();

private:
    std::filesystem::path m_name;   ///< as it was given
    std::filesystem::path m_target; ///< the file itself, where the name is a link
    std::filesystem::path m_path;
    int m_handle = -1;
    int m_error = 0; ///< errno of the first write that failed
};

} // namespace texloom
