#pragma once

#include "core/job/job.h"

#include <atomic>

namespace texloom::cli {

/// Set by Ctrl+C and by a request to terminate.
extern std::atomic<bool> interrupted;

/// From now on Ctrl+C sets `interrupted` instead of ending the program.
void watchInterrupts();

/// @throws Cancelled after Ctrl+C.
void checkInterrupt();

/// Waits for a job, cancels it on Ctrl+C, and draws a progress bar on stderr if that is a terminal and
/// `quiet` is false.
void follow(JobRunner& job, bool quiet);

} // namespace texloom::cli
