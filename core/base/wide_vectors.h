#pragma once

/// Marks a function whose loops are compiled twice: for machines with wider vectors, and for all others. The
/// first use picks one. Both give the same bits, since each lane does what it would do alone and products are
/// never fused with sums. What the function calls must be inlined into it.
#if defined(__x86_64__) && defined(__linux__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) &&    \
    !defined(__SANITIZE_THREAD__)
#define TEXLOOM_WIDE_VECTORS __attribute__((target_clones("avx2", "default")))
#else
#define TEXLOOM_WIDE_VECTORS
#endif
