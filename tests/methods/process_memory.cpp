#include "tests/methods/process_memory.h"

#include "core/job/memory.h"
#include "core/session/run/run.h"

#include <malloc.h>

#include <fstream>

namespace texloom::test {

std::optional<std::uint64_t> peakGrowth(const std::function<void()>& work) {
    // Large blocks go back to the system when they are freed, and are not taken from what an earlier run
    // left.
    ::mallopt(M_MMAP_THRESHOLD, 1 << 20);
    ::malloc_trim(0);
    std::ofstream reset("/proc/self/clear_refs");
    reset << "5" << std::flush;
    if (!reset)
        return std::nullopt;
    const std::uint64_t before = residentMemory();
    work();
    const std::uint64_t peak = peakMemory();
    return peak > before ? peak - before : 0;
}

} // namespace texloom::test
