#pragma once

#include <CLI/App.hpp>

namespace texloom::cli {

/// Adds `batch`: many recipes in one process, or a shard of them.
void addBatch(CLI::App& app);

} // namespace texloom::cli
