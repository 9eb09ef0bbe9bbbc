#pragma once

#include <filesystem>
#include <string>

namespace texloom {

/// Holds the sizes in the header of an EXR or a PNG against the file, before a decoder takes memory for what
/// they claim. @param format as ImageFileInfo::format. @throws Error in one sentence
void checkHeader(const std::filesystem::path& path, const std::string& format);

} // namespace texloom
