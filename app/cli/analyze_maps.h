#pragma once

namespace CLI {
class App;
}

namespace texloom::cli {

/// Adds `analyze maps`: where a texture's pixels come from, as figures and pictures.
void addAnalyzeMaps(CLI::App& analyze);

} // namespace texloom::cli
