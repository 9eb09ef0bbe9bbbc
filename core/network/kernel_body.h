#pragma once

#include "core/network/kernel_work.h"

// The inner loops for vectors of one width. Included by sources that are compiled for that width, each in a
// namespace of its own; they include nothing of the standard library, whose inline functions would else be
// compiled for machines that lack it.

namespace texloom::TEXLOOM_KERNELS {

constexpr int kLanes = TEXLOOM_KERNEL_LANES;
using Vector __attribute__((vector_size(kLanes * 4), aligned(4), may_alias)) = float;

/// Vectors of positions that are done with so many channels at once, so that all sums stay in registers.
constexpr int vectorsFor(int block) {
    return block >= 6 ? 2 : block == 4 ? 3 : block == 3 ? 4 : 6;
}

template <int Block> void convolveBlock(const FlatConvolution& what) {
    constexpr int kVectors = vectorsFor(Block);
    constexpr int kStep = kVectors * kLanes;
    for (std::ptrdiff_t i = what.first; i < what.last; i += kStep) {
        Vector sums[Block][kVectors];
        for (int o = 0; o < Block; ++o)
            for (int v = 0; v < kVectors; ++v)
                sums[o][v] = Vector{} + what.bias[o];
        const float* weight = what.weights;
        const float* plane = what.in + i;
        for (int c = 0; c < what.inputs; ++c, plane += what.inPlane)
            for (int t = 0; t < what.taps; ++t, weight += Block) {
                const float* const from = plane + what.offsets[t];
                Vector in[kVectors];
                for (int v = 0; v < kVectors; ++v)
                    in[v] = *reinterpret_cast<const Vector*>(from + v * kLanes);
                for (int o = 0; o < Block; ++o)
                    for (int v = 0; v < kVectors; ++v)
                        sums[o][v] += in[v] * weight[o];
            }
        float* const to = what.out + (i - what.first);
        for (int o = 0; o < Block; ++o)
            for (int v = 0; v < kVectors; ++v)
                *reinterpret_cast<Vector*>(to + o * what.outPlane + v * kLanes) = sums[o][v];
    }
}

inline void convolve(const FlatConvolution& what) {
    switch (what.block) {
    case 6:
        return convolveBlock<6>(what);
    case 4:
        return convolveBlock<4>(what);
    case 3:
        return convolveBlock<3>(what);
    case 2:
        return convolveBlock<2>(what);
    default:
        return convolveBlock<1>(what);
    }
}

/// The sums are kept in eight lanes whatever the width, so that their order is always the same.
constexpr int kSumLanes = 8, kParts = kSumLanes / kLanes;
/// Rows and columns that are done at once.
constexpr int kTileRows = kParts == 1 ? 4 : 2, kTileColumns = 3;

inline float total(const Vector (&parts)[kParts]) {
    float sum = 0;
    for (int lane = 0; lane < kSumLanes; ++lane)
        sum += parts[lane / kLanes][lane % kLanes];
    return sum;
}

/// One tile of products over one piece. Rows beyond the last are the last again, and dropped.
inline void addTile(const RowProducts& what, int firstRow, int firstColumn, std::size_t begin,
                    std::size_t end) {
    const float *a[kTileRows], *b[kTileColumns];
    for (int r = 0; r < kTileRows; ++r)
        a[r] = what.a + (firstRow + r < what.rows ? firstRow + r : what.rows - 1) * what.aRow;
    for (int c = 0; c < kTileColumns; ++c)
        b[c] = what.b + (firstColumn + c < what.columns ? firstColumn + c : what.columns - 1) * what.bRow;
    Vector sums[kTileRows][kTileColumns][kParts] = {};
    std::size_t n = begin;
    for (; n + kSumLanes <= end; n += kSumLanes)
        for (int p = 0; p < kParts; ++p) {
            const std::size_t at = n + static_cast<std::size_t>(p * kLanes);
            Vector columns[kTileColumns];
            for (int c = 0; c < kTileColumns; ++c)
                columns[c] = *reinterpret_cast<const Vector*>(b[c] + at);
            for (int r = 0; r < kTileRows; ++r) {
                const Vector row = *reinterpret_cast<const Vector*>(a[r] + at);
                for (int c = 0; c < kTileColumns; ++c)
                    sums[r][c][p] += row * columns[c];
            }
        }
    for (int r = 0; r < kTileRows && firstRow + r < what.rows; ++r)
        for (int c = 0; c < kTileColumns && firstColumn + c < what.columns; ++c) {
            float sum = total(sums[r][c]);
            for (std::size_t rest = n; rest < end; ++rest)
                sum += a[r][rest] * b[c][rest];
            what.sums[(firstRow + r) * what.sumsRow + firstColumn + c] += static_cast<double>(sum);
        }
}

inline void addProducts(const RowProducts& what) {
    for (std::size_t begin = 0; begin < what.length; begin += kRowPiece) {
        const std::size_t end = begin + kRowPiece < what.length ? begin + kRowPiece : what.length;
        for (int r = 0; r < what.rows; r += kTileRows)
            for (int c = 0; c < what.columns; c += kTileColumns)
                addTile(what, r, c, begin, end);
    }
}

} // namespace texloom::TEXLOOM_KERNELS
