#include "core/generator/field_convolution.h"

#include "core/base/wide_vectors.h"
#include "core/network/kernels.h"

#include <algorithm>

namespace texloom {

namespace {

/// Numbers that the inner loop does at once, at least for the widest vectors.
constexpr int kStep = 16;

int blockFor(int outputs) {
    return *std::find_if(std::begin(kConvolutionBlocks), std::end(kConvolutionBlocks),
                         [&](int block) { return outputs % block == 0; });
}

int sideOf(int taps) {
    return taps == 1 ? 1 : 3;
}

} // namespace

TEXLOOM_WIDE_VECTORS
void rectify(float* values, std::ptrdiff_t count, float slope) {
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        const float leaked = slope * values[i];
        values[i] = values[i] > leaked ? values[i] : leaked;
    }
}

std::vector<std::ptrdiff_t> tapOffsets(int taps, std::ptrdiff_t row, std::ptrdiff_t plane) {
    std::vector<std::ptrdiff_t> offsets;
    const int side = sideOf(taps), depth = taps == 27 ? 3 : 1;
    for (int z = 0; z < depth; ++z)
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x)
                offsets.push_back(z * plane + y * row + x);
    return offsets;
}

FieldConvolution::FieldConvolution(const FieldFilters& filters)
    : m_outputs(filters.outputs), m_inputs(filters.inputs), m_taps(filters.taps),
      m_block(blockFor(filters.outputs)), m_bias(filters.bias) {
    for (int first = 0; first < m_outputs; first += m_block)
        for (int c = 0; c < m_inputs; ++c)
            for (int t = 0; t < m_taps; ++t)
                for (int o = 0; o < m_block; ++o)
                    m_weights.push_back(filters.filter(first + o, c)[t]);
}

FieldConvolution FieldConvolution::transposed(const FieldFilters& filters) {
    FieldFilters turned = FieldFilters::zero(filters.inputs, filters.outputs, filters.taps);
    for (int o = 0; o < filters.outputs; ++o)
        for (int c = 0; c < filters.inputs; ++c)
            std::reverse_copy(filters.filter(o, c), filters.filter(o, c) + filters.taps, turned.filter(c, o));
    return FieldConvolution(turned);
}

VolumeSize FieldConvolution::outputSize(const VolumeSize& input) const {
    const int lost = sideOf(m_taps) - 1;
    return {input.width - lost, input.height - lost, input.depth - (m_taps == 27 ? lost : 0)};
}

void FieldConvolution::prepare(const Field& in, Field& out, int channels) const {
    out.resize(channels, outputSize(in.size()), in.rowStride());
}

/// Output channels from `first` on, as many as are done at once.
void FieldConvolution::block(const Field& in, int z, int first, float slope, Field& out) const {
    const std::vector<std::ptrdiff_t> taps = tapOffsets(m_taps, in.rowStride(), in.planeStride());
    const VolumeSize& size = out.size();
    FlatConvolution what;
    what.inPlane = in.channelStride();
    what.inputs = m_inputs;
    what.offsets = taps.data();
    what.taps = m_taps;
    what.weights = m_weights.data() + static_cast<std::ptrdiff_t>(first) * m_inputs * m_taps;
    what.bias = m_bias.data() + first;
    what.outPlane = out.channelStride();
    what.block = m_block;
    const std::ptrdiff_t whole = static_cast<std::ptrdiff_t>(size.height - 1) * out.rowStride() + size.width;
    // Row by row where that leaves out more between the rows than it adds to their ends.
    const bool inRows = (size.width + kStep - 1) / kStep * kStep * size.height < whole;
    for (int y = 0; y < (inRows ? size.height : 1); ++y) {
        what.in = in.row(0, y, z);
        what.out = out.row(first, y, z);
        what.last = inRows ? size.width : whole;
        convolveFlat(what);
    }
    for (int o = 0; slope != kStraight && o < m_block; ++o)
        rectify(out.row(first + o, 0, z), whole, slope);
}

void FieldConvolution::plane(const Field& in, int z, float slope, Field& out) const {
    for (int first = 0; first < m_outputs; first += m_block)
        block(in, z, first, slope, out);
}

void FieldConvolution::all(const Field& in, float slope, Field& out, JobContext& context) const {
    const int blocks = m_outputs / m_block;
    context.parallel(0, out.size().depth * blocks, [&](int task) {
        context.check();
        block(in, task / blocks, task % blocks * m_block, slope, out);
    });
}

void addFilterGradient(const Field& in, const Field& gradient, int taps, int input,
                       std::vector<double>& sums) {
    const std::vector<std::ptrdiff_t> offsets = tapOffsets(taps, in.rowStride(), in.planeStride());
    const VolumeSize& size = gradient.size();
    const int outputs = gradient.channels();
    RowProducts what;
    what.aRow = gradient.channelStride();
    what.rows = outputs;
    what.bRow = 1; // taps beside each other
    what.columns = taps == 1 ? 1 : 3;
    what.length = static_cast<std::size_t>(size.height - 1) * at(gradient.rowStride()) +
                  static_cast<std::size_t>(size.width);
    what.sumsRow = static_cast<std::ptrdiff_t>(in.channels()) * taps;
    for (int z = 0; z < size.depth; ++z)
        for (int t = 0; t < taps; t += what.columns) {
            what.a = gradient.row(0, 0, z);
            what.b = in.row(input, 0, z) + offsets[at(t)];
            what.sums = sums.data() + static_cast<std::ptrdiff_t>(input) * taps + t;
            addRowProducts(what);
        }
    for (int o = 0; input == 0 && o < outputs; ++o) {
        double& bias = sums[at(outputs) * at(in.channels()) * at(taps) + at(o)];
        for (int z = 0; z < size.depth; ++z)
            for (int y = 0; y < size.height; ++y) {
                const float* row = gradient.row(o, y, z);
                for (int x = 0; x < size.width; ++x)
                    bias += static_cast<double>(row[x]);
            }
    }
}

} // namespace texloom
