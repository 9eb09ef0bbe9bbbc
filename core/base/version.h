#pragma once

namespace texloom {

/// Version of this build: "major.minor.patch", followed, where it was built from a checkout, by a plus sign
/// and what git calls the sources: "0.1.0+dc0a7cd". Written into every recipe.
extern const char* const kVersion;

} // namespace texloom
