#include "core/network/convolution.h"

#include "core/base/error.h"
#include "core/network/kernels.h"

#include <algorithm>
#include <utility>

namespace texloom {

namespace {

/// Numbers of a channel that are done in one piece of work.
constexpr int kPiece = 2048;

int paddingOf(const Filters& filters, Padding padding) {
    return padding == Padding::None ? 0 : (filters.side - 1) / 2;
}

std::vector<std::ptrdiff_t> offsetsFor(int side, std::ptrdiff_t stride, bool flipped) {
    std::vector<std::ptrdiff_t> offsets;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            offsets.push_back(flipped ? (side - 1 - y) * stride + side - 1 - x : y * stride + x);
    return offsets;
}

int blockFor(int outputs) {
    for (const int block : kConvolutionBlocks)
        if (outputs % block == 0 && (block > 2 || outputs <= 2))
            return block;
    return 4;
}

} // namespace

Filters Filters::zero(int outputs, int inputs, int side) {
    const std::size_t count =
        texloom::at(outputs) * texloom::at(inputs) * texloom::at(side) * texloom::at(side);
    return {outputs, inputs, side, std::vector<float>(count, 0.0F),
            std::vector<float>(texloom::at(outputs), 0.0F)};
}

float& Filters::at(int output, int input, int y, int x) {
    return weights[((texloom::at(output) * texloom::at(inputs) + texloom::at(input)) * texloom::at(side) +
                    texloom::at(y)) *
                       texloom::at(side) +
                   texloom::at(x)];
}

float Filters::at(int output, int input, int y, int x) const {
    return const_cast<Filters*>(this)->at(output, input, y, x);
}

Convolution::Convolution(Filters filters)
    : m_filters(std::move(filters)), m_forward(packed(false)), m_backward(packed(true)) {}

/// The weights in the order in which the kernel reads them. Backward, inputs and outputs change places.
Convolution::Packed Convolution::packed(bool transposed) const {
    const int outputs = transposed ? inputs() : this->outputs();
    const int inputs = transposed ? this->outputs() : this->inputs();
    Packed to;
    to.block = blockFor(outputs);
    const int blocks = (outputs + to.block - 1) / to.block;
    to.bias.assign(at(blocks) * at(to.block), 0.0F);
    if (!transposed)
        std::copy(m_filters.bias.begin(), m_filters.bias.end(), to.bias.begin());
    for (int b = 0; b < blocks; ++b)
        for (int c = 0; c < inputs; ++c)
            for (int y = 0; y < m_filters.side; ++y)
                for (int x = 0; x < m_filters.side; ++x)
                    for (int o = b * to.block; o < (b + 1) * to.block; ++o)
                        to.weights.push_back(o >= outputs ? 0.0F
                                             : transposed ? m_filters.at(c, o, y, x)
                                                          : m_filters.at(o, c, y, x));
    return to;
}

/// One correlation over padded planes that are `stride` numbers wide.
void Convolution::run(const Packed& weights, const Tensor& padded, std::ptrdiff_t stride, int inputs,
                      std::span<const std::ptrdiff_t> offsets, Sink sink, Tensor& out,
                      ConvolutionBuffers& buffers, JobContext& context) const {
    const int blocks = static_cast<int>(weights.bias.size()) / weights.block;
    const int rows = std::max(1, kPiece / static_cast<int>(stride));
    const int pieces = (out.height() + rows - 1) / rows;
    const std::size_t perBlock = at(inputs) * offsets.size() * at(weights.block);
    context.parallel(0, blocks * pieces, [&](int task) {
        const int b = task / pieces, top = task % pieces * rows, bottom = std::min(top + rows, out.height());
        const auto scratch = buffers.scratch.borrow([] { return std::vector<float>(); });
        const std::ptrdiff_t plane = (bottom - top) * stride + kConvolutionSlack;
        if (scratch->size() < at(weights.block) * static_cast<std::size_t>(plane))
            scratch->resize(at(weights.block) * static_cast<std::size_t>(plane));
        convolveFlat({padded.data(), static_cast<std::ptrdiff_t>(padded.area()), inputs, offsets.data(),
                      static_cast<int>(offsets.size()), weights.weights.data() + at(b) * perBlock,
                      weights.bias.data() + at(b) * at(weights.block), scratch->data(), plane, top * stride,
                      (bottom - 1) * stride + out.width(), weights.block});
        for (int o = b * weights.block; o < std::min((b + 1) * weights.block, out.channels()); ++o)
            for (int y = top; y < bottom; ++y) {
                const float* const from =
                    scratch->data() + (o - b * weights.block) * plane + (y - top) * stride;
                float* const to = out.row(o, y);
                if (sink == Sink::Store)
                    std::copy_n(from, out.width(), to);
                else if (sink == Sink::Rectify)
                    for (int x = 0; x < out.width(); ++x)
                        to[x] = from[x] > 0 ? from[x] : 0.0F;
                else
                    for (int x = 0; x < out.width(); ++x)
                        to[x] += from[x];
            }
    });
}

void Convolution::forward(const Tensor& in, Edges edges, bool rectified, Tensor& out,
                          ConvolutionBuffers& buffers, JobContext& context) const {
    const int side = m_filters.side;
    const int px = paddingOf(m_filters, edges.x), py = paddingOf(m_filters, edges.y);
    const int width = in.width() + 2 * px - side + 1, height = in.height() + 2 * py - side + 1;
    if (in.channels() != inputs() || width < 1 || height < 1)
        fail(TR("A layer of the network takes {} channels of at least {}×{} px, and has {} of {}×{} px."),
             inputs(), side, side, in.channels(), in.width(), in.height());
    if (px + py > 0)
        pad(in, paddedIndices(in.width(), px, edges.x), paddedIndices(in.height(), py, edges.y),
            buffers.padded, context);
    const Tensor& from = px + py > 0 ? buffers.padded : in;
    out.resize(outputs(), height, width);
    run(m_forward, from, from.width(), inputs(), offsetsFor(side, from.width(), false),
        rectified ? Sink::Rectify : Sink::Store, out, buffers, context);
}

void Convolution::add(const Tensor& in, Tensor& out, ConvolutionBuffers& buffers, JobContext& context) const {
    run(m_forward, in, in.width(), inputs(), offsetsFor(1, in.width(), false), Sink::Add, out, buffers,
        context);
}

void Convolution::addGradient(const Tensor& outGradient, Edges edges, Tensor& inGradient,
                              ConvolutionBuffers& buffers, JobContext& context) const {
    const int side = m_filters.side;
    const bool same = side == 1 || edges.circular();
    // The derivative of a circular convolution is one, too; else that by the padded input is folded.
    const int around = same ? (side - 1) / 2 : side - 1;
    if (side > 1) {
        const Padding padding = same ? Padding::Circular : Padding::Zero;
        pad(outGradient, paddedIndices(outGradient.width(), around, padding),
            paddedIndices(outGradient.height(), around, padding), buffers.padded, context);
    }
    const Tensor& from = side > 1 ? buffers.padded : outGradient;
    const auto offsets = offsetsFor(side, from.width(), true);
    if (same)
        return run(m_backward, from, from.width(), outputs(), offsets, Sink::Add, inGradient, buffers,
                   context);
    const int px = paddingOf(m_filters, edges.x), py = paddingOf(m_filters, edges.y);
    buffers.unfolded.resize(inputs(), inGradient.height() + 2 * py, inGradient.width() + 2 * px);
    run(m_backward, from, from.width(), outputs(), offsets, Sink::Store, buffers.unfolded, buffers, context);
    addFolded(buffers.unfolded, paddedIndices(inGradient.width(), px, edges.x),
              paddedIndices(inGradient.height(), py, edges.y), inGradient, context);
}

void Convolution::addWeightGradient(const Tensor& in, const Tensor& outGradient, Edges edges,
                                    Filters& gradient, ConvolutionBuffers& buffers,
                                    JobContext& context) const {
    const int side = m_filters.side, taps = side * side;
    const int px = paddingOf(m_filters, edges.x), py = paddingOf(m_filters, edges.y);
    pad(in, paddedIndices(in.width(), px, edges.x), paddedIndices(in.height(), py, edges.y), buffers.padded,
        context);
    const std::ptrdiff_t stride = buffers.padded.width();
    // The gradient in rows as long as those of the padded input, so that both are flat arrays.
    Tensor& spread = buffers.unfolded;
    spread.resize(outputs(), outGradient.height(), static_cast<int>(stride));
    context.parallel(0, outputs(), [&](int o) {
        double sum = 0;
        for (int y = 0; y < outGradient.height(); ++y) {
            const float* const row = outGradient.row(o, y);
            std::copy_n(row, outGradient.width(), spread.row(o, y));
            std::fill(spread.row(o, y) + outGradient.width(), spread.row(o, y) + stride, 0.0F);
            for (int x = 0; x < outGradient.width(); ++x)
                sum += static_cast<double>(row[x]);
        }
        gradient.bias[at(o)] += static_cast<float>(sum);
    });
    const auto offsets = offsetsFor(side, stride, false);
    const std::size_t length =
        at(outGradient.height() - 1) * static_cast<std::size_t>(stride) + at(outGradient.width());
    constexpr int kRows = 16;
    const int parts = (outputs() + kRows - 1) / kRows;
    buffers.products.assign(gradient.weights.size(), 0.0);
    context.parallel(0, taps * parts, [&](int task) {
        const int tap = task / parts, first = task % parts * kRows, rows = std::min(kRows, outputs() - first);
        double* const sums = buffers.products.data() + (at(tap) * at(outputs()) + at(first)) * at(inputs());
        addRowProducts({spread.channel(first), static_cast<std::ptrdiff_t>(spread.area()), rows,
                        buffers.padded.data() + offsets[at(tap)],
                        static_cast<std::ptrdiff_t>(buffers.padded.area()), inputs(), length, sums,
                        inputs()});
        for (int o = 0; o < rows; ++o)
            for (int c = 0; c < inputs(); ++c)
                gradient.at(first + o, c, tap / side, tap % side) +=
                    static_cast<float>(sums[at(o) * at(inputs()) + at(c)]);
    });
}

void gateGradient(const Tensor& output, Tensor& gradient, JobContext& context) {
    context.parallel(0, output.channels(), [&](int c) {
        const float* const value = output.channel(c);
        float* const to = gradient.channel(c);
        for (std::size_t i = 0; i < output.area(); ++i)
            to[i] = value[i] > 0 ? to[i] : 0.0F;
    });
}

} // namespace texloom
