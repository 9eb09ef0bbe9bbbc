#pragma once

#include "core/base/message.h"

#include <sys/types.h>

#include <compare>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace texloom {

/// Which file a name stands for: the same for all links to it, symbolic or hard, and for all ways to write
/// its path. Names of files that are not there yet are compared without regard to case, as some disks do.
struct FileIdentity {
    dev_t device = 0; ///< of a file that is there
    ino_t inode = 0;
    std::string path; ///< of one that is not

    static FileIdentity of(const std::filesystem::path& file);
    auto operator<=>(const FileIdentity&) const = default; // NOLINT(modernize-use-nullptr): there is none
};

/// Looks after the files that a call finds: it is told of everything that the call will read and write, and
/// checks, before anything runs, that nothing is lost by it.
class OutputGuard {
public:
    /// @param around what is read by a whole of which this call is a part; it must outlive this guard.
    explicit OutputGuard(const OutputGuard* around = nullptr) : m_around(around) {}

    /// @param what the file is, for messages, as "the recipe of this run".
    void reads(const std::filesystem::path& file, const Message& what);
    void reads(const std::vector<std::filesystem::path>& files, const Message& what);
    void writes(const std::filesystem::path& file, const Message& what);

    /// @param overwrite whether files of others may be replaced; what is read never is.
    /// @throws UsageError with the two names where one file would be written twice, or one that is read, or
    /// (unless `overwrite`) one that is there, not Texloom's own, and not empty.
    void check(bool overwrite) const;

    /// Those of what would be written that are there, are not Texloom's own, and are not empty.
    std::vector<std::filesystem::path> foreign() const;

private:
    struct Use {
        std::filesystem::path path;
        Message what;
    };

    const Use* reader(const FileIdentity& file) const;

    const OutputGuard* m_around;
    std::map<FileIdentity, Use> m_reads;
    std::vector<Use> m_writes;
};

} // namespace texloom
