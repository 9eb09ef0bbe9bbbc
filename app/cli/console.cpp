#include "app/cli/console.h"

#include "core/base/text.h"
#include "core/io/image_file.h"
#include "core/job/memory.h"

#include <CLI/CLI.hpp>
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <string>
#include <thread>

namespace texloom::cli {

std::atomic<bool> interrupted = false;

namespace {

constexpr std::chrono::milliseconds kPoll{20};
constexpr int kBarWidth = 30;

std::FILE* ownMessages = stderr;

void onSignal(int) {
    interrupted = true;
}

std::string barText(JobMonitor& monitor) {
    const double progress = monitor.progress();
    const auto filled = static_cast<std::size_t>(progress * kBarWidth);
    const double seconds = monitor.seconds();
    const std::string left =
        progress > 0.02 && seconds > 0.5 ? durationText(seconds * (1 - progress) / progress) + " left" : "";
    return fmt::format("\r[{}{}] {:3.0f} %  {}  {}\x1b[K", std::string(filled, '#'),
                       std::string(kBarWidth - filled, '.'), progress * 100, monitor.stage(), left);
}

} // namespace

void addOverwrite(CLI::App& command, bool& overwrite) {
    command.add_flag("--overwrite", overwrite,
                     "Replace files that are there, even where Texloom did not write them");
}

void addMemory(CLI::App& command) {
    command
        .add_option_function<std::uint64_t>(
            "--memory", [](const std::uint64_t& mebibytes) { limitMemory(mebibytes << 20); },
            "Most memory in MiB that the program may take, all that it takes by itself included; what is "
            "free if not given. Methods that make regions write larger outputs strip by strip")
        ->check(CLI::Range(1, 1 << 24));
}

void addReproducible(CLI::App& command, bool otherwise) {
    command.add_flag_function(
        "--reproducible,!--dated", [](std::int64_t count) { setReproducible(count > 0); },
        fmt::format("Write no time of day into EXR and TIFF, so that equal runs make equal files; with "
                    "--dated the time. If neither is given: {}",
                    otherwise ? "no time" : "the time"));
    if (otherwise)
        command.preparse_callback([](std::size_t) { setReproducible(true); });
}

void silenceLibraries() {
    const int own = ::dup(STDERR_FILENO);
    std::FILE* stream = own >= 0 ? ::fdopen(own, "w") : nullptr;
    const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    if (!stream || nowhere < 0)
        return;
    std::setvbuf(stream, nullptr, _IONBF, 0);
    ownMessages = stream;
    ::dup2(nowhere, STDERR_FILENO);
    ::close(nowhere);
}

std::FILE* messages() {
    return ownMessages;
}

void watchInterrupts() {
    struct sigaction action {};
    action.sa_handler = onSignal;
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
}

void checkInterrupt() {
    if (interrupted)
        throw Cancelled{};
}

void checkEnoughMemory(const std::string& image, Size size, std::uint64_t needed) {
    if (needed > availableMemory())
        fail("To look at {} ({} × {} px) would need {} of memory, more than {}; scale the image down or cut "
             "a part "
             "out.",
             image, size.width, size.height, byteText(needed), availableMemoryText());
}

void follow(JobRunner& job, bool quiet) {
    const bool bar = !quiet && ::isatty(::fileno(messages())) != 0;
    while (!job.finished()) {
        if (interrupted)
            job.cancel();
        if (bar)
            fmt::print(messages(), "{}", barText(job.monitor()));
        std::this_thread::sleep_for(kPoll);
    }
    if (bar)
        fmt::print(messages(), "\r\x1b[K");
}

} // namespace texloom::cli
