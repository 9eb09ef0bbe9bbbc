#pragma once

namespace texloom::cli {

/// What texloom-cli does, in a process that takes interrupts and has its decoders (DecoderProcess::start()).
/// @return the exit status; what went wrong is told in one line on stderr.
int runProgram(int argc, char** argv);

} // namespace texloom::cli
