#pragma once

namespace CLI { // NOLINT(readability-identifier-naming): the library's own
class App;
}

namespace texloom::cli {

/// Adds the commands that make descriptors of textures and tell of them: descriptor, learn-descriptor,
/// import-descriptor.
void addDescriptorCommands(CLI::App& app);

} // namespace texloom::cli
