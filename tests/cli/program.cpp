#include "tests/cli/program.h"

#include "tests/support/file_content.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <thread>

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

} // namespace

int Ended::complaints() const {
    const auto ends = std::count(err.begin(), err.end(), '\n');
    return static_cast<int>(ends) + (err.empty() || err.back() == '\n' ? 0 : 1);
}

Program::Program(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
                 const std::string& executable) {
    std::vector<std::string> words = {executable};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    for (std::string& word : words)
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
    if (running()) {
        signal(SIGKILL);
        ::waitpid(m_id, &m_status, 0);
    }
    expectNoReport(m_output.path());
}

bool Program::running() {
    if (!m_ended)
        m_ended = ::waitpid(m_id, &m_status, WNOHANG) == m_id;
    return !m_ended;
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
    const auto end = std::chrono::steady_clock::now() + limit;
    while (running() && std::chrono::steady_clock::now() < end)
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    if (running()) {
        signal(SIGKILL);
        ::waitpid(m_id, &m_status, 0);
        m_ended = true;
    }
    const int status = WIFEXITED(m_status) ? WEXITSTATUS(m_status) : 128 + WTERMSIG(m_status);
    return {status, contentOf(m_output / "out"), contentOf(m_output / "err")};
}

Ended runCli(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
             const std::string& executable) {
    return Program(arguments, folder, executable).wait();
}

} // namespace texloom::test
