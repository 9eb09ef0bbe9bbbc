// A library that is loaded before a program (LD_PRELOAD) and makes one of its system calls go wrong. Only the
// calls that matter for files that Texloom writes are counted: those on its temporary files, and the renames
// that put them in their places.
//
// TEXLOOM_FAULT="kill:rename:3"        the process dies before its third rename
// TEXLOOM_FAULT="kill:fsync:2"         or before its second fsync, of a file or a folder
// TEXLOOM_FAULT="kill:pwrite:1:.json"  or before its first write to a file whose name ends so
// TEXLOOM_FAULT="full:pwrite:5"        from the fifth write on the disk is full

#include <dlfcn.h>
#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

struct Fault {
    bool kills = false;
    std::array<char, 16> call{};
    long at = 0;                   ///< 0: never
    std::array<char, 32> ending{}; ///< of the files that count; all if empty
};

Fault faultAsked() {
    Fault fault;
    const char* const asked = std::getenv("TEXLOOM_FAULT");
    std::array<char, 8> kind{};
    if (asked && std::sscanf(asked, "%7[a-z]:%15[a-z]:%ld:%31s", kind.data(), fault.call.data(), &fault.at,
                             fault.ending.data()) >= 3)
        fault.kills = std::strcmp(kind.data(), "kill") == 0;
    return fault;
}

bool endsWith(const char* name, const char* ending) {
    const std::size_t length = std::strlen(name), last = std::strlen(ending);
    return length >= last && std::strcmp(name + length - last, ending) == 0;
}

/// Counts a call on a file. @return whether it is to fail.
bool fails(const char* call, const char* file) {
    static const Fault fault = faultAsked();
    static std::atomic<long> count = 0;
    if (fault.at == 0 || std::strcmp(call, fault.call.data()) != 0 || !endsWith(file, fault.ending.data()))
        return false;
    const long now = ++count;
    if (fault.kills && now == fault.at)
        ::kill(::getpid(), SIGKILL);
    return !fault.kills && now >= fault.at;
}

/// The name of the file behind a handle; empty where it has none.
std::array<char, 4096> nameOf(int handle) {
    std::array<char, 64> link{};
    std::array<char, 4096> path{};
    std::snprintf(link.data(), link.size(), "/proc/self/fd/%d", handle);
    const ssize_t length = ::readlink(link.data(), path.data(), path.size() - 1);
    path.at(static_cast<std::size_t>(length > 0 ? length : 0)) = '\0';
    return path;
}

/// Whether a file is one that is being written; sockets and memory files are none of it.
bool isTemporary(const char* file) {
    return std::strstr(file, ".texloom-") != nullptr;
}

template <class Function> Function* next(const char* name) {
    return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

} // namespace

extern "C" {

int rename(const char* from, const char* to) {
    static auto* const real = next<int(const char*, const char*)>("rename");
    if (isTemporary(from) && fails("rename", to)) {
        errno = ENOSPC;
        return -1;
    }
    return real(from, to);
}

int fsync(int handle) {
    static auto* const real = next<int(int)>("fsync");
    if (fails("fsync", nameOf(handle).data())) {
        errno = ENOSPC;
        return -1;
    }
    return real(handle);
}

ssize_t pwrite(int handle, const void* data, size_t size, off_t offset) {
    static auto* const real = next<ssize_t(int, const void*, size_t, off_t)>("pwrite");
    if (const auto name = nameOf(handle); isTemporary(name.data()) && fails("pwrite", name.data())) {
        errno = ENOSPC;
        return -1;
    }
    return real(handle, data, size, offset);
}

ssize_t pwrite64(int handle, const void* data, size_t size, off64_t offset) {
    return pwrite(handle, data, size, offset);
}
}
