#pragma once

#include "core/methods/method.h"
#include "core/methods/sparse/settings.h"

#include <cstdint>

namespace texloom::sparse {

/// How many scales the settings come to: as many as asked for, unless a patch does not fit the coarsest.
int scalesFor(const Request& request, const Settings& settings);

/// The finest image that is worked on: the output, or larger so that every scale holds a patch.
Size canvasFor(const Request& request, const Settings& settings);

/// A size halved `scale` times, at least 1 × 1.
Size sizeAt(int scale, Size size);

/// Memory of a whole run in bytes, at its peak.
std::uint64_t bytesFor(const Request& request, const Settings& settings, int threads);

/// Time of a whole run in seconds.
double secondsFor(const Request& request, const Settings& settings);

} // namespace texloom::sparse
