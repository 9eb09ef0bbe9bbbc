#pragma once

#include "core/methods/method.h"

#include <filesystem>
#include <string>

namespace texloom::cli {

/// What a method's declaration says, as a page in Markdown. The page shows a picture of the method's id
/// beside it.
std::string methodPage(const Method& method);

/// Writes the page of every method to ID.md in a folder, which is made where it is missing, and a list of
/// them to README.md.
/// @param overwrite whether files may be replaced that Texloom did not write. @throws Error
void writeMethodPages(const std::filesystem::path& folder, bool overwrite);

} // namespace texloom::cli
