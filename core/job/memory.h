#pragma once

#include "core/base/message.h"

#include <cstdint>
#include <filesystem>
#include <limits>
#include <string_view>

namespace texloom {

/// The resident set of this process now, and the largest so far, in bytes.
std::uint64_t residentMemory();
std::uint64_t peakMemory();

/// Private memory of this process that the system's limit RLIMIT_DATA counts, in bytes.
std::uint64_t dataMemory();

/// Gives this process so much memory, in bytes, all that it has already taken included; 0: as much as there
/// is.
void limitMemory(std::uint64_t bytes);

/// Memory that may still be taken now, in bytes: what the machine has free, or what a container, a cluster's
/// scheduler or limitMemory() leaves this process where that is less.
std::uint64_t availableMemory();

/// "the 1.4 GiB that are free", or "the 63 MiB that the limit of 200 MiB leaves": availableMemory() in a
/// sentence.
Message availableMemoryText();

/// Stands for "as much as there is".
inline constexpr std::uint64_t kUnlimitedMemory = std::numeric_limits<std::uint64_t>::max();

/// What control groups leave a process: the least of its group's and those above it, or kUnlimitedMemory.
/// Pages of files that could be given back count as free.
/// @param root where the groups' files are, as /sys/fs/cgroup. @param membership the text of
/// /proc/self/cgroup: "0::/GROUP" (version 2) or "N:memory:/GROUP" (version 1).
std::uint64_t groupMemoryLeft(const std::filesystem::path& root, std::string_view membership);

} // namespace texloom
