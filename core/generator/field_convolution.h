#pragma once

#include "core/generator/field.h"
#include "core/generator/generator_weights.h"
#include "core/job/job_context.h"

#include <vector>

namespace texloom {

/// A convolution of fields without padding, which is a correlation: an output voxel is the bias and the sum
/// over inputs and taps of weight × the voxel `tap` after its place, always added in the same order. So its
/// bits depend neither on the box nor on the machine.
class FieldConvolution {
public:
    FieldConvolution() = default;
    explicit FieldConvolution(const FieldFilters& filters);
    /// The convolution that carries a derivative by the output, surrounded by zeros, back to the input.
    static FieldConvolution transposed(const FieldFilters& filters);

    int outputs() const { return m_outputs; }
    /// Size of the output for an input of this size.
    VolumeSize outputSize(const VolumeSize& input) const;
    /// Gives `out` its shape; rows are as far apart as those of the input.
    void prepare(const Field& in, Field& out, int channels) const;
    /// All channels of plane z of the output. @param out prepared. @param slope by which what is below 0 is
    /// multiplied; kStraight: nothing is.
    void plane(const Field& in, int z, float slope, Field& out) const;
    /// All planes, planes and channels beside each other.
    void all(const Field& in, float slope, Field& out, JobContext& context) const;

private:
    void block(const Field& in, int z, int first, float slope, Field& out) const;

    int m_outputs = 0, m_inputs = 0, m_taps = 1, m_block = 1;
    std::vector<float> m_weights; ///< blocks × inputs × taps × block
    std::vector<float> m_bias;
};

/// Adds the derivative of a convolution by its weights and bias. @param gradient the derivative by the
/// output: rows as far apart as those of the input, and 0 wherever no voxel is. @param sums outputs × inputs
/// × taps, and the bias behind them. @param input the channel of the input whose weights are done; the first
/// does the bias, too.
void addFilterGradient(const Field& in, const Field& gradient, int taps, int input,
                       std::vector<double>& sums);

/// Where the taps of a filter lie.
std::vector<std::ptrdiff_t> tapOffsets(int taps, std::ptrdiff_t row, std::ptrdiff_t plane);

/// Multiplies what is below 0 by `slope`, from 0 to 1.
void rectify(float* values, std::ptrdiff_t count, float slope);

} // namespace texloom
