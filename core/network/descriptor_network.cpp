#include "core/network/descriptor_network.h"

#include <algorithm>
#include <utility>

namespace texloom {

DescriptorNetwork::DescriptorNetwork(const Descriptor& descriptor, Pooling pooling, int from, int to)
    : m_channels(descriptor.channels), m_pooling(pooling) {
    int tapNumber = 0;
    for (const auto& chain : descriptor.chains)
        append(chain, tapNumber, from, to);
}

/// Adds the steps of a chain up to its last tap that counts.
void DescriptorNetwork::append(const std::vector<DescriptorLayer>& chain, int& tapNumber, int from, int to) {
    using Kind = DescriptorLayer::Kind;
    const auto counts = [&](int number) { return number >= from && number <= to; };
    int number = tapNumber;
    std::size_t length = 0;
    for (std::size_t i = 0; i < chain.size(); ++i)
        if (chain[i].kind == Kind::Tap && counts(number++))
            length = i + 1;
    int step = -1, channels = m_channels, scale = 0;
    for (std::size_t i = 0; i < length; ++i) {
        const DescriptorLayer& layer = chain[i];
        if (layer.kind == Kind::Tap) {
            if (counts(tapNumber + static_cast<int>(std::count_if(
                                       chain.begin(), chain.begin() + static_cast<std::ptrdiff_t>(i),
                                       [](const DescriptorLayer& one) { return one.kind == Kind::Tap; })))) {
                m_steps[at(step)].tap = static_cast<int>(m_taps.size());
                m_taps.push_back({layer.name, channels, step});
            }
            continue;
        }
        if (layer.kind == Kind::Rectifier) {
            // What a tap before it shows is not rectified: then it is a step of its own.
            if (step >= 0 && m_steps[at(step)].tap < 0 && m_steps[at(step)].convolution >= 0) {
                m_steps[at(step)].rectified = true;
                continue;
            }
            Filters same = Filters::zero(channels, channels, 1);
            for (int c = 0; c < channels; ++c)
                same.at(c, c, 0, 0) = 1;
            m_convolutions.emplace_back(std::move(same));
            m_steps.push_back({static_cast<int>(m_convolutions.size()) - 1, true, step, scale, channels, -1});
        } else if (layer.kind == Kind::Pool) {
            m_steps.push_back({-1, false, step, ++scale, channels, -1});
        } else {
            channels = layer.filters.outputs;
            m_convolutions.emplace_back(layer.filters);
            m_steps.push_back(
                {static_cast<int>(m_convolutions.size()) - 1, false, step, scale, channels, -1});
        }
        step = static_cast<int>(m_steps.size()) - 1;
    }
    tapNumber = number;
}

void DescriptorNetwork::forward(const Tensor& input, Edges edges, Workspace& work,
                                JobContext& context) const {
    work.outputs.resize(m_steps.size());
    for (std::size_t i = 0; i < m_steps.size(); ++i) {
        context.check();
        const Step& step = m_steps[i];
        const Tensor& in = step.from < 0 ? input : work.outputs[at(step.from)];
        if (step.convolution < 0)
            pool(in, m_pooling, work.outputs[i], context);
        else
            m_convolutions[at(step.convolution)].forward(in, edges, step.rectified, work.outputs[i],
                                                         work.buffers, context);
    }
}

void DescriptorNetwork::backward(const Tensor& input, Edges edges, Workspace& work,
                                 const std::function<void(int tap, Tensor& gradient)>& addTapGradient,
                                 Tensor& inputGradient, JobContext& context) const {
    for (std::size_t i = m_steps.size(); i-- > 0;) {
        context.check();
        const Step& step = m_steps[i];
        const Tensor& out = work.outputs[i];
        // The last of a chain has no gradient from what follows.
        if (i + 1 == m_steps.size() || m_steps[i + 1].from != static_cast<int>(i)) {
            work.gradient.resize(out.channels(), out.height(), out.width());
            work.gradient.clear();
        }
        if (step.tap >= 0)
            addTapGradient(step.tap, work.gradient);
        if (step.rectified)
            gateGradient(out, work.gradient, context);
        const Tensor& in = step.from < 0 ? input : work.outputs[at(step.from)];
        if (step.from >= 0) {
            work.next.resize(in.channels(), in.height(), in.width());
            work.next.clear();
        }
        Tensor& to = step.from < 0 ? inputGradient : work.next;
        if (step.convolution < 0)
            addPoolGradient(in, m_pooling, work.gradient, to, context);
        else
            m_convolutions[at(step.convolution)].addGradient(work.gradient, edges, to, work.buffers, context);
        std::swap(work.gradient, work.next);
    }
}

std::uint64_t DescriptorNetwork::bytesFor(std::uint64_t pixels, int threads) const {
    double kept = 0, largest = 0;
    for (const Step& step : m_steps) {
        const double share =
            step.channels / static_cast<double>(1ULL << (2U * static_cast<unsigned>(step.scale)));
        kept += share;
        largest = std::max(largest, share);
    }
    // Outputs, two gradients, and two padded.
    const double numbers = (kept + 4.6 * std::max<double>(largest, m_channels)) * static_cast<double>(pixels);
    return static_cast<std::uint64_t>(4 * numbers) + (static_cast<std::uint64_t>(threads) << 18U);
}

double DescriptorNetwork::operationsPerPixel() const {
    double sum = 0;
    for (const Step& step : m_steps) {
        if (step.convolution < 0)
            continue;
        const double area = 1 / static_cast<double>(1ULL << (2U * static_cast<unsigned>(step.scale)));
        sum += 2 * area * static_cast<double>(m_convolutions[at(step.convolution)].filters().weights.size());
        if (step.tap >= 0)
            sum += 2 * area * step.channels * step.channels;
    }
    return sum;
}

} // namespace texloom
