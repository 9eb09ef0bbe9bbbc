#pragma once

#include "core/io/process_channel.h"
#include "tests/support/temporary_folder.h"

#include <sys/types.h>

#include <chrono>
#include <string>
#include <string_view>
#include <vector>

namespace texloom::test {

/// How a program ended.
struct Ended {
    int status = -1; ///< exit status, or 128 + the signal that ended it
    std::string out, err;

    /// Lines on stderr.
    int complaints() const;
};

/// texloom-cli in a process of its own, its output caught. Ends with the object.
class Program {
public:
    /// Starts it. @param folder becomes its working folder. @param executable the program, if not
    /// texloom-cli.
    Program(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
            const std::string& executable = TEXLOOM_CLI);
    ~Program();
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    pid_t id() const { return m_id; }
    bool running();
    /// Processor time it has used so far.
    std::chrono::milliseconds worked() const;
    void signal(int number) const;
    /// Waits for the end; one that lasts longer than `limit` is killed.
    Ended wait(std::chrono::seconds limit = std::chrono::seconds(120));

private:
    void start(const std::vector<std::string>& words, const std::filesystem::path& folder);
    /// Has it started by a process that holds the libraries already. @return whether there is one.
    bool startServed(const std::vector<std::string>& words, const std::filesystem::path& folder);

    /// Kills it if it runs still.
    void end();

    pid_t m_id = -1;
    Handle m_served; ///< where its status comes from, if it was
    int m_status = 0;
    bool m_ended = false;
    TemporaryFolder m_output;
};

/// Runs texloom-cli to its end.
Ended runCli(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
             const std::string& executable = TEXLOOM_CLI);

} // namespace texloom::test
