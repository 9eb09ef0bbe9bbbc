#pragma once

#include <cstddef>

namespace texloom {

/// Some output channels of a convolution over a flat array: input planes are laid out with the gaps of their
/// padding, so that the neighbour in any direction is at a constant distance.
///
///     out[o][i] = bias[o] + Σ_c Σ_t weights[c][t][o] · in[c][i + offsets[t]],   first ≤ i < last
struct FlatConvolution {
    const float* in = nullptr;
    std::ptrdiff_t inPlane = 0; ///< from one input channel to the next
    int inputs = 0;
    const std::ptrdiff_t* offsets = nullptr;
    int taps = 0;
    const float* weights = nullptr; ///< inputs × taps × block
    const float* bias = nullptr;    ///< block
    float* out = nullptr;           ///< out[o][first] is at out + o · outPlane
    std::ptrdiff_t outPlane = 0;
    std::ptrdiff_t first = 0, last = 0;
    int block = 0; ///< output channels: one of kConvolutionBlocks
};

/// So many output channels can be done at once; the first that divides a number suits it best.
inline constexpr int kConvolutionBlocks[] = {6, 4, 3, 2, 1};
/// The convolution reads and writes up to so many numbers beyond its end.
inline constexpr int kConvolutionSlack = 64;

/// The products of rows with rows: sums[i · columns + j] += Σ_n a[i][n] · b[j][n], in pieces of
/// kRowPiece whose sums are of single precision and which are added in double.
struct RowProducts {
    const float* a = nullptr;
    std::ptrdiff_t aRow = 0; ///< from one row to the next
    int rows = 0;
    const float* b = nullptr;
    std::ptrdiff_t bRow = 0;
    int columns = 0;
    std::size_t length = 0;
    double* sums = nullptr;
    std::ptrdiff_t sumsRow = 0;
};
inline constexpr std::size_t kRowPiece = 1024;

} // namespace texloom
