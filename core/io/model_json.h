#pragma once

#include "core/io/model_file.h"

#include <string>

namespace texloom {

/// A model as JSON, for programs that take their tables so: `kind`, `notes` by name, and `arrays` by name,
/// each nested as its shape says. What is in it is what a safetensors file of the model holds, but for the
/// recipe; models are not read from it.
std::string jsonOf(const Model& model);

} // namespace texloom
