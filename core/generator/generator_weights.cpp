#include "core/generator/generator_weights.h"

#include "core/base/at.h"
#include "core/base/error.h"
#include "core/job/random.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace texloom {

namespace {

constexpr int kMostScales = 8, kMostStep = 32, kMostNoise = 16, kMostChannels = 64;
constexpr const char* kShape = "shape";

/// A block that does nothing yet.
GeneratorBlock emptyBlock(int inputs, int outputs, int taps) {
    return {GeneratorLayer{FieldFilters::zero(outputs, inputs, taps), Normalisation::identity(outputs)},
            GeneratorLayer{FieldFilters::zero(outputs, outputs, taps), Normalisation::identity(outputs)},
            GeneratorLayer{FieldFilters::zero(outputs, outputs, 1), Normalisation::identity(outputs)}};
}

GeneratorWeights emptyWeights(const GeneratorShape& shape) {
    GeneratorWeights weights;
    weights.shape = shape;
    for (int k = 0; k <= shape.coarsest; ++k) {
        GeneratorWeights::Scale& scale = weights.scales.emplace_back();
        scale.noise = emptyBlock(shape.noiseChannels, shape.step, shape.taps());
        if (k == shape.coarsest)
            continue;
        scale.up = Normalisation::identity(shape.joinedChannels(k + 1));
        scale.side = Normalisation::identity(shape.step);
        scale.joined = emptyBlock(shape.joinedChannels(k), shape.joinedChannels(k), shape.taps());
    }
    weights.last = FieldFilters::zero(shape.channels, shape.joinedChannels(0), 1);
    weights.mean.assign(at(shape.channels), 0.0F);
    weights.mix.assign(at(shape.channels) * at(shape.channels), 0.0F);
    for (int c = 0; c < shape.channels; ++c)
        weights.mix[at(c) * at(shape.channels + 1)] = 1;
    return weights;
}

using Visit = std::function<void(const std::string&, std::vector<float>&)>;

/// Calls `filters` and `norm` for all that a generator has of either, in a fixed order.
void everyPart(GeneratorWeights& weights,
               const std::function<void(const std::string&, FieldFilters&)>& filters,
               const std::function<void(const std::string&, Normalisation&)>& norm) {
    const auto block = [&](const std::string& name, GeneratorBlock& layers) {
        for (std::size_t i = 0; i < layers.size(); ++i) {
            filters(fmt::format("{}.{}", name, i), layers[i].filters);
            norm(fmt::format("{}.{}.norm", name, i), layers[i].norm);
        }
    };
    for (std::size_t k = 0; k < weights.scales.size(); ++k) {
        GeneratorWeights::Scale& scale = weights.scales[k];
        block(fmt::format("scale{}.noise", k), scale.noise);
        if (k + 1 == weights.scales.size())
            continue;
        norm(fmt::format("scale{}.up", k), scale.up);
        norm(fmt::format("scale{}.side", k), scale.side);
        block(fmt::format("scale{}.joined", k), scale.joined);
    }
    filters("last", weights.last);
}

/// Every list of numbers that the file holds.
void everyList(GeneratorWeights& weights, const Visit& visit) {
    weights.everyLearned(visit);
    weights.everyRunning(visit);
    visit("mean", weights.mean);
    visit("mix", weights.mix);
}

} // namespace

Normalisation Normalisation::identity(int channels) {
    const std::vector<float> ones(at(channels), 1.0F), zeros(at(channels), 0.0F);
    return {ones, zeros, zeros, ones};
}

double Normalisation::factor(std::size_t channel) const {
    return static_cast<double>(scale[channel]) / std::sqrt(static_cast<double>(variance[channel]) + kEpsilon);
}

FieldFilters FieldFilters::zero(int outputs, int inputs, int taps) {
    FieldFilters filters{outputs, inputs, taps, {}, {}};
    filters.weights.assign(at(outputs) * at(inputs) * at(taps), 0.0F);
    filters.bias.assign(at(outputs), 0.0F);
    return filters;
}

GeneratorWeights GeneratorWeights::drawn(const GeneratorShape& shape, std::uint64_t seed) {
    GeneratorWeights weights = emptyWeights(shape);
    const Random random(seed, 0x67656E);
    int list = 0;
    everyPart(
        weights,
        [&](const std::string&, FieldFilters& filters) {
            const double most = 1 / std::sqrt(static_cast<double>(filters.inputs) * filters.taps);
            for (std::size_t i = 0; i < filters.weights.size(); ++i)
                filters.weights[i] =
                    static_cast<float>(most * (2 * random.uniform(static_cast<int>(i), list) - 1));
            ++list;
        },
        [](const std::string&, Normalisation&) {});
    return weights;
}

std::int64_t GeneratorWeights::convolutionNumbers() const {
    std::int64_t sum = 0;
    GeneratorWeights copy = *this;
    everyPart(
        copy,
        [&](const std::string&, FieldFilters& filters) {
            sum += static_cast<std::int64_t>(filters.weights.size() + filters.bias.size());
        },
        [](const std::string&, Normalisation&) {});
    return sum;
}

void GeneratorWeights::everyLearned(const Visit& visit) {
    everyPart(
        *this,
        [&](const std::string& name, FieldFilters& filters) {
            visit(name + ".weights", filters.weights);
            visit(name + ".bias", filters.bias);
        },
        [&](const std::string& name, Normalisation& norm) {
            visit(name + ".scale", norm.scale);
            visit(name + ".shift", norm.shift);
        });
}

void GeneratorWeights::everyRunning(const Visit& visit) {
    everyPart(
        *this, [](const std::string&, FieldFilters&) {},
        [&](const std::string& name, Normalisation& norm) {
            visit(name + ".mean", norm.mean);
            visit(name + ".variance", norm.variance);
        });
}

std::shared_ptr<Model> GeneratorWeights::model() const {
    auto made = std::make_shared<Model>();
    made->kind = shape.dimensions == 3 ? kSolidGenerator : kPictureGenerator;
    made->arrays[kShape] = {{5},
                            std::vector<std::int64_t>{shape.dimensions, shape.coarsest, shape.noiseChannels,
                                                      shape.step, shape.channels}};
    GeneratorWeights copy = *this;
    everyList(copy, [&](const std::string& name, const std::vector<float>& values) {
        made->arrays[name] = {{static_cast<std::int64_t>(values.size())}, values};
    });
    return made;
}

GeneratorWeights GeneratorWeights::from(const Model& model) {
    model.checkKind(model.kind == kPictureGenerator ? kPictureGenerator : kSolidGenerator);
    const std::vector<std::int64_t>& numbers = model.values<std::int64_t>(kShape, {5});
    const bool solid = model.kind == kSolidGenerator;
    const auto within = [&](std::size_t i, std::int64_t least, std::int64_t most) {
        return numbers[i] >= least && numbers[i] <= most;
    };
    if (numbers[0] != (solid ? 3 : 2) || !within(1, 0, kMostScales) || !within(2, 1, kMostNoise) ||
        !within(3, 1, kMostStep) || !within(4, 1, kMostChannels))
        fail("The generator's shape of {} dimensions, coarsest scale {}, {} channels of noise, steps of {} "
             "and "
             "{} channels is none that can be evaluated.",
             numbers[0], numbers[1], numbers[2], numbers[3], numbers[4]);
    const auto number = [&](std::size_t i) { return static_cast<int>(numbers[i]); };
    GeneratorWeights weights = emptyWeights({number(0), number(1), number(2), number(3), number(4)});
    everyList(weights, [&](const std::string& name, std::vector<float>& values) {
        values = model.values<float>(name, {static_cast<std::int64_t>(values.size())});
    });
    weights.everyRunning([&](const std::string& name, const std::vector<float>& values) {
        if (!name.ends_with(".variance"))
            return;
        for (const float value : values)
            if (value < 0)
                fail("The generator's array {} holds {}; variances are not below 0.", name,
                     static_cast<double>(value));
    });
    return weights;
}

} // namespace texloom
