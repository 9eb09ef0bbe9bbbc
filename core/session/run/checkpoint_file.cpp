#include "core/session/run/checkpoint_file.h"

#include "core/base/error.h"
#include "core/base/folder_of.h"
#include "core/base/version.h"
#include "core/io/curve_json.h"
#include "core/io/image_file.h"
#include "core/io/json_field.h"

#include <limits>

namespace texloom {

namespace fs = std::filesystem;
using Json = JsonField::Json;

namespace {

constexpr const char* kName = "texloomCheckpoint";

[[noreturn]] void damaged(const fs::path& path) {
    failUsage("{} is not a checkpoint, or it is damaged; start the run again.", path.string());
}

CheckpointFile checkpointFrom(const Json& head, std::string state, const fs::path& path) {
    CheckpointFile file;
    if (head.at(kName).get<int>() != CheckpointFile::kFormat)
        failUsage("{} is a checkpoint of format {}; this Texloom ({}) reads format {}. Start the run again.",
                  path.string(), head.at(kName).get<int>(), kVersion, CheckpointFile::kFormat);
    file.version = head.at("version").get<std::string>();
    file.recipe = Recipe::fromJson(head.at("recipe").dump(), folderOf(path));
    file.checkpoint.step = head.at("step").get<std::uint32_t>();
    file.checkpoint.progress = head.at("progress").get<double>();
    if (head.contains("curves")) // earlier builds kept none
        file.checkpoint.curves = curvesFrom(head.at("curves"));
    if (head.at("bytes").get<std::uint64_t>() != state.size() ||
        head.at("sha1").get<std::string>() != bytesHash(state))
        damaged(path);
    file.checkpoint.state = std::move(state);
    return file;
}

} // namespace

void writeCheckpoint(const fs::path& path, const Recipe& recipe, const Checkpoint& checkpoint) {
    const Json head = {{kName, CheckpointFile::kFormat},
                       {"version", kVersion},
                       {"recipe", Json::parse(recipe.toJson(folderOf(path)))},
                       {"step", checkpoint.step},
                       {"progress", checkpoint.progress},
                       {"curves", toJson(checkpoint.curves)},
                       {"bytes", checkpoint.state.size()},
                       {"sha1", bytesHash(checkpoint.state)}};
    writeText(path, head.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n" + checkpoint.state);
}

CheckpointFile readCheckpoint(const fs::path& path) {
    std::string text = readText(path, std::numeric_limits<std::uintmax_t>::max());
    const std::size_t end = text.find('\n');
    if (end == std::string::npos)
        damaged(path);
    try {
        return checkpointFrom(parseJson(TR("checkpoint"), std::string_view(text).substr(0, end)),
                              text.substr(end + 1), path);
    } catch (const Json::exception&) {
        damaged(path);
    }
}

fs::path checkpointFor(const fs::path& output) {
    return fs::path(output).concat(".checkpoint");
}

std::shared_ptr<const Checkpoint> resumable(const CheckpointFile& file, const RunPlan& plan) {
    if (file.version != kVersion)
        failUsage(
            "The checkpoint was written by Texloom {}; this is {}, which may go on otherwise. Start the "
            "run again, or use that version.",
            file.version, kVersion);
    Recipe planned = plan.recipe;
    planned.version = file.recipe.version;
    if (planned.toJson("/") != file.recipe.toJson("/"))
        failUsage("The checkpoint is of a run with other settings or exemplars; start the run again.");
    return std::make_shared<const Checkpoint>(file.checkpoint);
}

} // namespace texloom
