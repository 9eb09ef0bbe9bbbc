#pragma once

namespace CLI { // NOLINT(readability-identifier-naming): the library's own
class App;
}

namespace texloom::cli {

/// Adds `sample`: boxes, slices and coloured meshes of a solid.
void addSample(CLI::App& app);

} // namespace texloom::cli
