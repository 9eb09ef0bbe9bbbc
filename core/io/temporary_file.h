#pragma once

#include <filesystem>

namespace texloom {

/// A file written beside its final place and renamed when it is whole; removed if that never comes.
class TemporaryFile {
public:
    /// @throws Error if the folder of `target` is not there.
    explicit TemporaryFile(const std::filesystem::path& target);
    ~TemporaryFile();
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    /// Where to write; has the target's extension.
    const std::filesystem::path& path() const { return m_path; }
    /// Flushes the file to the disk and puts it in the target's place. @throws Error
    void commit();

private:
    std::filesystem::path m_target;
    std::filesystem::path m_path;
};

} // namespace texloom
