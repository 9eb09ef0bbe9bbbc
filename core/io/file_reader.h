#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>

namespace texloom {

/// An ordinary file, open to be read piece by piece.
class FileReader {
public:
    /// @throws Error if it is missing, a folder, no ordinary file or must not be read.
    explicit FileReader(const std::filesystem::path& path);

    /// In bytes, as it was when the file was opened.
    std::uint64_t size() const { return m_size; }
    /// The next bytes. @return how many: fewer than `size` only at the end. @throws Error if reading fails.
    std::size_t next(void* data, std::size_t size);
    /// `size` bytes from `offset` on. @throws Error if they are not all there.
    void read(void* data, std::size_t size, std::uint64_t offset);

private:
    struct Close {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };

    std::filesystem::path m_path;
    std::unique_ptr<std::FILE, Close> m_file;
    std::uint64_t m_size = 0;
};

} // namespace texloom
