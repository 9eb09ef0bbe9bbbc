#pragma once

#include "core/base/message.h"

#include <vector>

namespace texloom {

/// A named series of numbers, such as the energy of each iteration.
struct Curve {
    Message name;
    std::vector<double> values;
};

/// Adds a value to the curve of this name, which is begun if it is not there.
void addTo(std::vector<Curve>& curves, const Message& name, double value);

} // namespace texloom
