#pragma once

#include <cstdint>

namespace texloom {

/// Addresses that this process may still take, in bytes: what the system's limit RLIMIT_AS (`ulimit -v`)
/// leaves; kUnlimitedMemory where there is no limit.
std::uint64_t addressesLeft();

/// Of so many threads, how many can be started within `addresses`, this one included; at least one. Libraries
/// abort where they cannot start a thread that they were told to.
int startableThreads(int threads, std::uint64_t addresses);

} // namespace texloom
