#pragma once

#include "core/base/value.h"

#include <vector>

namespace texloom {

/// One change of an exemplar, made when it is used (the file stays as it is), as plain data: the settings of
/// a tool by name. One of them has the name of the tool and so says which it is: `flatten = smooth, width =
/// 0.25`.
using ExemplarEdit = Values;

/// Changes in the order in which they are made.
using ExemplarEdits = std::vector<ExemplarEdit>;

} // namespace texloom
