// Compiled for AVX2 where the processors of the target may have it; see core/CMakeLists.txt.
#include "core/network/kernels_wide.h"

#define TEXLOOM_KERNELS wide_kernels
#ifdef __AVX2__
#define TEXLOOM_KERNEL_LANES 8
#else
#define TEXLOOM_KERNEL_LANES 4
#endif
#include "core/network/kernel_body.h"

namespace texloom {

void convolveFlatWide(const FlatConvolution& what) {
    wide_kernels::convolve(what);
}

void addRowProductsWide(const RowProducts& what) {
    wide_kernels::addProducts(what);
}

bool hasWideKernels() {
#ifdef __AVX2__
    return __builtin_cpu_supports("avx2") != 0;
#else
    return false;
#endif
}

} // namespace texloom
