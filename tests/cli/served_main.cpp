// texloom-cli for the tests: as a user starts it, or, with "--serve NUMBER", many times without loading its
// 260 libraries each time. NUMBER is an open connection; each message on it is a call
// (tests/cli/program.cpp).

#include "app/cli/console.h"
#include "app/cli/program.h"
#include "core/io/decoder_process.h"
#include "core/io/process_channel.h"
#include "core/job/leave_program.h"

#include <fcntl.h>
#include <nlohmann/json.hpp>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace texloom::test {
namespace {

[[noreturn]] void runHere(int argc, char** argv) {
    DecoderProcess::start(cli::checkInterrupt);
    leaveProgram(cli::runProgram(argc, argv));
}

void redirect(const std::string& path, int flags, int to) {
    const int file = ::open(path.c_str(), flags, 0600);
    ::dup2(file, to);
    ::close(file);
}

/// What the call says of streams, working folder and environment holds; then it is the program itself.
[[noreturn]] void become(const nlohmann::json& call) {
    redirect("/dev/null", O_RDONLY, STDIN_FILENO);
    redirect(call.at("out"), O_WRONLY | O_CREAT | O_TRUNC, STDOUT_FILENO);
    redirect(call.at("err"), O_WRONLY | O_CREAT | O_TRUNC, STDERR_FILENO);
    if (::chdir(call.at("folder").get<std::string>().c_str()) != 0)
        ::_exit(127);
    ::clearenv();
    for (const auto& [name, value] : call.at("environment").items())
        ::setenv(name.c_str(), value.get<std::string>().c_str(), 1);
    std::vector<std::string> words = call.at("words");
    std::vector<char*> pointers;
    for (std::string& word : words)
        pointers.push_back(word.data());
    pointers.push_back(nullptr);
    runHere(static_cast<int>(words.size()), pointers.data());
}

/// Runs one call in a process of its own, and tells its number, and in the end its status.
[[noreturn]] void keep(const Packet& request) {
    std::signal(SIGCHLD, SIG_DFL);
    const pid_t id = ::fork();
    if (id == 0)
        become(nlohmann::json::parse(request.text));
    request.file.send({Packet::Id, static_cast<std::uint64_t>(id)});
    int status = -1;
    ::waitpid(id, &status, 0);
    request.file.send({Packet::Done, static_cast<std::uint64_t>(status)});
    ::_exit(0);
}

[[noreturn]] void serve(const Handle& calls) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    std::signal(SIGCHLD, SIG_IGN); // nobody waits for the keepers
    while (const std::optional<Packet> request = calls.receive())
        if (::fork() == 0)
            keep(*request);
    ::_exit(0);
}

} // namespace
} // namespace texloom::test

int main(int argc, char** argv) {
    if (argc == 3 && std::string_view(argv[1]) == "--serve")
        texloom::test::serve(texloom::Handle(std::atoi(argv[2])));
    texloom::test::runHere(argc, argv);
}
