#pragma once

#include "core/session/batch/join_input.h"

#include <CLI/App.hpp>

#include <filesystem>

namespace texloom::cli {

/// Adds a command for each tool that joins two images, such as `blend`.
void addJoins(CLI::App& app);

/// Joins two images and writes the picture over what is there, in the depth and space of the first one's
/// file. @param threads 0: one per core.
void writeJoin(const JoinInput& input, const std::filesystem::path& output, int threads, bool quiet);

} // namespace texloom::cli
