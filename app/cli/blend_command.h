#pragma once

#include <CLI/App.hpp>

namespace texloom::cli {

/// Adds `blend`: two images joined along a curve.
void addBlend(CLI::App& app);

} // namespace texloom::cli
