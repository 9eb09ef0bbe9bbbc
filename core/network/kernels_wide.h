#pragma once

#include "core/network/kernel_work.h"

namespace texloom {

/// The kernels for vectors of eight numbers; only where the processor has AVX2 (hasWideKernels()).
void convolveFlatWide(const FlatConvolution& what);
void addRowProductsWide(const RowProducts& what);
/// The same for vectors of four, which every machine has.
void convolveFlatPlain(const FlatConvolution& what);
void addRowProductsPlain(const RowProducts& what);
/// Whether this machine can run those for eight.
bool hasWideKernels();

} // namespace texloom
