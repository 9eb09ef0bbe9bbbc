#pragma once

#include "core/io/image_file.h"

#include <string>
#include <utility>

namespace texloom::test {

/// Options to write with a depth, a space and an embedded recipe.
inline WriteOptions as(Depth depth, std::string space = "srgb", std::string recipe = {}) {
    WriteOptions options;
    options.depth = depth;
    options.space = std::move(space);
    options.recipe = std::move(recipe);
    return options;
}

} // namespace texloom::test
