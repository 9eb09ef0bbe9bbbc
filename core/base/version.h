#pragma once

namespace texloom {

/// Version of this build: "major.minor.patch", and behind a plus sign what git calls its sources, where it
/// was built from a checkout: "0.1.0+dc0a7cd". Written into every recipe.
extern const char* const kVersion;

} // namespace texloom
