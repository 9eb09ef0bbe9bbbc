#pragma once

namespace texloom {

/// The text of resources/color/config.ocio, compiled in.
extern const char* const kColorConfig;

} // namespace texloom
