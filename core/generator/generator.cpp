#include "core/generator/generator.h"

#include <algorithm>

namespace texloom {

namespace {

/// The convolution and what the normalisation behind it does.
FieldFilters folded(const GeneratorLayer& layer) {
    FieldFilters filters = layer.filters;
    for (int o = 0; o < filters.outputs; ++o) {
        const std::size_t channel = at(o);
        const double factor = layer.norm.factor(channel);
        for (int c = 0; c < filters.inputs; ++c)
            for (int t = 0; t < filters.taps; ++t)
                filters.filter(o, c)[t] =
                    static_cast<float>(factor * static_cast<double>(filters.filter(o, c)[t]));
        filters.bias[channel] = static_cast<float>(factor * (static_cast<double>(filters.bias[channel]) -
                                                             static_cast<double>(layer.norm.mean[channel])) +
                                                   static_cast<double>(layer.norm.shift[channel]));
    }
    return filters;
}

/// The layer with the normalisation of its inputs, from channel `first` on, taken into it.
void foldInputs(const Normalisation& norm, int first, FieldFilters& filters) {
    for (int o = 0; o < filters.outputs; ++o) {
        auto bias = static_cast<double>(filters.bias[at(o)]);
        for (int c = 0; c < norm.channels(); ++c) {
            const double factor = norm.factor(at(c));
            const double shift =
                static_cast<double>(norm.shift[at(c)]) - factor * static_cast<double>(norm.mean[at(c)]);
            for (int t = 0; t < filters.taps; ++t) {
                float& weight = filters.filter(o, first + c)[t];
                bias += shift * static_cast<double>(weight);
                weight = static_cast<float>(factor * static_cast<double>(weight));
            }
        }
        filters.bias[at(o)] = static_cast<float>(bias);
    }
}

/// The last convolution and the mix of its channels that are the output's.
FieldFilters mixed(const GeneratorWeights& weights) {
    FieldFilters filters = weights.last;
    const int channels = filters.outputs;
    for (int o = 0; o < channels; ++o) {
        auto bias = static_cast<double>(weights.mean[at(o)]);
        std::vector<double> sums(at(filters.inputs), 0.0);
        for (int k = 0; k < channels; ++k) {
            const auto share = static_cast<double>(weights.mix[at(o) * at(channels) + at(k)]);
            bias += share * static_cast<double>(weights.last.bias[at(k)]);
            for (int c = 0; c < filters.inputs; ++c)
                sums[at(c)] += share * static_cast<double>(*weights.last.filter(k, c));
        }
        filters.bias[at(o)] = static_cast<float>(bias);
        for (int c = 0; c < filters.inputs; ++c)
            *filters.filter(o, c) = static_cast<float>(sums[at(c)]);
    }
    return filters;
}

} // namespace

Generator::Generator(const GeneratorWeights& weights) : m_shape(weights.shape), m_last(mixed(weights)) {
    for (std::size_t k = 0; k < weights.scales.size(); ++k) {
        const GeneratorWeights::Scale& from = weights.scales[k];
        Scale& scale = m_scales.emplace_back();
        for (std::size_t i = 0; i < 3; ++i) {
            scale.noise[i] = FieldConvolution(folded(from.noise[i]));
            if (k + 1 == weights.scales.size())
                continue;
            // What comes in is normalised first, so that it is folded into filters that the layer's own
            // normalisation has multiplied already.
            FieldFilters filters = folded(from.joined[i]);
            if (i == 0) {
                foldInputs(from.up, 0, filters);
                foldInputs(from.side, from.up.channels(), filters);
            }
            scale.joined[i] = FieldConvolution(filters);
        }
    }
}

/// Of a solid the second convolution of a plane and the third of it while it is at hand.
void Generator::runBlock(const Block& block, const Field& in, Field& out, Buffers& buffers,
                         JobContext& context) const {
    const float slope = m_shape.slope();
    block[0].prepare(in, buffers.first, block[0].outputs());
    block[0].all(in, slope, buffers.first, context);
    block[1].prepare(buffers.first, buffers.second, block[1].outputs());
    block[2].prepare(buffers.second, out, block[2].outputs());
    if (out.size().depth == 1) {
        block[1].all(buffers.first, slope, buffers.second, context);
        block[2].all(buffers.second, slope, out, context);
        return;
    }
    context.parallel(0, out.size().depth, [&](int z) {
        context.check();
        block[1].plane(buffers.first, z, slope, buffers.second);
        block[2].plane(buffers.second, z, slope, out);
    });
}

/// The coarser scale's features at the voxels of a box, with those of the noise behind them.
void Generator::join(const Field& up, const Box& box, const CoarserPlaces& places, Buffers& buffers,
                     JobContext& context) const {
    const int ups = up.channels(), channels = ups + buffers.side.channels();
    buffers.joined.resize(channels, box.size, box.size.width);
    context.parallel(0, channels * box.size.depth, [&](int task) {
        const int z = task / channels, c = task % channels;
        for (int y = 0; y < box.size.height; ++y) {
            float* to = buffers.joined.row(c, y, z);
            if (c >= ups) {
                std::copy_n(buffers.side.row(c - ups, y, z), box.size.width, to);
                continue;
            }
            const float* from = up.row(c, places.y[at(y)], places.z[at(z)]);
            for (int x = 0; x < box.size.width; ++x)
                to[x] = from[places.x[at(x)]];
        }
    });
}

Volume Generator::evaluate(const Box& box, const GeneratorNoise& noise, JobContext& context) const {
    box.check();
    const bool flat = m_shape.dimensions == 2;
    const std::vector<ScaleBoxes> boxes = scaleBoxes(box, m_shape.coarsest, flat, noise.period());
    const auto buffers = m_buffers.borrow([] { return Buffers{}; });
    buffers->outputs.resize(boxes.size());
    for (int k = m_shape.coarsest; k >= 0; --k) {
        const ScaleBoxes& own = boxes[at(k)];
        const Scale& scale = m_scales[at(k)];
        noise.fill(own.noise, k, m_shape.noiseChannels, buffers->noise, context);
        Field& out = buffers->outputs[at(k)];
        if (k == m_shape.coarsest) {
            runBlock(scale.noise, buffers->noise, out, *buffers, context);
            continue;
        }
        runBlock(scale.noise, buffers->noise, buffers->side, *buffers, context);
        join(buffers->outputs[at(k + 1)], own.joined,
             CoarserPlaces(own.joined, boxes[at(k + 1)].output, flat, noise.period(k)), *buffers, context);
        runBlock(scale.joined, buffers->joined, out, *buffers, context);
    }
    Volume made(box.size, m_shape.channels);
    Field& colours = buffers->first;
    m_last.prepare(buffers->outputs.front(), colours, m_shape.channels);
    context.parallel(0, box.size.depth, [&](int z) {
        m_last.plane(buffers->outputs.front(), z, kStraight, colours);
        for (int c = 0; c < m_shape.channels; ++c)
            for (int y = 0; y < box.size.height; ++y)
                std::copy_n(colours.row(c, y, z), box.size.width, made.row(y, z, c));
    });
    return made;
}

std::uint64_t Generator::bytesFor(const GeneratorShape& shape, const VolumeSize& size) {
    const auto grown = [](int side) { return static_cast<std::uint64_t>(side) + 8; };
    const std::uint64_t planes = shape.dimensions == 3 ? grown(size.depth) : 1;
    // The joined field and two between the convolutions; coarser scales add a seventh of that.
    return planes * (grown(size.width) * grown(size.height) + Field::kSlack) * sizeof(float) *
               at(shape.joinedChannels(0)) * 4 +
           (1U << 20U);
}

double Generator::productsFor(const GeneratorShape& shape, const Box& box) {
    double sum = 0;
    const std::vector<ScaleBoxes> boxes = scaleBoxes(box, shape.coarsest, shape.dimensions == 2);
    const auto block = [&](const VolumeSize& output, double inputs, double outputs) {
        const auto grown = [&](int side, int by) { return static_cast<double>(side + by); };
        const double depth = grown(output.depth, shape.dimensions == 3 ? 2 : 0);
        const double middle = grown(output.width, 2) * grown(output.height, 2) * depth;
        const auto end = static_cast<double>(output.voxels());
        sum += middle * inputs * outputs * shape.taps() + end * outputs * outputs * (shape.taps() + 1);
    };
    for (int k = 0; k <= shape.coarsest; ++k) {
        const ScaleBoxes& own = boxes[at(k)];
        block(k == shape.coarsest ? own.output.size : own.joined.size, shape.noiseChannels, shape.step);
        if (k < shape.coarsest)
            block(own.output.size, shape.joinedChannels(k), shape.joinedChannels(k));
    }
    return sum + static_cast<double>(box.size.voxels()) * shape.joinedChannels(0) * shape.channels;
}

} // namespace texloom
