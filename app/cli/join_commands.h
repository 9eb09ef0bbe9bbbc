#pragma once

#include <CLI/App.hpp>

namespace texloom::cli {

/// Adds a command for each tool that joins two images, such as `blend`.
void addJoins(CLI::App& app);

} // namespace texloom::cli
