#pragma once

#include "core/session/run/run.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/textures.h"

#include <cstdint>
#include <filesystem>
#include <string>

namespace texloom::test {

/// A small quilting of bark.png, 48 × 44 px, in a folder of its own; ready to be changed.
struct SampleRun {
    SampleRun();

    /// Writes a texture as NAME.png.
    std::filesystem::path write(const std::string& name, Size size, int channels,
                                std::uint64_t seed = 1) const;
    /// Gives the first exemplar a companion NAME.png.
    void addCompanion(const std::string& name, Size size);
    /// Plans and runs it to the end. @throws Error if it fails.
    Result run() const;

    TemporaryFolder folder;
    RunInput input;
};

} // namespace texloom::test
