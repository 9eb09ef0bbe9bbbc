#pragma once

namespace texloom {

/// Version of this build as "major.minor.patch"; written into every recipe.
extern const char* const kVersion;

} // namespace texloom
