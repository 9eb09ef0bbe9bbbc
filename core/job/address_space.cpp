#include "core/job/address_space.h"

#include "core/job/memory.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace texloom {

namespace {

/// Each thread takes a stack and, once it allocates, a part of the heap of its own, of which the C library
/// reserves the addresses, twice as many at first so that it begins at a round one.
constexpr std::uint64_t kHeapAddresses = 2 * (64ULL << 20);
constexpr std::uint64_t kUsualStack = 8ULL << 20;
/// Left for everything else.
constexpr std::uint64_t kForWork = 64ULL << 20;
/// What libraries take before main(): four threads of one that writes logs, and some memory.
constexpr std::uint64_t kThreadsOfLibraries = 4;
constexpr std::uint64_t kForLibraries = 32ULL << 20;

/// Addresses that are taken, in bytes. Read without streams, which are not there yet before main().
std::uint64_t addressesTaken() {
    constexpr std::uint64_t kPage = 4096;
    std::array<char, 32> text{};
    const int file = ::open("/proc/self/statm", O_RDONLY | O_CLOEXEC);
    const bool read = file >= 0 && ::read(file, text.data(), text.size() - 1) > 0;
    if (file >= 0)
        ::close(file);
    return read ? kPage * std::strtoull(text.data(), nullptr, 10) : 0;
}

std::uint64_t stackAddresses() {
    rlimit limit{};
    return ::getrlimit(RLIMIT_STACK, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY ? limit.rlim_cur
                                                                                     : kUsualStack;
}

unsigned long long wholeMebibytes(std::uint64_t bytes) {
    return bytes >> 20U;
}

} // namespace

std::uint64_t addressesLeft() {
    rlimit limit{};
    if (::getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY)
        return kUnlimitedMemory;
    return limit.rlim_cur - std::min<std::uint64_t>(limit.rlim_cur, addressesTaken());
}

int startableThreads(int threads, std::uint64_t addresses) {
    const std::uint64_t room = addresses - std::min(addresses, kForWork);
    const std::uint64_t others = room / (kHeapAddresses + stackAddresses());
    return others + 1 < static_cast<std::uint64_t>(threads) ? static_cast<int>(others) + 1 : threads;
}

void endWhereAddressesAreFew(int argc, char** argv, char** /*environment*/) {
    const std::uint64_t left = addressesLeft();
    if (left == kUnlimitedMemory)
        return;
    ::setenv("OPENBLAS_NUM_THREADS", "1", 0); // else one for each core, for nothing that is used here
    const std::uint64_t needed = kForLibraries + kThreadsOfLibraries * stackAddresses();
    if (left >= needed)
        return;
    const char* const path = argc > 0 ? argv[0] : "texloom";
    const char* const folderEnd = std::strrchr(path, '/');
    std::array<char, 512> sentence{};
    const int length = std::snprintf(
        sentence.data(), sentence.size(),
        "%.100s: The limit of addresses (ulimit -v) leaves %llu MiB once the program is loaded, and it needs "
        "%llu MiB to begin; raise the limit by %llu MiB or more.\n",
        folderEnd != nullptr ? folderEnd + 1 : path, wholeMebibytes(left), wholeMebibytes(needed),
        1 + wholeMebibytes(needed - left));
    [[maybe_unused]] const ssize_t written =
        ::write(STDERR_FILENO, sentence.data(), static_cast<std::size_t>(std::max(length, 0)));
    ::_exit(1);
}

} // namespace texloom
