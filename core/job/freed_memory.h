#pragma once

namespace texloom {

/// What jobs free, glibc keeps for the next of their buffers instead of giving it back to the system and
/// asking anew, which costs a page fault for each 4 KiB: Portilla–Simoncelli on 256² had 73,000 of them, and
/// has 17,000. Holds for the whole program from the first call on. Buffers of kLargeMemory and more are not
/// glibc's.
void keepFreedMemory();

/// Gives what is kept back to the system: at the end of a job.
void giveBackFreedMemory();

} // namespace texloom
