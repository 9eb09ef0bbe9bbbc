#include "core/session/export/output_guard.h"

#include "core/base/error.h"
#include "core/io/own_file.h"

#include <sys/stat.h>

#include <algorithm>

namespace texloom {

namespace fs = std::filesystem;

namespace {

/// Where a name leads, whether or not there is a file at the end of its links.
fs::path resolved(fs::path file) {
    constexpr int kMostLinks = 40;
    std::error_code error;
    for (int links = 0; links < kMostLinks && fs::is_symlink(file, error); ++links) {
        const fs::path target = fs::read_symlink(file, error);
        file = target.is_absolute() ? target : file.parent_path() / target;
    }
    // A name alone, of which nothing is there, would stay as it is.
    const fs::path absolute = fs::absolute(file, error).lexically_normal();
    const fs::path canonical = fs::weakly_canonical(absolute, error);
    return error ? absolute : canonical; // such as a name that is too long for the disk
}

} // namespace

FileIdentity FileIdentity::of(const fs::path& file) {
    struct stat status {};
    if (::stat(file.c_str(), &status) == 0)
        return {status.st_dev, status.st_ino, {}};
    std::string path = resolved(file).string();
    std::transform(path.begin(), path.end(), path.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return {0, 0, path};
}

void OutputGuard::reads(const fs::path& file, const Message& what) {
    m_reads.try_emplace(FileIdentity::of(file), Use{file, what});
}

void OutputGuard::reads(const std::vector<fs::path>& files, const Message& what) {
    for (const fs::path& file : files)
        reads(file, what);
}

void OutputGuard::writes(const fs::path& file, const Message& what) {
    m_writes.push_back({file, what});
}

const OutputGuard::Use* OutputGuard::reader(const FileIdentity& file) const {
    if (const auto found = m_reads.find(file); found != m_reads.end())
        return &found->second;
    return m_around ? m_around->reader(file) : nullptr;
}

void OutputGuard::check(bool overwrite) const {
    std::map<FileIdentity, const Use*> written;
    for (const Use& use : m_writes) {
        const FileIdentity file = FileIdentity::of(use.path);
        const Use* const read = reader(file);
        if (read != nullptr && read->path == use.path)
            failUsage("{} would be overwritten by the {}: it is {}; name another file.", read->path.string(),
                      use.what, read->what);
        if (read != nullptr)
            failUsage("{} would be overwritten by the {} {}: it is {}; name another file.",
                      read->path.string(), use.what, use.path.string(), read->what);
        if (const auto [other, isNew] = written.try_emplace(file, &use); !isNew)
            failUsage("The {} {} and the {} {} are the same file; name another one.", other->second->what,
                      other->second->path.string(), use.what, use.path.string());
        if (!overwrite && file.path.empty() && isForeignFile(use.path))
            failUsage("The {} would replace {}, which Texloom did not write; name another file, or allow it "
                      "with --overwrite.",
                      use.what, use.path.string());
    }
}

std::vector<fs::path> OutputGuard::foreign() const {
    std::vector<fs::path> files;
    for (const Use& use : m_writes)
        if (isForeignFile(use.path))
            files.push_back(use.path);
    return files;
}

} // namespace texloom
