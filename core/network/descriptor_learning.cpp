#include "core/network/descriptor_learning.h"

#include "core/network/kernels.h"
#include "core/network/padding.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace texloom {

namespace {

constexpr double kRidge = 0.05; ///< of the mean variance, so that noise is not blown up
constexpr double kFiring = 0.3; ///< share of patches on which a unit fires
constexpr float kOffset = 0.5F, kScale = 4;

/// Learns one layer from the feature maps that it will see.
class LayerLearner {
public:
    LayerLearner(std::span<const Tensor> inputs, LearningOptions::Layer layer, const LearningOptions& options,
                 int number, JobContext& context)
        : m_inputs(inputs), m_layer(layer), m_options(options), m_number(number), m_context(context),
          m_length(inputs.front().channels() * layer.side * layer.side) {}

    Filters learn() {
        drawPatches();
        whiten();
        cluster();
        return filters();
    }

private:
    std::uint32_t draw(int kind) const { return static_cast<std::uint32_t>(8 * m_number + kind); }

    /// One patch a column.
    void drawPatches() {
        m_patches.resize(m_length, 1, m_options.patches);
        const int side = m_layer.side, radius = side / 2;
        const Random& random = m_context.random();
        m_context.parallel(0, (m_options.patches + 99) / 100, [&](int hundred) {
            for (int p = hundred * 100; p < std::min(m_options.patches, hundred * 100 + 100); ++p) {
                const Tensor& in =
                    m_inputs[random.below(static_cast<std::uint32_t>(m_inputs.size()), p, 0, draw(0))];
                const int x =
                    static_cast<int>(random.below(static_cast<std::uint32_t>(in.width()), p, 0, draw(1)));
                const int y =
                    static_cast<int>(random.below(static_cast<std::uint32_t>(in.height()), p, 0, draw(2)));
                const auto columns = paddedIndices(in.width(), radius, Padding::Reflect);
                const auto rows = paddedIndices(in.height(), radius, Padding::Reflect);
                int k = 0;
                for (int c = 0; c < in.channels(); ++c)
                    for (int j = 0; j < side; ++j)
                        for (int i = 0; i < side; ++i, ++k)
                            m_patches.channel(k)[p] = in.row(c, rows[at(y + j)])[columns[at(x + i)]];
            }
        });
    }

    /// Of uncorrelated coordinates with variance 1 any will do: directions are told apart by angles alone. So
    /// the inverse of Cholesky's factor stands for the usual symmetric matrix.
    void whiten() {
        m_mean.resize(m_length);
        m_context.parallel(0, m_length, [&](int k) {
            float* const row = m_patches.channel(k);
            double sum = 0;
            for (int p = 0; p < m_options.patches; ++p)
                sum += static_cast<double>(row[p]);
            m_mean[k] = sum / m_options.patches;
            for (int p = 0; p < m_options.patches; ++p)
                row[p] -= static_cast<float>(m_mean[k]);
        });
        const Eigen::MatrixXd covariance = this->covariance();
        const double ridge = std::max(kRidge * covariance.diagonal().mean(), 1e-12);
        const Eigen::LLT<Eigen::MatrixXd> factor(covariance +
                                                 ridge * Eigen::MatrixXd::Identity(m_length, m_length));
        m_context.check();
        m_whitening = factor.matrixL().solve(Eigen::MatrixXd::Identity(m_length, m_length));
        m_context.check();
        const Convolution whitening(mixing(m_whitening));
        whitening.forward(m_patches, Edges{}, false, m_white, m_buffers, m_context);
        normalise();
    }

    Eigen::MatrixXd covariance() {
        constexpr int kRows = 12;
        std::vector<double> sums(at(m_length) * at(m_length), 0.0);
        const auto row = static_cast<std::ptrdiff_t>(m_patches.area());
        m_context.parallel(0, (m_length + kRows - 1) / kRows, [&](int task) {
            const int first = task * kRows;
            addRowProducts({m_patches.channel(first), row, std::min(kRows, m_length - first),
                            m_patches.channel(first), row, m_length - first, m_patches.area(),
                            sums.data() + at(first) * at(m_length) + at(first), m_length});
        });
        Eigen::MatrixXd covariance(m_length, m_length);
        for (int i = 0; i < m_length; ++i)
            for (int j = i; j < m_length; ++j)
                covariance(i, j) = covariance(j, i) = sums[at(i) * at(m_length) + at(j)] / m_options.patches;
        return covariance;
    }

    static Filters mixing(const Eigen::MatrixXd& matrix) {
        Filters filters = Filters::zero(static_cast<int>(matrix.rows()), static_cast<int>(matrix.cols()), 1);
        for (int i = 0; i < filters.outputs; ++i)
            for (int j = 0; j < filters.inputs; ++j)
                filters.at(i, j, 0, 0) = static_cast<float>(matrix(i, j));
        return filters;
    }

    /// Gives every white patch the length 1.
    void normalise() {
        std::vector<double> squares(at(m_options.patches), 0.0);
        for (int k = 0; k < m_length; ++k) {
            const float* const row = m_white.channel(k);
            for (int p = 0; p < m_options.patches; ++p)
                squares[at(p)] += static_cast<double>(row[p]) * static_cast<double>(row[p]);
        }
        m_context.parallel(0, m_length, [&](int k) {
            float* const row = m_white.channel(k);
            for (int p = 0; p < m_options.patches; ++p)
                row[p] = static_cast<float>(static_cast<double>(row[p]) /
                                            std::sqrt(std::max(squares[at(p)], 1e-20)));
        });
    }

    void cluster() {
        m_centres = Eigen::MatrixXd::Zero(m_layer.outputs, m_length);
        for (int k = 0; k < m_layer.outputs; ++k)
            restart(k, 0);
        std::vector<int> nearest(at(m_options.patches));
        Tensor products;
        for (int round = 1; round <= m_options.rounds; ++round) {
            Convolution(mixing(m_centres)).forward(m_white, Edges{}, false, products, m_buffers, m_context);
            for (int p = 0; p < m_options.patches; ++p) {
                int best = 0;
                for (int k = 1; k < m_layer.outputs; ++k)
                    if (products.channel(k)[p] > products.channel(best)[p])
                        best = k;
                nearest[at(p)] = best;
            }
            m_context.check();
            m_centres.setZero();
            m_context.parallel(0, m_length, [&](int d) {
                const float* const row = m_white.channel(d);
                for (int p = 0; p < m_options.patches; ++p)
                    m_centres(nearest[at(p)], d) += static_cast<double>(row[p]);
            });
            for (int k = 0; k < m_layer.outputs; ++k) {
                const double norm = m_centres.row(k).norm();
                if (norm > 1e-9)
                    m_centres.row(k) /= norm;
                else
                    restart(k, round);
            }
        }
    }

    /// A centre begins at a patch.
    void restart(int k, int round) {
        const int p = static_cast<int>(
            m_context.random().below(static_cast<std::uint32_t>(m_options.patches), k, round + 1, draw(3)));
        for (int d = 0; d < m_length; ++d)
            m_centres(k, d) = static_cast<double>(m_white.channel(d)[p]);
    }

    /// The centres as filters of what is not whitened, with their thresholds and scales.
    Filters filters() {
        const Eigen::MatrixXd weights = m_centres * m_whitening;
        Tensor responses;
        Convolution(mixing(weights)).forward(m_patches, Edges{}, false, responses, m_buffers, m_context);
        Filters made = Filters::zero(m_layer.outputs, m_inputs.front().channels(), m_layer.side);
        m_context.parallel(0, m_layer.outputs, [&](int k) {
            std::vector<float> sorted(responses.channel(k), responses.channel(k) + m_options.patches);
            const auto rank = static_cast<std::ptrdiff_t>((1 - kFiring) * m_options.patches);
            std::nth_element(sorted.begin(), sorted.begin() + rank, sorted.end());
            const auto threshold = static_cast<double>(sorted[at(static_cast<int>(rank))]);
            double square = 0;
            for (int p = 0; p < m_options.patches; ++p) {
                const double above = std::max(0.0, static_cast<double>(responses.channel(k)[p]) - threshold);
                square += above * above;
            }
            // Where nothing varies there is nothing to scale.
            const double rms = std::sqrt(square / m_options.patches);
            const double scale = rms > 1e-6 ? 1 / rms : 0;
            for (int d = 0; d < m_length; ++d)
                made.weights[at(k) * at(m_length) + at(d)] = static_cast<float>(scale * weights(k, d));
            made.bias[at(k)] = static_cast<float>(-scale * (threshold + weights.row(k).dot(m_mean)));
        });
        return made;
    }

    std::span<const Tensor> m_inputs;
    LearningOptions::Layer m_layer;
    const LearningOptions& m_options;
    int m_number;
    JobContext& m_context;
    int m_length; ///< of a patch
    Tensor m_patches, m_white;
    Eigen::VectorXd m_mean;
    Eigen::MatrixXd m_whitening, m_centres;
    ConvolutionBuffers m_buffers;
};

} // namespace

LearningOptions quickLearning() {
    return {{{32, 5}, {64, 3}, {96, 3}}, 6000, 6};
}

Descriptor unlearnedDescriptor(const LearningOptions& options, int channels) {
    using Kind = DescriptorLayer::Kind;
    Descriptor descriptor;
    descriptor.channels = channels;
    descriptor.offset = kOffset;
    descriptor.scale = kScale;
    auto& chain = descriptor.chains.emplace_back();
    for (std::size_t l = 0; l < options.layers.size(); ++l) {
        if (l > 0)
            chain.push_back({Kind::Pool, "", {}});
        const std::string name = std::to_string(l + 1);
        const LearningOptions::Layer& layer = options.layers[l];
        chain.push_back(
            {Kind::Convolution, "conv" + name, Filters::zero(layer.outputs, channels, layer.side)});
        chain.push_back({Kind::Rectifier, "", {}});
        chain.push_back({Kind::Tap, "relu" + name, {}});
        channels = layer.outputs;
    }
    return descriptor;
}

Descriptor learnDescriptor(std::span<const Tensor> pictures, const LearningOptions& options,
                           JobContext& context) {
    Descriptor descriptor = unlearnedDescriptor(options, pictures.front().channels());
    std::vector<Tensor> inputs(pictures.begin(), pictures.end());
    for (Tensor& input : inputs)
        for (std::size_t i = 0; i < input.size(); ++i)
            input.data()[i] = (input.data()[i] - kOffset) * kScale;
    ConvolutionBuffers buffers;
    Tensor features;
    int number = 0;
    const int count = static_cast<int>(options.layers.size());
    for (DescriptorLayer& layer : descriptor.chains.front()) {
        if (layer.kind != DescriptorLayer::Kind::Convolution)
            continue;
        layer.filters = LayerLearner(inputs, options.layers[at(number)], options, number, context).learn();
        context.progress((++number) / static_cast<double>(count));
        if (number == count)
            break;
        const Convolution convolution(layer.filters);
        for (Tensor& input : inputs) {
            convolution.forward(input, Edges::all(Padding::Reflect), true, features, buffers, context);
            pool(features, Pooling::Average, input, context);
        }
    }
    return descriptor;
}

double learningSeconds(const LearningOptions& options, int channels) {
    constexpr double kOperationsASecond = 1.2e10;
    double operations = 0;
    for (const LearningOptions::Layer& layer : options.layers) {
        const double length = static_cast<double>(channels) * layer.side * layer.side;
        operations +=
            2.0 * options.patches * length * (1.6 * length + (options.rounds + 2.0) * layer.outputs) +
            4 * length * length * length;
        channels = layer.outputs;
    }
    return operations / kOperationsASecond;
}

std::uint64_t learningBytes(const LearningOptions& options, int channels) {
    std::uint64_t most = 0;
    for (const LearningOptions::Layer& layer : options.layers) {
        const auto length =
            static_cast<std::uint64_t>(channels) * static_cast<std::uint64_t>(layer.side * layer.side);
        const auto patches = static_cast<std::uint64_t>(options.patches);
        most = std::max(most, 4 * patches * (2 * length + 2 * static_cast<std::uint64_t>(layer.outputs) + 4) +
                                  8 * length * length * 6);
        channels = layer.outputs;
    }
    return most;
}

} // namespace texloom
