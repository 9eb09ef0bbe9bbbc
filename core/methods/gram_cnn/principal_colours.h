#pragma once

#include "core/image/image.h"
#include "core/methods/synthesis.h"
#include "core/network/convolution.h"

#include <optional>
#include <vector>

namespace texloom::gram_cnn {

/// The exemplars' colours as uncorrelated components of variance 1, without those that hardly vary: what is
/// optimised has no others, so that a grey exemplar gives a grey image.
class PrincipalColours {
public:
    PrincipalColours(const Request& request, JobContext& context);

    /// 0 for exemplars of one colour.
    int components() const { return m_components; }
    const std::vector<double>& means() const { return m_means; }

    /// Values from components.
    void toValues(const Tensor& components, Tensor& values, JobContext& context);
    /// The derivative by components from that by values.
    void toComponents(const Tensor& valueGradient, Tensor& componentGradient, JobContext& context);
    /// Components of values.
    Tensor componentsOf(const Tensor& values, JobContext& context);

private:
    int m_components = 0;
    std::vector<double> m_means;
    std::optional<Convolution> m_mix, m_split;
    ConvolutionBuffers m_buffers;
};

} // namespace texloom::gram_cnn
