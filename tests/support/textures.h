#pragma once

#include "core/image/image.h"

#include <cstdint>
#include <filesystem>

namespace texloom::test {

/// Independent uniform noise in [0, 1).
Image noise(Size size, int channels, std::uint64_t seed = 1);

/// A made-up texture with structure at several scales: soft blobs over a weave, different in each channel, in
/// 0 to 1.
Image blobs(Size size, int channels, std::uint64_t seed = 1);

/// A tile of noise repeated over an image.
Image periodic(Size size, Size period, int channels);

/// Every sample with this value.
Image constant(Size size, int channels, float value);

/// A file of resources/exemplars.
std::filesystem::path bundled(const char* name);

} // namespace texloom::test
