#pragma once

#include <filesystem>

namespace texloom {

/// Whether Texloom itself wrote this file, as the marks in it say: the recipe beside a picture (which names
/// its outputs, as none that a person writes does), a report, a summary, a session, a method's page, a model,
/// a volume, a mesh, or a picture whose metadata name Texloom. False where there is no such file, or it
/// cannot be read.
bool isOwnFile(const std::filesystem::path& path);

/// Whether there is something of somebody else's under this name: a file that is not Texloom's own and not
/// empty, a folder, or a device.
bool isForeignFile(const std::filesystem::path& path);

} // namespace texloom
