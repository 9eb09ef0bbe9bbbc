#pragma once

#include <string>
#include <vector>

namespace texloom {

/// A named series of numbers, such as the energy of each iteration.
struct Curve {
    std::string name;
    std::vector<double> values;
};

/// Adds a value to the curve of this name, which is begun if it is not there.
void addTo(std::vector<Curve>& curves, const std::string& name, double value);

} // namespace texloom
