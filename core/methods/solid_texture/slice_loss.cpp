#include "core/methods/solid_texture/slice_loss.h"

#include "core/base/at.h"
#include "core/network/picture_tensor.h"

#include <algorithm>
#include <cmath>

namespace texloom::solid_texture {

namespace {

constexpr int kPatch = 7, kLevels = 3, kDirections = 16;

/// Adds a derivative as though it had a length of 1: the two losses differ by orders of magnitude, and by as
/// much from the first iterations to the last ones, which Adam would remember (Ulyanov et al. 2016).
void addNormalised(const Image& change, double weight, Image& gradient) {
    double squares = 0;
    for (int c = 0; c < change.channels(); ++c)
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

TextureLossOptions lossOptions() {
    return {};
}

const Descriptor& descriptor() {
    static const Descriptor own = Descriptor::from(ownDescriptor());
    return own;
}

} // namespace

SliceLoss::SliceLoss(const Request& request, const Settings& settings, JobContext& context)
    : m_settings(settings), m_goals(sliceGoals(request, settings, [&context] { context.check(); })),
      m_describes(settings.descriptorWeight > 0 && (request.channels() == 1 || request.channels() == 3)) {
    for (const SliceGoal& goal : m_goals)
        m_whole += goal.weight;
    learnColours();
    if (m_colours->components() == 0)
        return;
    for (const SliceGoal& goal : m_goals) {
        context.check();
        if (m_describes) {
            const Tensor picture = tensorOf(goal.exemplar);
            const LossExemplar exemplar{&picture, 1};
            m_descriptors.push_back(
                std::make_unique<TextureLoss>(descriptor(), lossOptions(), std::span(&exemplar, 1), context));
        }
        Image components(goal.exemplar.size(), m_colours->components());
        m_colours->project(goal.exemplar, m_means, 0, components.height(), components);
        m_patches.emplace_back(components, kPatch, kLevels, kDirections);
    }
}

/// Both maps are linear: they are read off unit vectors.
void SliceLoss::learnColours() {
    const int channels = m_goals.front().exemplar.channels();
    m_means.assign(at(channels), 0.0);
    Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(channels, channels);
    for (const SliceGoal& goal : m_goals) {
        const std::vector<double> own = channelMeans(goal.exemplar);
        for (std::size_t c = 0; c < own.size(); ++c)
            m_means[c] += own[c] * goal.weight / m_whole;
        covariance += channelCovariance(goal.exemplar) * (goal.weight / m_whole);
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

double SliceLoss::byDescriptor(std::size_t goal, const Image& picture, Image& gradient, JobContext& context) {
    m_picture = tensorOf(picture);
    const double loss =
        m_descriptors[goal]->evaluate(m_picture, Edges::all(Padding::Reflect), &m_gradient, context);
    Image change(picture.size(), picture.channels());
    for (int c = 0; c < change.channels(); ++c)
        for (int y = 0; y < change.height(); ++y)
            std::copy_n(m_gradient.row(c, y), change.width(), change.plane(c).row(y));
    addNormalised(change, m_settings.descriptorWeight, gradient);
    return m_settings.descriptorWeight * loss;
}

double SliceLoss::byPatches(std::size_t goal, const Image& picture, int number, Image& gradient,
                            JobContext& context) {
    const int components = m_colours->components();
    Image split(picture.size(), components), change(picture.size(), components);
    m_colours->project(picture, m_means, 0, picture.height(), split);
    const double weight = m_describes ? m_settings.patchWeight : 1;
    const double loss = m_patches[goal].evaluate(split, number, 1, change, context);
    Image mixed(picture.size(), picture.channels());
    for (int c = 0; c < mixed.channels(); ++c)
        for (int k = 0; k < components; ++k) {
            const auto share = static_cast<float>(m_toComponents(k, c));
            for (int y = 0; y < mixed.height(); ++y)
                for (int x = 0; x < mixed.width(); ++x)
                    mixed(x, y, c) += share * change(x, y, k);
        }
    addNormalised(mixed, weight, gradient);
    return weight * loss;
}

double SliceLoss::evaluate(std::size_t goal, const Volume& slice, int number, Volume& gradient,
                           JobContext& context) {
    const Axis axis = m_goals[goal].axis;
    const int side = m_settings.trainSide;
    Image picture({side, side}, slice.channels()), change({side, side}, slice.channels());
    for (int c = 0; c < slice.channels(); ++c)
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const SliceVoxel v = sliceVoxel(axis, x, y, 0);
                picture(x, y, c) = slice(v.x, v.y, v.z, c);
            }
    double loss = 0;
    if (m_describes)
        loss += byDescriptor(goal, picture, change, context);
    if (m_settings.patchWeight > 0 || !m_describes)
        loss += byPatches(goal, picture, number, change, context);
    const auto weight = static_cast<float>(m_goals[goal].weight / m_whole);
    gradient = Volume(slice.size(), slice.channels());
    for (int c = 0; c < slice.channels(); ++c)
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const SliceVoxel v = sliceVoxel(axis, x, y, 0);
                gradient(v.x, v.y, v.z, c) = weight * change(x, y, c);
            }
    return loss * static_cast<double>(weight);
}

std::uint64_t SliceLoss::bytesFor(const Request& request, const Settings& settings, int threads) {
    const Size side{settings.trainSide, settings.trainSide};
    std::uint64_t bytes = Image::bytesFor(side, kDirections + 8 * request.channels());
    for (const Size& size : sliceGoalSizes(request, settings)) {
        const auto pixels = static_cast<std::uint64_t>(std::max(size.area(), side.area()));
        bytes +=
            4 * Image::bytesFor(size, request.channels()) + static_cast<std::uint64_t>(threads) * 64 * pixels;
        if (request.channels() == 1 || request.channels() == 3)
            bytes += TextureLoss::bytesFor(descriptor(), lossOptions(), pixels, threads);
    }
    return bytes;
}

double SliceLoss::secondsFor(const Request& request, const Settings& settings) {
    const double pixels = static_cast<double>(settings.trainSide) * settings.trainSide;
    double seconds = 0;
    for (const Size& size : sliceGoalSizes(request, settings))
        seconds += kDirections * 2e-7 * (pixels + static_cast<double>(size.area())) +
                   TextureLoss::secondsFor(descriptor(), lossOptions(), pixels);
    return seconds;
}

} // namespace texloom::solid_texture
