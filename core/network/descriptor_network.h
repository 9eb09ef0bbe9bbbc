#pragma once

#include "core/network/convolution.h"
#include "core/network/descriptor.h"
#include "core/network/pooling.h"

#include <functional>
#include <string>
#include <vector>

namespace texloom {

/// A descriptor ready to be evaluated: its feature maps at some of its taps, and the derivative of what is
/// made of these by the picture.
class DescriptorNetwork {
public:
    struct Tap {
        std::string name;
        int channels = 0;
        int step = 0; ///< whose output it is
    };
    /// What an evaluation leaves and needs; used again it takes no new memory.
    struct Workspace {
        std::vector<Tensor> outputs; ///< of each step
        Tensor gradient, next;
        ConvolutionBuffers buffers;
    };

    /// @param from, to the first and the last tap that count, from 0; layers that none needs are left out.
    DescriptorNetwork(const Descriptor& descriptor, Pooling pooling, int from, int to);

    const std::vector<Tap>& taps() const { return m_taps; }
    int channels() const { return m_channels; }

    /// @param input as the network wants its values.
    void forward(const Tensor& input, Edges edges, Workspace& work, JobContext& context) const;
    const Tensor& features(int tap, const Workspace& work) const {
        return work.outputs[at(m_taps[at(tap)].step)];
    }
    /// Goes backward through what forward() left. @param addTapGradient adds the derivative by the feature
    /// maps of a tap. @param inputGradient of the input's shape, to which that by the input is added.
    void backward(const Tensor& input, Edges edges, Workspace& work,
                  const std::function<void(int tap, Tensor& gradient)>& addTapGradient, Tensor& inputGradient,
                  JobContext& context) const;

    /// Bytes of a workspace for pictures of so many pixels.
    std::uint64_t bytesFor(std::uint64_t pixels, int threads) const;
    /// Products and sums of forward() and backward() for a pixel.
    double operationsPerPixel() const;

private:
    struct Step {
        int convolution = -1; ///< −1: pooling
        bool rectified = false;
        int from = -1; ///< the step that it follows; −1: the picture
        int scale = 0; ///< how often its output was halved
        int channels = 0;
        int tap = -1;
    };

    void append(const std::vector<DescriptorLayer>& chain, int& tapNumber, int from, int to);

    int m_channels;
    Pooling m_pooling;
    std::vector<Convolution> m_convolutions;
    std::vector<Step> m_steps;
    std::vector<Tap> m_taps;
};

} // namespace texloom
