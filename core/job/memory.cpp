#include "core/job/memory.h"

#include "core/base/text.h"

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>

namespace texloom {

namespace fs = std::filesystem;

namespace {

/// The number behind a name at the beginning of a line of one of the kernel's lists.
std::optional<std::uint64_t> listed(const fs::path& list, std::string_view name) {
    std::ifstream lines(list);
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with(name))
            return std::strtoull(line.c_str() + name.size(), nullptr, 10);
    return std::nullopt;
}

/// A figure in kB, in bytes.
std::optional<std::uint64_t> kernelFigure(const char* list, std::string_view name) {
    const std::optional<std::uint64_t> figure = listed(list, name);
    return figure ? std::optional(*figure * 1024) : std::nullopt;
}

/// The files of one version of control groups.
struct GroupFiles {
    const char *limit, *used, *givesBack;
};
constexpr GroupFiles kVersion2{"memory.max", "memory.current", "inactive_file "};
constexpr GroupFiles kVersion1{"memory.limit_in_bytes", "memory.usage_in_bytes", "total_inactive_file "};

std::optional<std::uint64_t> numberIn(const fs::path& path) {
    std::ifstream file(path);
    std::string text;
    std::uint64_t number = 0;
    if (!(file >> text) || !parseUnsigned(text, number)) // "max" is no limit
        return std::nullopt;
    return number;
}

std::uint64_t leftIn(const fs::path& group, const GroupFiles& files) {
    const std::optional<std::uint64_t> limit = numberIn(group / files.limit),
                                       used = numberIn(group / files.used);
    if (!limit || !used)
        return kUnlimitedMemory;
    const std::uint64_t held =
        *used - std::min(*used, listed(group / "memory.stat", files.givesBack).value_or(0));
    return *limit - std::min(*limit, held);
}

/// The least of a group's and those above it.
std::uint64_t leftUpwards(const fs::path& root, const fs::path& group, const GroupFiles& files) {
    std::uint64_t left = leftIn(root, files);
    fs::path path = root;
    for (const fs::path& part : group.relative_path()) {
        path /= part;
        left = std::min(left, leftIn(path, files));
    }
    return left;
}

std::atomic<std::uint64_t> givenMemory = 0;

/// What the process has not yet taken of the memory that it was given, if it was given any.
std::optional<std::uint64_t> leftOfLimit() {
    const std::uint64_t given = givenMemory;
    return given > 0 ? std::optional(given - std::min(given, residentMemory())) : std::nullopt;
}

std::string contentOf(const char* path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
}

} // namespace

std::uint64_t groupMemoryLeft(const fs::path& root, std::string_view membership) {
    std::uint64_t left = kUnlimitedMemory;
    while (!membership.empty()) {
        const std::size_t end = std::min(membership.find('\n'), membership.size());
        const std::string_view line = membership.substr(0, end);
        membership.remove_prefix(std::min(end + 1, membership.size()));
        const std::size_t first = line.find(':'), second = line.find(':', first + 1);
        if (first == std::string_view::npos || second == std::string_view::npos)
            continue;
        const std::string_view controllers = line.substr(first + 1, second - first - 1);
        const fs::path group(line.substr(second + 1));
        if (controllers.empty())
            left = std::min(left, leftUpwards(root, group, kVersion2));
        else if (controllers == "memory")
            left = std::min(left, leftUpwards(root / "memory", group, kVersion1));
    }
    return left;
}

std::uint64_t residentMemory() {
    return kernelFigure("/proc/self/status", "VmRSS:").value_or(0);
}

std::uint64_t peakMemory() {
    return kernelFigure("/proc/self/status", "VmHWM:").value_or(0);
}

std::uint64_t dataMemory() {
    return kernelFigure("/proc/self/status", "VmData:").value_or(0);
}

void limitMemory(std::uint64_t bytes) {
    givenMemory = bytes;
}

std::uint64_t availableMemory() {
    constexpr std::uint64_t kAssumed = 4ULL << 30;
    const std::uint64_t machine = kernelFigure("/proc/meminfo", "MemAvailable:").value_or(kAssumed);
    return std::min({machine, groupMemoryLeft("/sys/fs/cgroup", contentOf("/proc/self/cgroup")),
                     leftOfLimit().value_or(kUnlimitedMemory)});
}

Message availableMemoryText() {
    const std::uint64_t available = availableMemory();
    const std::optional<std::uint64_t> left = leftOfLimit();
    if (left && *left <= available)
        return message("the {} that the limit of {} leaves", byteText(available),
                       byteText(givenMemory.load()));
    return message("the {} that are free", byteText(available));
}

} // namespace texloom
