#pragma once

#include "core/job/job_context.h"
#include "core/network/tensor.h"

namespace texloom {

/// How a network halves its feature maps.
enum class Pooling { Average, Maximum };

/// Each 2×2 pixels become one: their mean or their largest. Of an odd side the last pixels are alone, so that
/// none is left out. @param out gets its shape, half of each side rounded up.
void pool(const Tensor& in, Pooling pooling, Tensor& out, JobContext& context);

/// Adds the derivative by the input. @param in as given to pool(). Of several largest pixels the first
/// counts.
void addPoolGradient(const Tensor& in, Pooling pooling, const Tensor& outGradient, Tensor& inGradient,
                     JobContext& context);

} // namespace texloom
