#include "core/io/decoder_process.h"

#include "core/base/error.h"
#include "core/io/decoder_worker.h"
#include "core/io/message_json.h"
#include "core/io/process_channel.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <optional>
#include <string>
#include <utility>

namespace texloom {

namespace {

constexpr int kPollMilliseconds = 20;

/// The process that makes workers, and what is called while they work.
struct Maker {
    Handle socket;
    std::function<void()> check;
};

Maker& maker() {
    static Maker one;
    return one;
}

/// The innermost of this thread.
thread_local const DecoderProcess::Watch* watching = nullptr;

/// Lets nothing that a library prints, or waits for, reach what the program was given.
void leaveTerminal() {
    const int nowhere = ::open("/dev/null", O_RDWR);
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        ::dup2(nowhere, stream);
    ::close(nowhere);
    // Ctrl+C reaches all processes of a terminal; the program decides what it means for a file.
    for (const int number : {SIGINT, SIGTERM, SIGCHLD})
        std::signal(number, SIG_IGN);
}

/// Makes a worker for every request until the program is gone. Never returns.
[[noreturn]] void makeWorkers(Handle requests) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    leaveTerminal();
    for (;;) {
        std::optional<Packet> request = requests.receive();
        if (!request)
            ::_exit(0);
        if (!request->file.open())
            continue;
        if (::fork() == 0) {
            ::prctl(PR_SET_PDEATHSIG, SIGKILL);
            decodeFor(request->text, request->file);
            ::_exit(0);
        }
    }
}

/// Ends a worker that nobody waits for any more.
class Worker {
public:
    explicit Worker(Handle socket) : m_socket(std::move(socket)) {}
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;
    ~Worker() {
        if (m_id > 0 && !m_ended)
            ::kill(m_id, SIGKILL);
    }

    /// Waits for its answer; none if it ended without.
    std::optional<Packet> answer() {
        for (;;) {
            std::optional<Packet> message = next();
            m_ended = !message || message->kind != Packet::Id;
            if (m_ended)
                return message;
            m_id = static_cast<pid_t>(message->number);
        }
    }

private:
    std::optional<Packet> next() {
        pollfd waiting{m_socket.number(), POLLIN, 0};
        for (;;) {
            const int ready = ::poll(&waiting, 1, kPollMilliseconds);
            DecoderProcess::check();
            if (ready > 0)
                return m_socket.receive();
            if (ready < 0 && errno != EINTR)
                return std::nullopt;
        }
    }

    Handle m_socket;
    pid_t m_id = 0;
    bool m_ended = false;
};

Message messageIn(const Packet& failure) {
    return messageFrom(nlohmann::ordered_json::parse(failure.text));
}

[[noreturn]] void failIn(const DecodeRequest& request, const std::optional<Packet>& answer) {
    if (answer && answer->kind == Packet::Failure && answer->number == kUsageFailure)
        throw UsageError(messageIn(*answer));
    if (answer && answer->kind == Packet::Failure)
        throw Error(messageIn(*answer));
    if (answer && answer->kind == Packet::TooLong)
        fail("{} takes too long to decode; save it again with another program.", request.path.string());
    fail(
        "{} cannot be read: its decoder broke down; the file is damaged, or of a kind that it does not know. "
        "Save it again with another program.",
        request.path.string());
}

} // namespace

SharedSamples::SharedSamples(int file, std::size_t bytes) : m_bytes(bytes) {
    void* const memory = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    if (memory == MAP_FAILED)
        fail("There is not enough memory to take up an image: {}.", std::strerror(errno));
    m_data = memory;
}

SharedSamples::~SharedSamples() {
    if (m_data)
        ::munmap(m_data, m_bytes);
}

SharedSamples::SharedSamples(SharedSamples&& other) noexcept
    : m_data(std::exchange(other.m_data, nullptr)), m_bytes(std::exchange(other.m_bytes, 0)) {}

SharedSamples& SharedSamples::operator=(SharedSamples&& other) noexcept {
    std::swap(m_data, other.m_data);
    std::swap(m_bytes, other.m_bytes);
    return *this;
}

void DecoderProcess::start(std::function<void()> check) {
    auto [ours, theirs] = Handle::connection();
    maker() = {};
    maker().check = std::move(check);
    if (!ours.open())
        return;
    const pid_t id = ::fork();
    if (id == 0) {
        ours = {};
        makeWorkers(std::move(theirs));
    }
    if (id > 0)
        maker().socket = std::move(ours);
}

bool DecoderProcess::running() {
    return maker().socket.open();
}

void DecoderProcess::check() {
    if (maker().check)
        maker().check();
    if (watching != nullptr)
        watching->m_check();
}

DecoderProcess::Watch::Watch(std::function<void()> check)
    : m_check(std::move(check)), m_outer(std::exchange(watching, this)) {}

DecoderProcess::Watch::~Watch() {
    watching = m_outer;
}

DecoderProcess::Decoded DecoderProcess::decode(const DecodeRequest& request) {
    auto [ours, theirs] = Handle::connection();
    if (!ours.open() || !maker().socket.send({Packet::Request, 0, requestText(request), std::move(theirs)}))
        fail("{} cannot be read: {}.", request.path.string(), std::strerror(errno));
    theirs = {};
    Worker worker(std::move(ours));
    const std::optional<Packet> answer = worker.answer();
    struct stat status {};
    if (!answer || answer->kind != Packet::Done || ::fstat(answer->file.number(), &status) != 0)
        failIn(request, answer);
    const auto bytes = static_cast<std::size_t>(status.st_size);
    Decoded decoded;
    decoded.memory = SharedSamples(answer->file.number(), bytes);
    const auto* const data = static_cast<const char*>(decoded.memory.data());
    if (answer->number >= bytes)
        failIn(request, std::nullopt);
    decoded.header = DecodedHeader::fromJson(std::string(data + answer->number, bytes - answer->number));
    decoded.samples = static_cast<const float*>(decoded.memory.data());
    return decoded;
}

} // namespace texloom
