#pragma once

#include <CLI/App.hpp>

namespace texloom::cli {

/// Adds `analyze quality`: how closely a texture resembles its exemplars, and what its map says was copied.
void addAnalyzeQuality(CLI::App& analyze);

} // namespace texloom::cli
