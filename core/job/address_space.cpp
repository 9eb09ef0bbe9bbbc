#include "core/job/address_space.h"

#include "core/job/memory.h"

#include <sys/resource.h>

#include <algorithm>
#include <fstream>

namespace texloom {

namespace {

/// Each thread takes a stack and, once it allocates, a part of the heap of its own, of which the C library
/// reserves the addresses, twice as many at first so that it begins at a round one.
constexpr std::uint64_t kHeapAddresses = 2 * (64ULL << 20);
constexpr std::uint64_t kUsualStack = 8ULL << 20;
/// Left for everything else.
constexpr std::uint64_t kForWork = 64ULL << 20;

/// Addresses that are taken, in bytes.
std::uint64_t addressesTaken() {
    std::ifstream file("/proc/self/statm");
    std::uint64_t pages = 0;
    constexpr std::uint64_t kPage = 4096;
    return file >> pages ? pages * kPage : 0;
}

std::uint64_t stackAddresses() {
    rlimit limit{};
    return ::getrlimit(RLIMIT_STACK, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY ? limit.rlim_cur
                                                                                     : kUsualStack;
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

} // namespace texloom
