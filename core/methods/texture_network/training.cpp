#include "core/methods/texture_network/training.h"

#include "core/base/text.h"
#include "core/generator/generator.h"
#include "core/image/resample.h"
#include "core/job/voxel_random.h"
#include "core/network/descriptor_learning.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace texloom::texture_network {

namespace {

constexpr int kFarthest = 1 << 20;      ///< samples for training lie no further from 0
constexpr std::uint32_t kStream = 0x54; ///< of the numbers that samples are drawn with

GeneratorShape shapeOf(const Request& request, const Settings& settings) {
    if (const auto model = request.inputs.first<Model>(kPictureGenerator))
        return GeneratorWeights::from(*model).shape;
    return {2, settings.coarsest, settings.noiseChannels, settings.step, request.channels()};
}

Image volumePicture(const Volume& volume) {
    return Image(volume.slice(0));
}

Volume pictureVolume(const Image& image, float factor) {
    Volume volume({image.width(), image.height(), 1}, image.channels());
    for (int c = 0; c < image.channels(); ++c)
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                volume(x, y, 0, c) = factor * image(x, y, c);
    return volume;
}

} // namespace

GeneratorLossOptions Settings::lossOptions(const Descriptor* used) const {
    GeneratorLossOptions options;
    options.texture.statistic = statistic;
    options.texture.levels = levels > 0 || !used ? std::max(1, levels) : used->levels;
    options.texture.pooling = poolingOf(pooling);
    options.texture.colours = colours;
    options.texture.evenGradients = evenGradients;
    options.descriptorWeight = describes() ? 1 : 0;
    options.patchWeight = loss == LossChoice::Gram ? 0 : 1;
    options.unitLengths = loss == LossChoice::Both;
    return options;
}

Size trainedSize(const Request& request, const Settings& settings) {
    return sizeWithin(request.exemplarSizes().front(), settings.exemplarSide);
}

Training::Training(const Request& request, const Settings& settings, JobContext& context)
    : m_request(request), m_settings(settings), m_context(context), m_descriptor(descriptorFor()),
      m_loss(lossFor()), m_training(startingWeights(), settings.iterations, context) {}

std::optional<Descriptor> Training::descriptorFor() const {
    if (!m_settings.describes())
        return std::nullopt;
    return chosenDescriptor(m_request, m_settings.descriptor, m_context);
}

GeneratorLoss Training::lossFor() const {
    const Image& exemplar = *m_request.exemplars.front().image;
    const Size size = trainedSize(m_request, m_settings);
    const GeneratorGoal goal{
        size == exemplar.size() ? exemplar : resized(exemplar, size, [this] { m_context.check(); }), 1};
    const Descriptor* const used = m_descriptor ? &*m_descriptor : nullptr;
    return {std::span(&goal, 1), used, m_settings.lossOptions(used), m_context};
}

GeneratorWeights Training::startingWeights() const {
    if (const auto model = m_request.inputs.first<Model>(kPictureGenerator))
        return GeneratorWeights::from(*model);
    GeneratorWeights weights = GeneratorWeights::drawn(shapeOf(m_request, m_settings), m_request.seed);
    weights.mean = m_loss.mean();
    weights.mix = m_loss.mix();
    return weights;
}

void Training::run() {
    if (m_loss.constant())
        return;
    m_training.run([this](int number) { return iteration(number); },
                   [this](int number) {
                       const int tenth = std::max(1, m_settings.iterations / 10);
                       const int times = number / (m_settings.decayEvery > 0 ? m_settings.decayEvery : tenth);
                       return m_settings.rate * std::pow(m_settings.decay, times);
                   });
}

/// A batch of samples, one after another, each with noise of its own. Those that are cut out of an endless
/// texture lie anywhere, so that all of the 2^K kinds of places are met.
double Training::iteration(int number) {
    const bool circular = m_settings.padding == PaddingChoice::Circular;
    const int side = m_settings.trainSize, batch = m_settings.batch;
    const VoxelRandom random(m_request.seed, kStream);
    const VolumeSize period = circular ? VolumeSize{side, side, 0} : VolumeSize{};
    double sum = 0;
    for (int n = 0; n < batch; ++n) {
        const Voxel draw{number, n, 0};
        const auto place = [&](std::uint32_t axis) {
            return circular ? 0 : static_cast<std::int64_t>(random.below(kFarthest, draw, axis));
        };
        const Box box{place(0), place(1), 0, {side, side, 1}};
        Image sample = volumePicture(
            m_training.trainer().forward(box, GeneratorNoise(random.bits(draw, 2), period), m_context));
        m_training.show(m_request.size, [&] { return sample; });
        Image change(sample.size(), sample.channels());
        sum += m_loss.evaluate(0, sample, Edges::all(circular ? Padding::Circular : Padding::Reflect),
                               number * batch + n, change, m_context);
        m_training.trainer().backward(pictureVolume(change, 1 / static_cast<float>(batch)), m_context);
    }
    return sum / batch;
}

std::vector<Message> Training::notes() const {
    if (m_loss.constant())
        return {};
    std::vector<Message> all = m_training.notes();
    if (m_descriptor)
        all.push_back(descriptorNote(*m_descriptor));
    return all;
}

std::shared_ptr<Model> Training::model() const {
    std::shared_ptr<Model> made = m_training.weights().model();
    const Size size = trainedSize(m_request, m_settings);
    made->notes["exemplar"] = m_request.exemplars.front().name;
    made->notes["exemplar-size"] = fmt::format("{}x{}", size.width, size.height);
    made->notes["iterations"] = std::to_string(m_training.iterationsDone());
    made->notes["padding"] = m_settings.padding == PaddingChoice::Circular ? "circular" : "none";
    if (m_descriptor) {
        made->notes["descriptor"] = m_descriptor->name;
        made->notes["descriptor-sha1"] = m_descriptor->model().hash();
    }
    return made;
}

namespace {

/// What training will compare, before there is anything to learn from.
struct Planned {
    Planned(const Request& request, const Settings& settings)
        : exemplar{trainedSize(request, settings)}, sample{settings.trainSize, settings.trainSize},
          box{0, 0, 0, {sample.width, sample.height, 1}} {
        if (settings.describes())
            descriptor = plannedDescriptor(request, settings.descriptor);
        learns = descriptor && learnsDescriptor(request, settings.descriptor);
        options = settings.lossOptions(used());
    }
    const Descriptor* used() const { return descriptor ? &*descriptor : nullptr; }

    std::array<Size, 1> exemplar;
    Size sample;
    Box box;
    std::optional<Descriptor> descriptor;
    bool learns = false;
    GeneratorLossOptions options;
};

} // namespace

std::uint64_t Training::bytesFor(const Request& request, const Settings& settings, int threads) {
    const Planned plan(request, settings);
    return GeneratorTrainer::bytesFor(shapeOf(request, settings), plan.box.size) +
           GeneratorLoss::bytesFor(plan.exemplar, plan.sample, request.channels(), plan.used(), plan.options,
                                   threads) +
           (plan.learns ? learningBytes(quickLearning(), request.channels()) : 0);
}

double Training::secondsFor(const Request& request, const Settings& settings) {
    const Planned plan(request, settings);
    const double each = 3e-10 * Generator::productsFor(shapeOf(request, settings), plan.box) +
                        GeneratorLoss::secondsFor(plan.exemplar, plan.sample, plan.used(), plan.options);
    return settings.iterations * settings.batch * each +
           (plan.learns ? learningSeconds(quickLearning(), request.channels()) : 0);
}

} // namespace texloom::texture_network
