#pragma once

#include <filesystem>

namespace texloom {

/// The folder that a file lies in: "." for one without, so that it can be joined and opened.
inline std::filesystem::path folderOf(const std::filesystem::path& file) {
    return file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
}

} // namespace texloom
