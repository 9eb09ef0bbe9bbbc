// A library that is loaded before a program (LD_PRELOAD) and makes one of its system calls go wrong. Only the
// calls that matter for files that Texloom writes are counted: those on its temporary files, and the renames
// that put them in their places.
//
// TEXLOOM_FAULT="kill:rename:3"   the process dies before its third rename
// TEXLOOM_FAULT="kill:fsync:2"    or before its second fsync, of a file or a folder
// TEXLOOM_FAULT="full:pwrite:5"   from the fifth write on the disk is full

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
    long at = 0; ///< 0: never
};

Fault faultAsked() {
    Fault fault;
    const char* const asked = std::getenv("TEXLOOM_FAULT");
    std::array<char, 8> kind{};
    if (asked && std::sscanf(asked, "%7[a-z]:%15[a-z]:%ld", kind.data(), fault.call.data(), &fault.at) == 3)
        fault.kills = std::strcmp(kind.data(), "kill") == 0;
    return fault;
}

/// Counts a call. @return whether it is to fail.
bool fails(const char* call) {
    static const Fault fault = faultAsked();
    static std::atomic<long> count = 0;
    if (fault.at == 0 || std::strcmp(call, fault.call.data()) != 0)
        return false;
    const long now = ++count;
    if (fault.kills && now == fault.at)
        ::kill(::getpid(), SIGKILL);
    return !fault.kills && now >= fault.at;
}

/// Whether a handle belongs to a file that is being written; sockets and memory files are none of it.
bool isTemporary(int handle) {
    std::array<char, 64> link{};
    std::array<char, 4096> path{};
    std::snprintf(link.data(), link.size(), "/proc/self/fd/%d", handle);
    const ssize_t length = ::readlink(link.data(), path.data(), path.size() - 1);
    return length > 0 && std::strstr(path.data(), ".texloom-") != nullptr;
}

template <class Function> Function* next(const char* name) {
    return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

} // namespace

extern "C" {

int rename(const char* from, const char* to) {
    static auto* const real = next<int(const char*, const char*)>("rename");
    if (std::strstr(from, ".texloom-") != nullptr && fails("rename")) {
        errno = ENOSPC;
        return -1;
    }
    return real(from, to);
}

int fsync(int handle) {
    static auto* const real = next<int(int)>("fsync");
    if (fails("fsync")) {
        errno = ENOSPC;
        return -1;
    }
    return real(handle);
}

ssize_t pwrite(int handle, const void* data, size_t size, off_t offset) {
    static auto* const real = next<ssize_t(int, const void*, size_t, off_t)>("pwrite");
    if (isTemporary(handle) && fails("pwrite")) {
        errno = ENOSPC;
        return -1;
    }
    return real(handle, data, size, offset);
}

ssize_t pwrite64(int handle, const void* data, size_t size, off64_t offset) {
    return pwrite(handle, data, size, offset);
}
}
