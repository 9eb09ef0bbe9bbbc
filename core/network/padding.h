#pragma once

#include "core/job/job_context.h"
#include "core/network/tensor.h"

#include <vector>

namespace texloom {

/// What a convolution finds beyond the edges of its input.
enum class Padding {
    None,     ///< nothing: the output is smaller by the filter's side less 1
    Zero,     ///< zeros
    Reflect,  ///< the input mirrored at its outermost pixels, which are not repeated
    Circular, ///< the input from its other end
};

/// The padding of both axes.
struct Edges {
    Padding x = Padding::Reflect, y = Padding::Reflect;

    static Edges all(Padding padding) { return {padding, padding}; }
    bool circular() const { return x == Padding::Circular && y == Padding::Circular; }
};

/// For each place along a padded axis of `length` pixels the pixel that stands there; −1: none, which counts
/// as 0. @param width of the padding on each side.
std::vector<int> paddedIndices(int length, int width, Padding padding);

/// The planes of `in` with that around them, each channel a plane of `padded`.
void pad(const Tensor& in, const std::vector<int>& columns, const std::vector<int>& rows, Tensor& padded,
         JobContext& context);

/// The transpose of pad(): adds every pixel of `padded` to the one that it was a copy of.
void addFolded(const Tensor& padded, const std::vector<int>& columns, const std::vector<int>& rows,
               Tensor& in, JobContext& context);

} // namespace texloom
