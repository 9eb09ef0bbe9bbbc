#pragma once

namespace texloom {

/// Ends the program with this status once everything of its own is done: what was printed is written out, but
/// libraries are not asked to shut down. Some wait for threads that, where memory is short, never came to be
/// (OpenBLAS). With a sanitizer, which reports at the end, the program ends as usual.
[[noreturn]] void leaveProgram(int status);

} // namespace texloom
