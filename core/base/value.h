#pragma once

#include <map>
#include <string>
#include <variant>
#include <vector>

namespace texloom {

/// A place between pixels: pixel (x, y) covers the square from (x, y) to (x + 1, y + 1).
struct PlanePoint {
    double x = 0, y = 0;

    friend bool operator==(const PlanePoint&, const PlanePoint&) = default;
};

/// A few whole numbers in a fixed order: of an area left, top, width and height; of a size width and height,
/// or none where it is left to the tool.
using Wholes = std::vector<int>;
using PlanePoints = std::vector<PlanePoint>;

/// One setting's value: a toggle, a whole number, a real number, the id of a choice, an area or a size, or
/// points in an image.
using Value = std::variant<bool, int, double, std::string, Wholes, PlanePoints>;

/// Settings by name, as recipes, presets, the inspector and the command line hold them.
using Values = std::map<std::string, Value, std::less<>>;

/// The value as a person writes it: "on", "40", "0.25", "smooth-cut", "10,20,300,200".
std::string toText(const Value& value);

} // namespace texloom
