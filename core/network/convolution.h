#pragma once

#include "core/job/job_context.h"
#include "core/job/pool.h"
#include "core/network/padding.h"
#include "core/network/tensor.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace texloom {

/// The weights of a convolution.
struct Filters {
    int outputs = 0, inputs = 0;
    int side = 1;               ///< odd, in pixels
    std::vector<float> weights; ///< outputs × inputs × side × side
    std::vector<float> bias;    ///< outputs

    /// All 0.
    static Filters zero(int outputs, int inputs, int side);
    float& at(int output, int input, int y, int x);
    float at(int output, int input, int y, int x) const;
};

/// Working memory of convolutions, to be used by one after another.
struct ConvolutionBuffers {
    Tensor padded, unfolded;
    std::vector<double> products;
    Pool<std::vector<float>> scratch;
};

/// A convolution as networks have it, which is a correlation:
///
///     out[o](y, x) = bias[o] + Σ_c Σ_j Σ_i w[o][c](j, i) · in[c](y + j − r, x + i − r),   r = (side − 1) / 2
///
/// or, without padding, with r = 0 for all (y, x) where that lies inside. Sums have a fixed order: the same
/// bits for any number of threads.
class Convolution {
public:
    explicit Convolution(Filters filters);

    const Filters& filters() const { return m_filters; }
    int outputs() const { return m_filters.outputs; }
    int inputs() const { return m_filters.inputs; }

    /// @param rectified whether what is below 0 becomes 0 (ReLU). @param out gets its shape.
    /// @throws Error if the input is smaller than an unpadded filter or has other channels.
    void forward(const Tensor& in, Edges edges, bool rectified, Tensor& out, ConvolutionBuffers& buffers,
                 JobContext& context) const;
    /// Adds the output of a convolution of side 1 to `out`.
    void add(const Tensor& in, Tensor& out, ConvolutionBuffers& buffers, JobContext& context) const;
    /// Adds the derivative of what has `outGradient` as its derivative by the output. @param inGradient of
    /// the input's shape.
    void addGradient(const Tensor& outGradient, Edges edges, Tensor& inGradient, ConvolutionBuffers& buffers,
                     JobContext& context) const;
    /// Adds the derivative by weights and bias. @param in as given to forward().
    void addWeightGradient(const Tensor& in, const Tensor& outGradient, Edges edges, Filters& gradient,
                           ConvolutionBuffers& buffers, JobContext& context) const;

private:
    struct Packed {
        int block = 1;
        std::vector<float> weights; ///< blocks × inputs × taps × block
        std::vector<float> bias;    ///< blocks × block
    };
    enum class Sink { Store, Rectify, Add };

    Packed packed(bool transposed) const;
    void run(const Packed& weights, const Tensor& padded, std::ptrdiff_t stride, int inputs,
             std::span<const std::ptrdiff_t> offsets, Sink sink, Tensor& out, ConvolutionBuffers& buffers,
             JobContext& context) const;

    Filters m_filters;
    Packed m_forward, m_backward;
};

/// What is below 0 in `output` had no part in it: sets `gradient` to 0 there (the derivative of ReLU).
void gateGradient(const Tensor& output, Tensor& gradient, JobContext& context);

} // namespace texloom
