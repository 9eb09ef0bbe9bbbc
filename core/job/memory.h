#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <string_view>

namespace texloom {

/// The resident set of this process now, and the largest so far, in bytes.
std::uint64_t residentMemory();
std::uint64_t peakMemory();

/// Memory that a run may take now, in bytes: what the machine has free, or what a container or a cluster's
/// scheduler leaves this process where that is less.
std::uint64_t availableMemory();

/// Stands for "as much as there is".
inline constexpr std::uint64_t kUnlimitedMemory = std::numeric_limits<std::uint64_t>::max();

/// What control groups leave a process: the least of its group's and those above it, or kUnlimitedMemory.
/// Pages of files that could be given back count as free.
/// @param root where the groups' files are, as /sys/fs/cgroup. @param membership the text of
/// /proc/self/cgroup: "0::/GROUP" (version 2) or "N:memory:/GROUP" (version 1).
std::uint64_t groupMemoryLeft(const std::filesystem::path& root, std::string_view membership);

} // namespace texloom
