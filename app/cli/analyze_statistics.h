#pragma once

namespace CLI {
class App;
}

namespace texloom::cli {

/// Adds `analyze statistics`: the mean deviation σ̄ of patch models over patch size and neighbours.
void addAnalyzeStatistics(CLI::App& analyze);

} // namespace texloom::cli
