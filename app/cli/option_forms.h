#pragma once

#include "core/image/size.h"

#include <cstdint>
#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace texloom::cli {

// Options that are written in a form of their own. What has another form is refused while the command line is
// read, in a sentence that says what was given and what it must be.

/// `--size` as 512x256, or 512 for a square. Stays empty if it is not given.
void addSize(CLI::App& command, std::optional<Size>& size, const std::string& help);
/// `--region` as x,y,width,height, in pixels of the output.
void addRegion(CLI::App& command, std::optional<Region>& region, const std::string& help);
/// `--wrap` as x, y or xy.
void addWrap(CLI::App& command, Wrap& wrap, const std::string& help);
/// `--seed` as any whole number that 64 bits hold.
void addSeed(CLI::App& command, std::uint64_t& seed, const std::string& help);

/// Has every option of a command, and of those below it, that is a number refuse what is not written with
/// decimal digits: "0x2" and "0b1" are others' ways. Called when all options are there.
void needPlainNumbers(CLI::App& command);

} // namespace texloom::cli
