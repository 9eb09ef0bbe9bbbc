#include "tests/cli/program.h"

#include "tests/support/file_content.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>

namespace texloom::test {

namespace {

constexpr const char* kReport = "sanitizer";

void redirect(const std::filesystem::path& path, int to) {
    const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    ::dup2(file, to);
    ::close(file);
}

/// Sanitizers write what they find to files: the program gives its stderr away, and its decoders have none.
void reportTo(const std::filesystem::path& files) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    for (const char* name : {"ASAN_OPTIONS", "UBSAN_OPTIONS", "TSAN_OPTIONS"}) {
        const char* given = std::getenv(name);
        const std::string options = given ? std::string(given) + ":" : "";
        ::setenv(name, (options + "log_path=" + files.string()).c_str(), 1);
    }
#else
    static_cast<void>(files);
#endif
}

/// Fails the test with what a sanitizer wrote.
void expectNoReport(const std::filesystem::path& folder) {
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.path().stem() == kReport)
            ADD_FAILURE() << contentOf(entry.path());
}

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kServes = false; // sanitizers read where to report when a program starts
#else
constexpr bool kServes = true;
#endif

/// A program that serves calls: see served_main.cpp. It ends with this one.
Handle serverOf(std::string program) {
    auto [ours, theirs] = Handle::connection();
    if (::fork() == 0) {
        std::string serve = "--serve",
                    number = std::to_string(::dup(theirs.number())); // which exec leaves open
        char* words[] = {program.data(), serve.data(), number.data(), nullptr};
        ::execv(words[0], words);
        ::_exit(127);
    }
    return std::move(ours);
}

/// The server for an executable, or null: it is no program that can be served.
const Handle* serverFor(const std::string& executable) {
    if (executable == TEXLOOM_CLI) {
        static const Handle server = serverOf(TEXLOOM_CLI_SERVED);
        return &server;
    }
    if (executable == TEXLOOM_CLI_DOORS) {
        static const Handle server = serverOf(TEXLOOM_CLI_DOORS);
        return &server;
    }
    return nullptr;
}

/// Whether a call is about memory, of which a program that shares another's pages takes less.
bool isAboutMemory(const std::vector<std::string>& words) {
    return std::any_of(words.begin(), words.end(),
                       [](const std::string& word) { return word == "--memory" || word == "--report"; });
}

nlohmann::json environment() {
    nlohmann::json all = nlohmann::json::object();
    for (char** entry = environ; *entry != nullptr; ++entry) {
        const std::string text = *entry;
        const std::size_t sign = text.find('=');
        all[text.substr(0, sign)] = text.substr(sign + 1);
    }
    return all;
}

} // namespace

int Ended::complaints() const {
    const auto ends = std::count(err.begin(), err.end(), '\n');
    return static_cast<int>(ends) + (err.empty() || err.back() == '\n' ? 0 : 1);
}

Program::Program(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
                 const std::string& executable) {
    std::vector<std::string> words = {executable};
    words.insert(words.end(), arguments.begin(), arguments.end());
    if (!kServes || isAboutMemory(words) || !startServed(words, folder))
        start(words, folder);
}

bool Program::startServed(const std::vector<std::string>& words, const std::filesystem::path& folder) {
    const Handle* const server = serverFor(words.front());
    if (server == nullptr)
        return false;
    const nlohmann::json call = {{"words", words},
                                 {"folder", folder.string()},
                                 {"out", (m_output / "out").string()},
                                 {"err", (m_output / "err").string()},
                                 {"environment", environment()}};
    // Names that are not UTF-8 have no place in JSON.
    const std::string text = call.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    if (text.size() >= Packet::kLongestText || text.find("\xEF\xBF\xBD") != std::string::npos)
        return false;
    auto [ours, theirs] = Handle::connection();
    if (!server->send({Packet::Request, 0, text, std::move(theirs)}))
        return false;
    theirs = {};
    const std::optional<Packet> started = ours.receive();
    if (!started)
        return false;
    m_id = static_cast<pid_t>(started->number);
    m_served = std::move(ours);
    return true;
}

void Program::start(const std::vector<std::string>& words, const std::filesystem::path& folder) {
    std::vector<std::string> own = words;
    std::vector<char*> pointers;
    for (std::string& word : own)
        pointers.push_back(word.data());
    pointers.push_back(nullptr);
    const std::filesystem::path out = m_output / "out", err = m_output / "err";
    m_id = ::fork();
    if (m_id < 0)
        throw std::runtime_error("no process");
    if (m_id > 0)
        return;
    redirect("/dev/null", STDIN_FILENO);
    redirect(out, STDOUT_FILENO);
    redirect(err, STDERR_FILENO);
    reportTo(m_output / kReport);
    if (::chdir(folder.c_str()) == 0)
        ::execv(pointers.front(), pointers.data());
    ::_exit(127);
}

Program::~Program() {
    end();
    expectNoReport(m_output.path());
}

bool Program::running() {
    if (m_ended)
        return false;
    if (!m_served.open()) {
        m_ended = ::waitpid(m_id, &m_status, WNOHANG) == m_id;
    } else if (pollfd waiting{m_served.number(), POLLIN, 0}; ::poll(&waiting, 1, 0) > 0) {
        m_ended = true;
        if (const std::optional<Packet> told = m_served.receive())
            m_status = static_cast<int>(told->number);
    }
    return !m_ended;
}

void Program::end() {
    if (!running())
        return;
    signal(SIGKILL);
    while (running())
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
}

std::chrono::milliseconds Program::worked() const {
    std::ifstream file("/proc/" + std::to_string(m_id) + "/stat");
    std::string skipped;
    long long user = 0, system = 0;
    std::getline(file, skipped, ')');
    for (int i = 0; i < 11; ++i)
        file >> skipped;
    file >> user >> system;
    return std::chrono::milliseconds((user + system) * 1000 / ::sysconf(_SC_CLK_TCK));
}

void Program::signal(int number) const {
    ::kill(m_id, number);
}

Ended Program::wait(std::chrono::seconds limit) {
    const auto latest = std::chrono::steady_clock::now() + limit;
    while (running() && std::chrono::steady_clock::now() < latest)
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    end();
    const int status = WIFEXITED(m_status) ? WEXITSTATUS(m_status) : 128 + WTERMSIG(m_status);
    return {status, contentOf(m_output / "out"), contentOf(m_output / "err")};
}

Ended runCli(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
             const std::string& executable) {
    return Program(arguments, folder, executable).wait();
}

} // namespace texloom::test
