#include "core/methods/generator_loss.h"

#include "core/base/at.h"
#include "core/network/picture_tensor.h"

#include <algorithm>
#include <cmath>

namespace texloom {

namespace {

constexpr int kPatch = 7, kLevels = 3, kDirections = 16;

} // namespace

GeneratorLoss::GeneratorLoss(std::span<const GeneratorGoal> goals, const Descriptor* descriptor,
                             const GeneratorLossOptions& options, JobContext& context)
    : m_options(options), m_describes(descriptor != nullptr && options.descriptorWeight > 0) {
    learnColours(goals);
    if (constant())
        return;
    for (const GeneratorGoal& goal : goals) {
        context.check();
        if (m_describes && descriptor != nullptr) {
            const Tensor picture = tensorOf(goal.exemplar);
            const LossExemplar exemplar{&picture, 1};
            m_descriptors.push_back(std::make_unique<TextureLoss>(*descriptor, options.texture,
                                                                  std::span(&exemplar, 1), context));
        }
        Image components(goal.exemplar.size(), m_colours->components());
        m_colours->project(goal.exemplar, m_means, 0, components.height(), components);
        m_patches.emplace_back(components, kPatch, kLevels, kDirections);
    }
}

/// Both maps are linear: they are read off unit vectors.
void GeneratorLoss::learnColours(std::span<const GeneratorGoal> goals) {
    const int channels = goals.front().exemplar.channels();
    double whole = 0;
    for (const GeneratorGoal& goal : goals)
        whole += goal.weight;
    m_means.assign(at(channels), 0.0);
    Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(channels, channels);
    for (const GeneratorGoal& goal : goals) {
        const std::vector<double> own = channelMeans(goal.exemplar);
        for (std::size_t c = 0; c < own.size(); ++c)
            m_means[c] += own[c] * goal.weight / whole;
        covariance += channelCovariance(goal.exemplar) * (goal.weight / whole);
    }
    m_colours = std::make_unique<ChannelPca>(covariance);
    const int components = m_colours->components();
    m_mean.assign(m_means.begin(), m_means.end());
    m_mix.assign(at(channels) * at(channels), 0.0F);
    const std::vector<double> none(at(channels), 0.0);
    for (int k = 0; k < components; ++k) {
        Image unit({1, 1}, components), mixed({1, 1}, channels);
        unit(0, 0, k) = 1;
        m_colours->unproject(unit, none, 0, 1, mixed);
        for (int c = 0; c < channels; ++c)
            m_mix[at(c) * at(channels) + at(k)] = mixed(0, 0, c);
    }
    m_toComponents = Eigen::MatrixXd::Zero(components, channels);
    for (int c = 0; c < channels && components > 0; ++c) {
        Image unit({1, 1}, channels), split({1, 1}, components);
        unit(0, 0, c) = 1;
        m_colours->project(unit, none, 0, 1, split);
        for (int k = 0; k < components; ++k)
            m_toComponents(k, c) = static_cast<double>(split(0, 0, k));
    }
}

/// Adds a derivative, of length 1 if that is wanted, times its weight.
void GeneratorLoss::add(const Image& change, double weight, Image& gradient) const {
    double squares = m_options.unitLengths ? 0 : 1;
    for (int c = 0; m_options.unitLengths && c < change.channels(); ++c)
        for (int y = 0; y < change.height(); ++y)
            for (int x = 0; x < change.width(); ++x)
                squares += static_cast<double>(change(x, y, c)) * static_cast<double>(change(x, y, c));
    if (squares <= 0)
        return;
    const auto factor = static_cast<float>(weight / std::sqrt(squares));
    for (int c = 0; c < change.channels(); ++c)
        for (int y = 0; y < change.height(); ++y)
            for (int x = 0; x < change.width(); ++x)
                gradient(x, y, c) += factor * change(x, y, c);
}

double GeneratorLoss::byDescriptor(std::size_t goal, const Image& picture, Edges edges, Image& gradient,
                                   JobContext& context) {
    const double loss = m_descriptors[goal]->evaluate(tensorOf(picture), edges, &m_gradient, context);
    add(imageOf(m_gradient), m_options.descriptorWeight, gradient);
    return m_options.descriptorWeight * loss;
}

double GeneratorLoss::byPatches(std::size_t goal, const Image& picture, int number, Image& gradient,
                                JobContext& context) {
    const int components = m_colours->components();
    Image split(picture.size(), components), change(picture.size(), components);
    m_colours->project(picture, m_means, 0, picture.height(), split);
    const double weight = m_describes ? m_options.patchWeight : 1;
    const double loss = m_patches[goal].evaluate(split, number, 1, change, context);
    Image mixed(picture.size(), picture.channels());
    for (int c = 0; c < mixed.channels(); ++c)
        for (int k = 0; k < components; ++k) {
            const auto share = static_cast<float>(m_toComponents(k, c));
            for (int y = 0; y < mixed.height(); ++y)
                for (int x = 0; x < mixed.width(); ++x)
                    mixed(x, y, c) += share * change(x, y, k);
        }
    add(mixed, weight, gradient);
    return weight * loss;
}

double GeneratorLoss::evaluate(std::size_t goal, const Image& picture, Edges edges, int number,
                               Image& gradient, JobContext& context) {
    double loss = 0;
    if (m_describes)
        loss += byDescriptor(goal, picture, edges, gradient, context);
    if (comparesPatches())
        loss += byPatches(goal, picture, number, gradient, context);
    return loss;
}

std::uint64_t GeneratorLoss::bytesFor(std::span<const Size> exemplars, Size side, int channels,
                                      const Descriptor* descriptor, const GeneratorLossOptions& options,
                                      int threads) {
    std::uint64_t bytes = Image::bytesFor(side, kDirections + 8 * channels);
    for (const Size& size : exemplars) {
        const auto pixels = static_cast<std::uint64_t>(std::max(size.area(), side.area()));
        bytes += 4 * Image::bytesFor(size, channels) + static_cast<std::uint64_t>(threads) * 64 * pixels;
        if (descriptor != nullptr)
            bytes += TextureLoss::bytesFor(*descriptor, options.texture, pixels, threads);
    }
    return bytes;
}

double GeneratorLoss::secondsFor(std::span<const Size> exemplars, Size side, const Descriptor* descriptor,
                                 const GeneratorLossOptions& options) {
    const auto pixels = static_cast<double>(side.area());
    double seconds = 0;
    for (const Size& size : exemplars) {
        if (descriptor == nullptr || options.patchWeight > 0)
            seconds += kDirections * 2e-7 * (pixels + static_cast<double>(size.area()));
        if (descriptor != nullptr)
            seconds += TextureLoss::secondsFor(*descriptor, options.texture, pixels);
    }
    return seconds;
}

} // namespace texloom
