#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

namespace texloom {

struct Packet;

/// An open file of the system, such as one end of a connection between two processes; closed with the object.
class Handle {
public:
    Handle() = default;
    explicit Handle(int number) : m_number(number) {}
    ~Handle();
    Handle(Handle&& other) noexcept : m_number(std::exchange(other.m_number, -1)) {}
    Handle& operator=(Handle&& other) noexcept;

    /// Both ends of a connection that keeps messages apart; neither is open() if there is none to be had.
    static std::pair<Handle, Handle> connection();

    bool open() const { return m_number >= 0; }
    int number() const { return m_number; }
    /// Sends over a connection. @return false if the other end is gone, or the system refuses.
    bool send(const Packet& message) const;
    /// The next message of a connection; none if the other end is gone.
    std::optional<Packet> receive() const;

private:
    int m_number = -1;
};

/// What the program, the process that makes decoders and the decoders tell one another.
struct Packet {
    enum Kind : std::uint32_t {
        Request, ///< text: what to decode; file: where to answer
        Id,      ///< number: the decoder's process
        Done,    ///< file: memory with the samples and the header behind them; number: bytes of samples
        Failure, ///< text: a sentence
        TooLong  ///< the time for one file is over
    };
    /// Longer texts are cut off.
    static constexpr std::size_t kLongestText = 32768;

    Kind kind = Request;
    std::uint64_t number = 0;
    std::string text = {};
    Handle file = {};
};

/// Packet::number of a Failure that is a UsageError.
inline constexpr std::uint64_t kUsageFailure = 1;

/// Sends a message without text from where little may be called, such as a signal's handler.
void sendPlain(int connection, Packet::Kind kind);

} // namespace texloom
