#pragma once

#include <CLI/App.hpp>

namespace texloom::cli {

/// Adds `analyze methods`: what an exemplar is like, and which methods to try first.
void addAnalyzeCharacter(CLI::App& analyze);

} // namespace texloom::cli
