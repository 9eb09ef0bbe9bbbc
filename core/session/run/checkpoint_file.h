#pragma once

#include "core/job/checkpoint.h"
#include "core/session/run/run.h"

#include <filesystem>
#include <functional>
#include <string>

namespace texloom {

/// A checkpoint as a file keeps it: what was being made, by which build, and how far it had come.
struct CheckpointFile {
    /// Version of the format that this build writes and reads.
    static constexpr int kFormat = 1;

    std::string version; ///< of the Texloom that wrote it
    Recipe recipe;
    Checkpoint checkpoint;
};

/// Writes whole or not at all: a line of JSON (format, version, recipe, curves, sizes, SHA-1 of the state),
/// then the state. @throws Error
void writeCheckpoint(const std::filesystem::path& path, const Recipe& recipe, const Checkpoint& checkpoint);

/// @throws Error if the file cannot be read; UsageError where it is damaged or not a checkpoint.
CheckpointFile readCheckpoint(const std::filesystem::path& path);

/// Where the command line keeps the checkpoint of a run that writes this output.
std::filesystem::path checkpointFor(const std::filesystem::path& output);

/// The state from which `plan` can go on. @throws UsageError where the checkpoint is of another build, whose
/// bits may differ, or of a run with another recipe.
std::shared_ptr<const Checkpoint> resumable(const CheckpointFile& file, const RunPlan& plan);

} // namespace texloom
