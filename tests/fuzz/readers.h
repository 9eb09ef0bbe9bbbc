#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace texloom::test {

/// Reads bytes as one kind of file. @throws Error where they are refused; anything else, or an end of the
/// program, is a fault of the reader. What was read and can be written must be read as the same again; where
/// it is not, std::logic_error.
using Reader = std::function<void(std::string_view bytes)>;

/// Every reader of files from outside, by the name of the folder in corpus/ that holds inputs for it.
const std::map<std::string, Reader, std::less<>>& readers();

} // namespace texloom::test
