#pragma once

#include "core/io/json_field.h"

#include <filesystem>
#include <string>

namespace texloom {

/// Puts a file's name into an object as text. Names may be any bytes, JSON only UTF-8: the bytes of others
/// stand beside it in hexadecimal, as "KEYBytes".
void putFileName(JsonField::Json& object, const std::string& key, const std::filesystem::path& name);

/// The name that putFileName() wrote. @throws UsageError where it is empty, or no file can have it.
std::filesystem::path fileNameFrom(const JsonField& object, const std::string& key);

} // namespace texloom
