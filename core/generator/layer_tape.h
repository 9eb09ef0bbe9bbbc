#pragma once

#include "core/generator/field_convolution.h"
#include "core/job/job_context.h"

#include <vector>

namespace texloom {

/// Statistics of a field's channels over its voxels.
struct ChannelStatistics {
    std::vector<double> mean, variance;
    double inverse(int channel) const;
    double normalised(int channel, float value) const {
        return (static_cast<double>(value) - mean[at(channel)]) * inverse(channel);
    }
};
ChannelStatistics statisticsOf(const Field& field, JobContext& context);

/// Normalises a field with its own statistics: scale · (x − mean) / √(variance + ε) + shift, into channels of
/// `out` from `first` on, and takes them into the running ones. @param slope see rectify();
/// kStraight: none.
ChannelStatistics normalise(const Field& in, float slope, Normalisation& norm, int first, Field& out,
                            JobContext& context);

/// The derivative by the input of normalise(). @param gradient that by its output, of channels from `first`
/// on.
/// @param to gets the input's shape and strides, and 0 wherever no voxel is. @param norm its scale and shift
/// get the derivative by these added. @param weights the normalisation itself.
void normaliseGradient(const Field& in, const ChannelStatistics& statistics, float slope,
                       const Normalisation& weights, const Field& gradient, int first, Field& to,
                       Normalisation& norm, JobContext& context);

/// One layer of a generator that learns: a convolution, normalised by the statistics of what goes through it
/// now, and a rectifier. Keeps what the way back needs.
class LayerTape {
public:
    /// @param layer its running statistics are brought up to date. @param slope of the rectifier.
    const Field& forward(const Field& in, GeneratorLayer& layer, float slope, JobContext& context);
    /// Adds the derivative by the layer's numbers to `sums`. @param gradient that by its output.
    /// @param inGradient gets that by the input; not wanted if null.
    void backward(const GeneratorLayer& layer, const Field& gradient, GeneratorLayer& sums, Field* inGradient,
                  JobContext& context);

private:
    const Field* m_in = nullptr;
    float m_slope = kStraight;
    Field m_filtered, m_out, m_change, m_surrounded;
    ChannelStatistics m_statistics;
};

/// Adds the derivative by a convolution's numbers, and gives that by its input.
/// @param change that by the output, with the rows of the input and 0 wherever no voxel is.
void convolutionGradient(const Field& in, const FieldFilters& filters, const Field& change,
                         FieldFilters& sums, Field& surrounded, Field* inGradient, JobContext& context);

} // namespace texloom
