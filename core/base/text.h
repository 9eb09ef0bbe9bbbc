#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

/// Marks a text for translation where no translator is at hand; the window translates it when it is shown.
#define TR(text) text

namespace texloom {

/// "1,536" from 1536: a count for people to read.
std::string grouped(std::uint64_t count);

/// "96 MiB" or "1.4 GiB" from a number of bytes.
std::string byteText(std::uint64_t bytes);

/// "0.4 s", "12 s", "3 min 20 s" from seconds.
std::string durationText(double seconds);

/// The shortest decimal that reads back as the same double: 0.1, not 0.10000000000000001.
std::string numberText(double number);

/// The whole of `text` as a number.
/// @return false if anything but a finite number is in it; `number` is then untouched.
bool parseNumber(std::string_view text, double& number);
bool parseInteger(std::string_view text, long long& number);
bool parseUnsigned(std::string_view text, std::uint64_t& number);

/// The entry of `known` most like `word` (by edit distance), or "" when none is near: for "did you mean".
std::string nearest(std::string_view word, const std::vector<std::string>& known);

} // namespace texloom
