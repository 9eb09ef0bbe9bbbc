#pragma once

#include <filesystem>
#include <string>

namespace texloom::test {

/// A folder of its own for one test, removed with all that is in it.
class TemporaryFolder {
public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return m_path; }
    std::filesystem::path operator/(const std::string& name) const { return m_path / name; }
    /// Number of entries, hidden ones too: shows what was left behind.
    int entries() const;

private:
    std::filesystem::path m_path;
};

} // namespace texloom::test
