#pragma once

#include "core/io/recipe.h"

#include <vector>

namespace texloom {

/// Gives the steps of a recipe that an earlier build wrote, with all parameters that it knew, those that came
/// later: with the values that stand for what was done before there were any, so that it makes the same bits.
void completeOlder(std::vector<RecipeStep>& steps);

} // namespace texloom
