#pragma once

#include "core/job/random.h"

#include <cstdint>
#include <string>

namespace texloom::test {

/// Damages a file's bytes a little, in a way that depends on (random, iteration) alone: flipped bits, changed
/// bytes, numbers set to extremes, pieces cut out, doubled, moved, taken from `other`, or the end cut off.
std::string damaged(std::string bytes, const std::string& other, const Random& random, int iteration);

} // namespace texloom::test
