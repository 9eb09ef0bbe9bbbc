#include "core/generator/trainer.h"

#include "core/base/error.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

namespace texloom {

namespace {

constexpr double kFirstMoment = 0.9, kSecondMoment = 0.999, kSmallest = 1e-8; ///< of Adam

void clear(GeneratorWeights& weights) {
    weights.everyLearned([](const std::string&, std::vector<float>& values) {
        std::fill(values.begin(), values.end(), 0.0F);
    });
}

} // namespace

GeneratorTrainer::GeneratorTrainer(GeneratorWeights weights)
    : m_weights(std::move(weights)), m_gradients(m_weights), m_tapes(m_weights.scales.size()) {
    clear(m_gradients);
    m_weights.everyLearned([&](const std::string&, const std::vector<float>& values) {
        m_first.emplace_back(values.size(), 0.0F);
        m_second.emplace_back(values.size(), 0.0F);
    });
}

const Field& GeneratorTrainer::runBlock(GeneratorBlock& block, BlockTape& tape, const Field& in,
                                        JobContext& context) {
    const Field* last = &in;
    for (std::size_t i = 0; i < block.size(); ++i)
        last = &tape[i].forward(*last, block[i], m_weights.shape.slope(), context);
    return *last;
}

void GeneratorTrainer::blockBackward(const GeneratorBlock& block, BlockTape& tape, const Field& gradient,
                                     GeneratorBlock& sums, Field* inGradient, JobContext& context) {
    tape[2].backward(block[2], gradient, sums[2], &m_next, context);
    tape[1].backward(block[1], m_next, sums[1], &m_between, context);
    tape[0].backward(block[0], m_between, sums[0], inGradient, context);
}

/// The coarser scale's features at the voxels of the joined box.
void GeneratorTrainer::enlarge(int scale, JobContext& context) {
    const VolumeSize& size = m_boxes[at(scale)].joined.size;
    const CoarserPlaces& places = m_places[at(scale)];
    const Field& from = *m_tapes[at(scale + 1)].output;
    Field& to = m_tapes[at(scale)].enlarged;
    to.resize(from.channels(), size, size.width);
    context.parallel(0, from.channels(), [&](int c) {
        for (int z = 0; z < size.depth; ++z)
            for (int y = 0; y < size.height; ++y) {
                const float* row = from.row(c, places.y[at(y)], places.z[at(z)]);
                for (int x = 0; x < size.width; ++x)
                    to.row(c, y, z)[x] = row[places.x[at(x)]];
            }
    });
}

/// The transpose of enlarge(), of m_change to m_gradient.
void GeneratorTrainer::gather(int scale, JobContext& context) {
    const VolumeSize& size = m_boxes[at(scale)].joined.size;
    const CoarserPlaces& places = m_places[at(scale)];
    const Field& from = *m_tapes[at(scale + 1)].output;
    m_gradient.resize(from.channels(), from.size(), from.rowStride());
    m_gradient.clear();
    context.parallel(0, from.channels(), [&](int c) {
        for (int z = 0; z < size.depth; ++z)
            for (int y = 0; y < size.height; ++y) {
                float* to = m_gradient.row(c, places.y[at(y)], places.z[at(z)]);
                for (int x = 0; x < size.width; ++x)
                    to[places.x[at(x)]] += m_change.row(c, y, z)[x];
            }
    });
}

void GeneratorTrainer::colour(const Box& box, JobContext& context) {
    const Field& features = *m_tapes.front().output;
    const int channels = m_weights.shape.channels;
    const FieldConvolution last(m_weights.last);
    last.prepare(features, m_colours, channels);
    m_made = Volume(box.size, channels);
    context.parallel(0, box.size.depth, [&](int z) {
        last.plane(features, z, kStraight, m_colours);
        for (int c = 0; c < channels; ++c)
            for (int y = 0; y < box.size.height; ++y) {
                float* to = m_made.row(y, z, c);
                std::fill_n(to, box.size.width, m_weights.mean[at(c)]);
                for (int k = 0; k < channels; ++k) {
                    const float share = m_weights.mix[at(c * channels + k)];
                    const float* from = m_colours.row(k, y, z);
                    for (int x = 0; x < box.size.width; ++x)
                        to[x] += share * from[x];
                }
            }
    });
}

const Volume& GeneratorTrainer::forward(const Box& box, const GeneratorNoise& noise, JobContext& context) {
    const GeneratorShape& shape = m_weights.shape;
    const bool flat = shape.dimensions == 2;
    m_boxes = scaleBoxes(box, shape.coarsest, flat, noise.period());
    m_places.clear();
    for (int k = 0; k < shape.coarsest; ++k)
        m_places.emplace_back(m_boxes[at(k)].joined, m_boxes[at(k + 1)].output, flat, noise.period(k));
    for (int k = shape.coarsest; k >= 0; --k) {
        GeneratorWeights::Scale& scale = m_weights.scales[at(k)];
        ScaleTape& tape = m_tapes[at(k)];
        noise.fill(m_boxes[at(k)].noise, k, shape.noiseChannels, tape.noise, context);
        tape.sideField = &runBlock(scale.noise, tape.noiseBlock, tape.noise, context);
        if (k == shape.coarsest) {
            tape.output = tape.sideField;
            continue;
        }
        enlarge(k, context);
        const int ups = tape.enlarged.channels();
        tape.joined.resize(ups + shape.step, tape.enlarged.size(), tape.enlarged.rowStride());
        tape.up = normalise(tape.enlarged, kStraight, scale.up, 0, tape.joined, context);
        tape.side = normalise(*tape.sideField, kStraight, scale.side, ups, tape.joined, context);
        tape.output = &runBlock(scale.joined, tape.joinedBlock, tape.joined, context);
    }
    colour(box, context);
    return m_made;
}

void GeneratorTrainer::backward(const Volume& gradient, JobContext& context) {
    const GeneratorShape& shape = m_weights.shape;
    const Field& features = *m_tapes.front().output;
    m_change.resize(shape.channels, features.size(), features.rowStride());
    m_change.clear();
    for (int k = 0; k < shape.channels; ++k)
        for (int c = 0; c < shape.channels; ++c) {
            const float share = m_weights.mix[at(c * shape.channels + k)];
            for (int z = 0; z < gradient.depth(); ++z)
                for (int y = 0; y < gradient.height(); ++y)
                    for (int x = 0; x < gradient.width(); ++x)
                        m_change.row(k, y, z)[x] += share * gradient(x, y, z, c);
        }
    convolutionGradient(features, m_weights.last, m_change, m_gradients.last, m_surrounded, &m_gradient,
                        context);
    for (int k = 0; k < shape.coarsest; ++k) {
        const GeneratorWeights::Scale& scale = m_weights.scales[at(k)];
        GeneratorWeights::Scale& sums = m_gradients.scales[at(k)];
        ScaleTape& tape = m_tapes[at(k)];
        Field joined;
        blockBackward(scale.joined, tape.joinedBlock, m_gradient, sums.joined, &joined, context);
        const int ups = tape.enlarged.channels();
        normaliseGradient(*tape.sideField, tape.side, kStraight, scale.side, joined, ups, m_change, sums.side,
                          context);
        blockBackward(scale.noise, tape.noiseBlock, m_change, sums.noise, nullptr, context);
        normaliseGradient(tape.enlarged, tape.up, kStraight, scale.up, joined, 0, m_change, sums.up, context);
        gather(k, context);
    }
    const auto last = at(shape.coarsest);
    blockBackward(m_weights.scales[last].noise, m_tapes[last].noiseBlock, m_gradient,
                  m_gradients.scales[last].noise, nullptr, context);
}

bool GeneratorTrainer::finite() {
    bool all = true;
    m_gradients.everyLearned([&](const std::string&, const std::vector<float>& values) {
        all = all &&
              std::all_of(values.begin(), values.end(), [](float value) { return std::isfinite(value); });
    });
    return all;
}

void GeneratorTrainer::step(double rate) {
    ++m_steps;
    const double first = 1 - std::pow(kFirstMoment, static_cast<double>(m_steps));
    const double second = 1 - std::pow(kSecondMoment, static_cast<double>(m_steps));
    std::vector<std::vector<float>*> gradients;
    m_gradients.everyLearned(
        [&](const std::string&, std::vector<float>& values) { gradients.push_back(&values); });
    std::size_t list = 0;
    m_weights.everyLearned([&](const std::string&, std::vector<float>& values) {
        for (std::size_t i = 0; i < values.size(); ++i) {
            const auto gradient = static_cast<double>((*gradients[list])[i]);
            float &m = m_first[list][i], &v = m_second[list][i];
            m = static_cast<float>(kFirstMoment * static_cast<double>(m) + (1 - kFirstMoment) * gradient);
            v = static_cast<float>(kSecondMoment * static_cast<double>(v) +
                                   (1 - kSecondMoment) * gradient * gradient);
            const double way =
                static_cast<double>(m) / first / (std::sqrt(static_cast<double>(v) / second) + kSmallest);
            values[i] = static_cast<float>(static_cast<double>(values[i]) - rate * way);
        }
        ++list;
    });
    clear(m_gradients);
}

std::string GeneratorTrainer::state() const {
    std::string text(reinterpret_cast<const char*>(&m_steps), sizeof m_steps);
    const auto add = [&](const std::vector<float>& values) {
        text.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float));
    };
    GeneratorWeights copy = m_weights;
    copy.everyLearned([&](const std::string&, const std::vector<float>& values) { add(values); });
    copy.everyRunning([&](const std::string&, const std::vector<float>& values) { add(values); });
    for (const auto* moments : {&m_first, &m_second})
        for (const std::vector<float>& values : *moments)
            add(values);
    return text;
}

void GeneratorTrainer::restore(const std::string& text) {
    if (text.size() != state().size())
        fail("The checkpoint is of a generator of another size; start again without it.");
    const char* from = text.data();
    std::memcpy(&m_steps, from, sizeof m_steps);
    from += sizeof m_steps;
    const auto take = [&](std::vector<float>& values) {
        std::memcpy(values.data(), from, values.size() * sizeof(float));
        from += values.size() * sizeof(float);
    };
    m_weights.everyLearned([&](const std::string&, std::vector<float>& values) { take(values); });
    m_weights.everyRunning([&](const std::string&, std::vector<float>& values) { take(values); });
    for (auto* moments : {&m_first, &m_second})
        for (std::vector<float>& values : *moments)
            take(values);
}

std::uint64_t GeneratorTrainer::bytesFor(const GeneratorShape& shape, const VolumeSize& size) {
    const auto grown = [](int side) { return static_cast<std::uint64_t>(side) + 8; };
    const std::uint64_t planes = shape.dimensions == 3 ? grown(size.depth) : 1;
    // Of the finest scale's fields, which are 16 at most, a quarter comes on top for the coarser ones.
    return planes * (grown(size.width) * grown(size.height) + Field::kSlack) * sizeof(float) *
               at(shape.joinedChannels(0)) * 20 +
           (4U << 20U);
}

} // namespace texloom
