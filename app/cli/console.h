#pragma once

#include "core/base/error.h"
#include "core/image/size.h"
#include "core/job/job.h"

#include <atomic>
#include <cstdint>
#include <cstdio>
#include <string>
#include <utility>
#include <variant>

namespace CLI { // NOLINT(readability-identifier-naming): the library's own
class App;
}

namespace texloom::cli {

/// Lets a command replace files that Texloom did not write.
void addOverwrite(CLI::App& command, bool& overwrite);

/// Limits the memory that the whole process may take: see limitMemory().
void addMemory(CLI::App& command);

/// Lets pictures hold no time of day: see setReproducible().
void addReproducible(CLI::App& command, bool otherwise);

/// Discards what libraries write to stderr: libpng, for one, prints a line of its own before the error
/// reaches those who word it.
void silenceLibraries();

/// Where our own messages go: the program's stderr.
std::FILE* messages();

/// Set by Ctrl+C and by a request to terminate.
extern std::atomic<bool> interrupted;

/// From now on Ctrl+C sets `interrupted` instead of ending the program.
void watchInterrupts();

/// @throws Cancelled after Ctrl+C.
void checkInterrupt();

/// Refuses to look at an image where that would take more memory than there is. @throws Error
void checkEnoughMemory(const std::string& image, Size size, std::uint64_t needed);

/// Waits for a job, cancels it on Ctrl+C, and draws a progress bar on stderr if that is a terminal and
/// `quiet` is false.
void follow(JobRunner& job, bool quiet);

/// The same, and the job's result. @throws Cancelled, Error or UsageError as it ended
template <class R> R followed(Job<R>& job, bool quiet) {
    follow(job, quiet);
    Outcome<R> outcome = job.take();
    if (std::holds_alternative<Cancelled>(outcome))
        throw Cancelled{};
    if (const auto* failure = std::get_if<Failure>(&outcome)) {
        if (failure->usage)
            throw UsageError(failure->message);
        throw Error(failure->message);
    }
    return std::get<R>(std::move(outcome));
}

} // namespace texloom::cli
