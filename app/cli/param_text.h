#pragma once

#include "core/base/param.h"
#include "core/io/json_field.h"

#include <string>

namespace texloom::cli {

/// All that a parameter declares, as the listings give it.
JsonField::Json toJson(const Param& param);

/// A parameter's default as people read it: "0.25", "16 % of the exemplar's shorter side".
std::string defaultText(const Param& param);

/// Prints a parameter in two or three lines. @param how the option that sets it, such as "--set patch=…".
void printParam(const std::string& how, const Param& param);

} // namespace texloom::cli
