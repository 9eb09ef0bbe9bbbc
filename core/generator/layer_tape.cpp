#include "core/generator/layer_tape.h"

#include <algorithm>
#include <cmath>

namespace texloom {

namespace {

constexpr double kMomentum = 0.1; ///< of the running statistics

double voxelsOf(const Field& field) {
    return static_cast<double>(field.size().voxels());
}

/// Calls visit(y, z) for every row.
template <class Visit> void everyRow(const VolumeSize& size, const Visit& visit) {
    for (int z = 0; z < size.depth; ++z)
        for (int y = 0; y < size.height; ++y)
            visit(y, z);
}

/// Takes the statistics of a slice into the running ones, the variance without its bias.
void takeIn(const ChannelStatistics& statistics, double voxels, Normalisation& norm) {
    const auto mix = [](float& running, double now) {
        running = static_cast<float>((1 - kMomentum) * static_cast<double>(running) + kMomentum * now);
    };
    for (std::size_t c = 0; c < norm.mean.size(); ++c) {
        mix(norm.mean[c], statistics.mean[c]);
        mix(norm.variance[c], statistics.variance[c] * voxels / std::max(1.0, voxels - 1));
    }
}

} // namespace

double ChannelStatistics::inverse(int channel) const {
    return 1 / std::sqrt(variance[at(channel)] + Normalisation::kEpsilon);
}

ChannelStatistics statisticsOf(const Field& field, JobContext& context) {
    ChannelStatistics made{std::vector<double>(at(field.channels())),
                           std::vector<double>(at(field.channels()))};
    context.parallel(0, field.channels(), [&](int c) {
        double sum = 0, squares = 0;
        everyRow(field.size(), [&](int y, int z) {
            const float* row = field.row(c, y, z);
            for (int x = 0; x < field.size().width; ++x)
                sum += static_cast<double>(row[x]);
        });
        const double mean = sum / voxelsOf(field);
        everyRow(field.size(), [&](int y, int z) {
            const float* row = field.row(c, y, z);
            for (int x = 0; x < field.size().width; ++x)
                squares += (static_cast<double>(row[x]) - mean) * (static_cast<double>(row[x]) - mean);
        });
        made.mean[at(c)] = mean;
        made.variance[at(c)] = squares / voxelsOf(field);
    });
    return made;
}

ChannelStatistics normalise(const Field& in, float slope, Normalisation& norm, int first, Field& out,
                            JobContext& context) {
    ChannelStatistics statistics = statisticsOf(in, context);
    context.parallel(0, in.channels(), [&](int c) {
        const double factor = static_cast<double>(norm.scale[at(c)]) * statistics.inverse(c);
        const auto scale = static_cast<float>(factor);
        const auto shift =
            static_cast<float>(static_cast<double>(norm.shift[at(c)]) - factor * statistics.mean[at(c)]);
        everyRow(in.size(), [&](int y, int z) {
            const float* from = in.row(c, y, z);
            float* to = out.row(first + c, y, z);
            for (int x = 0; x < in.size().width; ++x)
                to[x] = scale * from[x] + shift;
            if (slope != kStraight)
                rectify(to, in.size().width, slope);
        });
    });
    takeIn(statistics, voxelsOf(in), norm);
    return statistics;
}

void normaliseGradient(const Field& in, const ChannelStatistics& statistics, float slope,
                       const Normalisation& weights, const Field& gradient, int first, Field& to,
                       Normalisation& norm, JobContext& context) {
    to.resize(in.channels(), in.size(), in.rowStride());
    context.parallel(0, in.channels(), [&](int c) {
        const auto mean = static_cast<float>(statistics.mean[at(c)]);
        const auto inverse = static_cast<float>(statistics.inverse(c));
        const float scale = weights.scale[at(c)], shift = weights.shift[at(c)];
        double sum = 0, product = 0;
        everyRow(in.size(), [&](int y, int z) {
            const float* from = in.row(c, y, z);
            const float* wanted = gradient.row(first + c, y, z);
            float* row = to.row(c, y, z);
            for (int x = 0; x < in.size().width; ++x) {
                const float normal = (from[x] - mean) * inverse;
                const float change = scale * normal + shift < 0 ? slope * wanted[x] : wanted[x];
                row[x] = change;
                sum += static_cast<double>(change);
                product += static_cast<double>(change) * static_cast<double>(normal);
            }
        });
        norm.shift[at(c)] += static_cast<float>(sum);
        norm.scale[at(c)] += static_cast<float>(product);
        const auto meanChange = static_cast<float>(sum / voxelsOf(in));
        const auto meanProduct = static_cast<float>(product / voxelsOf(in));
        const float factor = scale * inverse;
        everyRow(in.size(), [&](int y, int z) {
            const float* from = in.row(c, y, z);
            float* row = to.row(c, y, z);
            for (int x = 0; x < in.size().width; ++x)
                row[x] = factor * (row[x] - meanChange - (from[x] - mean) * inverse * meanProduct);
            std::fill(row + in.size().width, row + in.rowStride(), 0.0F);
        });
    });
}

void convolutionGradient(const Field& in, const FieldFilters& filters, const Field& change,
                         FieldFilters& sums, Field& surrounded, Field* inGradient, JobContext& context) {
    const std::size_t count = sums.weights.size();
    std::vector<double> exact(count + sums.bias.size(), 0.0);
    context.parallel(0, in.channels(), [&](int c) { addFilterGradient(in, change, filters.taps, c, exact); });
    for (std::size_t i = 0; i < count; ++i)
        sums.weights[i] += static_cast<float>(exact[i]);
    for (std::size_t i = 0; i < sums.bias.size(); ++i)
        sums.bias[i] += static_cast<float>(exact[count + i]);
    if (!inGradient)
        return;
    const FieldConvolution back = FieldConvolution::transposed(filters);
    const int margin = filters.taps == 1 ? 0 : 2, deep = filters.taps == 27 ? 2 : 0;
    const VolumeSize& size = change.size();
    surrounded.resize(change.channels(),
                      {size.width + 2 * margin, size.height + 2 * margin, size.depth + 2 * deep},
                      size.width + 2 * margin);
    surrounded.clear();
    context.parallel(0, change.channels(), [&](int c) {
        everyRow(size, [&](int y, int z) {
            std::copy_n(change.row(c, y, z), size.width, surrounded.row(c, y + margin, z + deep) + margin);
        });
    });
    back.prepare(surrounded, *inGradient, filters.inputs);
    back.all(surrounded, kStraight, *inGradient, context);
}

const Field& LayerTape::forward(const Field& in, GeneratorLayer& layer, float slope, JobContext& context) {
    m_in = &in;
    m_slope = slope;
    const FieldConvolution convolution(layer.filters);
    convolution.prepare(in, m_filtered, layer.filters.outputs);
    convolution.all(in, kStraight, m_filtered, context);
    m_out.resize(m_filtered.channels(), m_filtered.size(), m_filtered.rowStride());
    m_statistics = normalise(m_filtered, slope, layer.norm, 0, m_out, context);
    return m_out;
}

void LayerTape::backward(const GeneratorLayer& layer, const Field& gradient, GeneratorLayer& sums,
                         Field* inGradient, JobContext& context) {
    normaliseGradient(m_filtered, m_statistics, m_slope, layer.norm, gradient, 0, m_change, sums.norm,
                      context);
    convolutionGradient(*m_in, layer.filters, m_change, sums.filters, m_surrounded, inGradient, context);
}

} // namespace texloom
