#include "core/io/own_file.h"

#include "core/base/error.h"
#include "core/io/image_file.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace texloom {

namespace fs = std::filesystem;

namespace {

/// The names of fields, all of which only Texloom puts into one object.
using Marks = std::vector<const char*>;

const Marks kVolumeMarks = {"texloom-volume"};
const std::array<Marks, 7> kMarks = {{
    {"texloom", "outputs"},                 // the recipe beside a picture
    {"texloomReport"},                      // of a run, of a stress test or a batch
    {"recipe", "peakMemoryBytes"},          // a run's report before it had a mark of its own
    {"shard", "runs", "skipped", "failed"}, // a batch's summary before that
    {"session", "settings", "seedLocked"},
    {"texloomResult"},
    kVolumeMarks,
}};

constexpr std::string_view kPage = "<!-- Written by `texloom-cli ";
constexpr std::string_view kMesh = "ply\nformat binary_little_endian 1.0\ncomment Texloom\n";
constexpr std::string_view kRadiance = "#?RADIANCE\n# Texloom\n";
/// Of a model: behind the eight bytes of its length, and near enough to the beginning.
constexpr std::string_view kModelHead = "{\"", kModelMark = "\"texloom.format\"";
constexpr std::size_t kModelLength = 8, kBeginning = 65536;
/// The summary of as many runs as a batch may hold is some 30 MB.
constexpr std::uintmax_t kLargestJson = 256U << 20;

/// Whether a file is an object with all of the marks of one of these kinds.
bool isMarked(const fs::path& path, std::span<const Marks> kinds) {
    const nlohmann::json json = nlohmann::json::parse(readText(path, kLargestJson), nullptr, false);
    return json.is_object() && std::any_of(kinds.begin(), kinds.end(), [&](const Marks& marks) {
               return std::all_of(marks.begin(), marks.end(),
                                  [&](const char* mark) { return json.contains(mark); });
           });
}

std::string beginningOf(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::string begin(kBeginning, '\0');
    file.read(begin.data(), static_cast<std::streamsize>(begin.size()));
    begin.resize(static_cast<std::size_t>(std::max<std::streamsize>(file.gcount(), 0)));
    return begin;
}

bool isModel(std::string_view begin) {
    return begin.size() > kModelLength && begin.substr(kModelLength).starts_with(kModelHead) &&
           begin.find(kModelMark) != std::string_view::npos;
}

} // namespace

bool isOwnFile(const fs::path& path) {
    std::error_code error;
    if (!fs::is_regular_file(path, error))
        return false;
    try {
        if (path.extension() == ".raw") { // the voxels beside a volume's head
            const fs::path head = fs::path(path).replace_extension(".json");
            return fs::is_regular_file(head, error) && isMarked(head, {&kVolumeMarks, 1});
        }
        const std::string begin = beginningOf(path);
        if (begin.starts_with(kPage) || begin.starts_with(kMesh) || begin.starts_with(kRadiance) ||
            isModel(begin))
            return true;
        if (begin.starts_with('{'))
            return isMarked(path, kMarks);
        // Other programs that change a picture keep what else Texloom wrote into it.
        const std::map<std::string, std::string> texts = readImageInfo(path).texts;
        const auto software = texts.find("Software");
        return software != texts.end() && software->second == "Texloom";
    } catch (const Error&) {
        return false;
    }
}

bool isForeignFile(const fs::path& path) {
    std::error_code error;
    if (!fs::exists(path, error))
        return false;
    const bool empty = fs::is_regular_file(path, error) && fs::file_size(path, error) == 0;
    return !empty && !isOwnFile(path);
}

} // namespace texloom
