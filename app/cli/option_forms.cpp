#include "app/cli/option_forms.h"

#include "core/base/text.h"
#include "core/methods/method.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <string_view>

namespace texloom::cli {

namespace {

/// @param read gives nothing for a text of another form; @param form ends the sentence that refuses it.
template <class Target, class T>
void addForm(CLI::App& command, const std::string& name, Target& value,
             std::optional<T> (*read)(const std::string&), const std::string& form, const std::string& help) {
    command
        .add_option_function<std::string>(
            name, [&value, read](const std::string& text) { value = *read(text); }, help)
        ->check([read, form](const std::string& text) {
            return read(text) ? std::string() : fmt::format("\"{}\" {}", text, form);
        });
}

/// A whole number from `least` to the largest side of an output.
bool readLength(std::string_view text, int least, int& length) {
    long long number = 0;
    if (!parseInteger(text, number) || number < least || number > kLargestSide)
        return false;
    length = static_cast<int>(number);
    return true;
}

std::optional<Size> readSize(const std::string& text) {
    const std::size_t by = text.find('x');
    const std::string_view whole = text;
    Size size;
    if (!readLength(whole.substr(0, by), 1, size.width) ||
        !readLength(by == std::string::npos ? whole : whole.substr(by + 1), 1, size.height))
        return std::nullopt;
    return size;
}

std::optional<Region> readRegion(const std::string& text) {
    std::array<int, 4> numbers{};
    std::size_t begin = 0;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const std::size_t end = i + 1 < numbers.size() ? text.find(',', begin) : text.size();
        if (end == std::string::npos ||
            !readLength(std::string_view(text).substr(begin, end - begin), i < 2 ? 0 : 1, numbers[i]))
            return std::nullopt;
        begin = end + 1;
    }
    return Region{numbers[0], numbers[1], {numbers[2], numbers[3]}};
}

std::optional<Wrap> readWrap(const std::string& text) {
    if (text != "x" && text != "y" && text != "xy")
        return std::nullopt;
    return Wrap{text != "y", text != "x"};
}

std::optional<std::uint64_t> readSeed(const std::string& text) {
    std::uint64_t seed = 0;
    return parseUnsigned(text, seed) ? std::optional(seed) : std::nullopt;
}

/// What is wrong with a number as it was written; empty if nothing. @param whole whether it has no fraction.
std::string wrongNumber(const std::string& text, bool whole) {
    long long integer = 0;
    double real = 0;
    if (whole ? parseInteger(text, integer) : parseNumber(text, real) && std::isfinite(real))
        return {};
    return fmt::format("\"{}\" is not a {}number; write it with decimal digits", text, whole ? "whole " : "");
}

} // namespace

void needPlainNumbers(CLI::App& command) {
    for (CLI::Option* option : command.get_options()) {
        const std::string type = option->get_type_name();
        const bool whole = type.starts_with("INT") || type.starts_with("UINT");
        if (whole || type.starts_with("FLOAT")) // before what it is held against otherwise
            option->transform(
                CLI::Validator([whole](const std::string& text) { return wrongNumber(text, whole); }, ""));
    }
    for (CLI::App* below : command.get_subcommands({}))
        needPlainNumbers(*below);
}

void addSize(CLI::App& command, std::optional<Size>& size, const std::string& help) {
    addForm(command, "--size", size, readSize,
            fmt::format("is not a size; write it as 512x256 or 512, each side from 1 to {} px",
                        grouped(kLargestSide)),
            help);
}

void addRegion(CLI::App& command, std::optional<Region>& region, const std::string& help) {
    addForm(
        command, "--region", region, readRegion,
        fmt::format("is not a region; write it as x,y,width,height in pixels of the output, none above {}",
                    grouped(kLargestSide)),
        help);
}

void addWrap(CLI::App& command, Wrap& wrap, const std::string& help) {
    addForm(command, "--wrap", wrap, readWrap, "is none of x, y and xy", help);
}

void addSeed(CLI::App& command, std::uint64_t& seed, const std::string& help) {
    addForm(command, "--seed", seed, readSeed,
            fmt::format("is not a seed; give a whole number from 0 to {}",
                        std::numeric_limits<std::uint64_t>::max()),
            help);
}

} // namespace texloom::cli
