#pragma once

#include <CLI/App.hpp>

namespace texloom::cli {

/// Adds `analyze quality`: how like its exemplars a texture is, and what its map says was copied.
void addAnalyzeQuality(CLI::App& analyze);

} // namespace texloom::cli
