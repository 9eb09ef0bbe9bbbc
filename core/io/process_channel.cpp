#include "core/io/process_channel.h"

#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

namespace texloom {

namespace {

struct Head {
    std::uint64_t number;
    std::uint32_t kind;
    std::uint32_t length;
};

/// Room for the one open file that may go with a message.
union Control {
    cmsghdr head; // aligns the rest
    std::array<char, CMSG_SPACE(sizeof(int))> bytes;
};

} // namespace

Handle::~Handle() {
    if (m_number >= 0)
        ::close(m_number);
}

Handle& Handle::operator=(Handle&& other) noexcept {
    std::swap(m_number, other.m_number);
    return *this;
}

std::pair<Handle, Handle> Handle::connection() {
    std::array<int, 2> ends{-1, -1};
    if (::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) != 0)
        return {};
    return {Handle(ends[0]), Handle(ends[1])};
}

bool Handle::send(const Packet& message) const {
    const std::size_t length = std::min(message.text.size(), Packet::kLongestText);
    Head head{message.number, message.kind, static_cast<std::uint32_t>(length)};
    std::array<iovec, 2> parts = {{{&head, sizeof(head)}, {const_cast<char*>(message.text.data()), length}}};
    Control control{};
    msghdr packet{};
    packet.msg_iov = parts.data();
    packet.msg_iovlen = parts.size();
    if (message.file.open()) {
        packet.msg_control = control.bytes.data();
        packet.msg_controllen = control.bytes.size();
        cmsghdr* const attached = CMSG_FIRSTHDR(&packet);
        attached->cmsg_level = SOL_SOCKET;
        attached->cmsg_type = SCM_RIGHTS;
        attached->cmsg_len = CMSG_LEN(sizeof(int));
        const int number = message.file.number();
        std::memcpy(CMSG_DATA(attached), &number, sizeof(number));
    }
    ssize_t sent = -1;
    do
        sent = ::sendmsg(m_number, &packet, MSG_NOSIGNAL);
    while (sent < 0 && errno == EINTR);
    return sent >= 0;
}

std::optional<Packet> Handle::receive() const {
    std::string text(Packet::kLongestText, '\0');
    Head head{};
    std::array<iovec, 2> parts = {{{&head, sizeof(head)}, {text.data(), text.size()}}};
    Control control{};
    msghdr packet{};
    packet.msg_iov = parts.data();
    packet.msg_iovlen = parts.size();
    packet.msg_control = control.bytes.data();
    packet.msg_controllen = control.bytes.size();
    ssize_t count = -1;
    do
        count = ::recvmsg(m_number, &packet, MSG_CMSG_CLOEXEC);
    while (count < 0 && errno == EINTR);
    if (count < static_cast<ssize_t>(sizeof(head)))
        return std::nullopt;
    Packet message{static_cast<Packet::Kind>(head.kind), head.number, {}, {}};
    text.resize(std::min<std::size_t>(head.length, static_cast<std::size_t>(count) - sizeof(head)));
    message.text = std::move(text);
    if (const cmsghdr* const attached = CMSG_FIRSTHDR(&packet);
        attached && attached->cmsg_level == SOL_SOCKET && attached->cmsg_type == SCM_RIGHTS) {
        int number = -1;
        std::memcpy(&number, CMSG_DATA(attached), sizeof(number));
        message.file = Handle(number);
    }
    return message;
}

void sendPlain(int connection, Packet::Kind kind) {
    const Head head{0, kind, 0};
    [[maybe_unused]] const ssize_t sent = ::send(connection, &head, sizeof(head), MSG_NOSIGNAL);
}

} // namespace texloom
