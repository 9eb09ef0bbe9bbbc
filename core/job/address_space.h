#pragma once

#include <cstdint>

namespace texloom {

/// Addresses that this process may still take, in bytes: what the system's limit RLIMIT_AS (`ulimit -v`)
/// leaves; kUnlimitedMemory where there is no limit.
std::uint64_t addressesLeft();

/// Of so many threads, how many can be started within `addresses`, this one included; at least one. Libraries
/// abort where they cannot start a thread that they were told to.
int startableThreads(int threads, std::uint64_t addresses);

/// Ends the program in a sentence where the system's limit leaves too few addresses for the libraries to set
/// themselves up: some start threads before main(), and abort or hang where they get none. A pointer to it
/// stands in .preinit_array of a program, so that it runs once all libraries are loaded, before any of them.
void endWhereAddressesAreFew(int argc, char** argv, char** environment);

} // namespace texloom
