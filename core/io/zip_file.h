#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

namespace texloom {

/// What a ZIP archive may hold at most, so that one that was made to fill a disk is refused.
struct ZipLimits {
    std::size_t files = 4096;
    std::uint64_t bytes = 16ULL << 30; ///< of all files, unpacked
};

/// Unpacks those files of a ZIP archive (stored or deflated, not encrypted) that `wanted` says, each into
/// `folder` under its own name without the folders that it lies in there, with a number where two are alike.
/// The folder is made. @param check called throughout; what it throws ends it.
/// @return the files, in the archive's order. @throws Error in one sentence where the archive is broken, of
/// another kind, or holds more than the limits.
std::vector<std::filesystem::path> unzip(
    const std::filesystem::path& archive, const std::filesystem::path& folder,
    const std::function<bool(const std::filesystem::path&)>& wanted, const ZipLimits& limits = {},
    const std::function<void()>& check = [] {});

} // namespace texloom
