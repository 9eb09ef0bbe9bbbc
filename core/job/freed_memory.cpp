#include "core/job/freed_memory.h"

#include "core/base/large_memory.h"

#include <malloc.h>

#include <mutex>

namespace texloom {

void keepFreedMemory() {
    static std::once_flag once;
    std::call_once(once, [] {
        ::mallopt(M_MMAP_THRESHOLD, kLargeMemory);
        ::mallopt(M_TRIM_THRESHOLD, 1 << 28);
    });
}

void giveBackFreedMemory() {
    ::malloc_trim(0);
}

} // namespace texloom
