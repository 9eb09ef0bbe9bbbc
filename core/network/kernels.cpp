#include "core/network/kernels.h"

#include "core/network/kernels_wide.h"

#define TEXLOOM_KERNELS plain_kernels
#define TEXLOOM_KERNEL_LANES 4
#include "core/network/kernel_body.h"

namespace texloom {

void convolveFlatPlain(const FlatConvolution& what) {
    plain_kernels::convolve(what);
}

void addRowProductsPlain(const RowProducts& what) {
    plain_kernels::addProducts(what);
}

void convolveFlat(const FlatConvolution& what) {
    static const bool wide = hasWideKernels();
    wide ? convolveFlatWide(what) : convolveFlatPlain(what);
}

void addRowProducts(const RowProducts& what) {
    static const bool wide = hasWideKernels();
    wide ? addRowProductsWide(what) : addRowProductsPlain(what);
}

} // namespace texloom
