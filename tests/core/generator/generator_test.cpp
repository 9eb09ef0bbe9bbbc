// Generators: what a box depends on, that boxes fit together bit for bit, and derivatives.

#include "core/base/error.h"
#include "core/generator/generator_source.h"
#include "core/generator/trainer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace texloom::test {
namespace {

/// A job to compute in.
struct Work {
    explicit Work(int threads = 2)
        : context(
              {1, threads, false}, [] { return false; }, monitor) {}
    JobMonitor monitor;
    JobContext context;
};

/// Weights whose normalisations do something, too.
GeneratorWeights stirred(const GeneratorShape& shape) {
    GeneratorWeights weights = GeneratorWeights::drawn(shape, 7);
    const Random random(11);
    int list = 0;
    const auto stir = [&](const std::string& name, std::vector<float>& values) {
        const bool about1 = name.ends_with("scale") || name.ends_with("variance");
        for (std::size_t i = 0; i < values.size(); ++i)
            if (!name.ends_with("weights"))
                values[i] = static_cast<float>((about1 ? 1 : 0) +
                                               0.3 * (random.uniform(static_cast<int>(i), list) - 0.5));
        ++list;
    };
    weights.everyLearned(stir);
    weights.everyRunning(stir);
    return weights;
}

GeneratorShape smallShape(int dimensions = 3) {
    GeneratorShape shape;
    shape.dimensions = dimensions;
    shape.coarsest = 3;
    shape.step = 2;
    return shape;
}

/// The coordinates at each scale that one output coordinate depends on, followed through every operation.
std::vector<std::set<std::int64_t>> traced(std::int64_t coordinate, int coarsest) {
    std::vector<std::set<std::int64_t>> noise;
    std::set<std::int64_t> wanted = {coordinate};
    const auto spread = [](const std::set<std::int64_t>& from, int by) {
        std::set<std::int64_t> to;
        for (const std::int64_t one : from)
            for (int d = -by; d <= by; ++d)
                to.insert(one + d);
        return to;
    };
    for (int k = 0; k <= coarsest; ++k) {
        const std::set<std::int64_t> joined = spread(wanted, 2);
        noise.push_back(k == coarsest ? joined : spread(joined, 2));
        wanted.clear();
        for (const std::int64_t one : joined)
            wanted.insert(static_cast<std::int64_t>(std::floor(static_cast<double>(one) / 2)));
    }
    return noise;
}

TEST(GeneratorIntervals, areWhatTracingEveryVoxelFinds) {
    for (std::int64_t begin = -7; begin < 7; ++begin)
        for (int length = 1; length <= 40; ++length) {
            const auto intervals = scaleIntervals({begin, begin + length}, 5);
            std::vector<std::set<std::int64_t>> all(6);
            for (std::int64_t one = begin; one < begin + length; ++one)
                for (std::size_t k = 0; const auto& needed : traced(one, 5))
                    all[k++].insert(needed.begin(), needed.end());
            for (std::size_t k = 0; k < all.size(); ++k) {
                EXPECT_EQ(intervals[k].noise.begin, *all[k].begin());
                EXPECT_EQ(intervals[k].noise.end, *all[k].rbegin() + 1);
                EXPECT_EQ(intervals[k].noise.length(), static_cast<int>(all[k].size())) << "without gaps";
            }
        }
}

TEST(GeneratorIntervals, ofWhatRepeatsAreThoseOfEveryRound) {
    for (const int period : {1, 2, 3, 7, 20, 32})
        for (std::int64_t begin = -period - 3; begin <= period; ++begin) {
            const auto here = scaleIntervals({begin, begin + 5}, 4, period);
            const auto there = scaleIntervals({begin + 3 * period, begin + 3 * period + 5}, 4, period);
            for (int k = 0; k <= 4; ++k) {
                const int around = periodAt(period, k);
                EXPECT_EQ(here[static_cast<std::size_t>(k)].noise.begin + 3 * around,
                          there[static_cast<std::size_t>(k)].noise.begin);
                EXPECT_EQ(here[static_cast<std::size_t>(k)].noise.end + 3 * around,
                          there[static_cast<std::size_t>(k)].noise.end);
            }
            if (period % 16 == 0) {
                EXPECT_EQ(here.back().noise, scaleIntervals({begin, begin + 5}, 4).back().noise)
                    << "halving needs no rounding up";
            }
        }
}

TEST(GeneratorWeights, ofTheSourceAreSoMany) {
    EXPECT_EQ(GeneratorWeights::drawn({}, 1).convolutionNumbers(), 84219);
    GeneratorShape flat;
    flat.dimensions = 2;
    flat.step = 8;
    GeneratorWeights weights = GeneratorWeights::drawn(flat, 1);
    EXPECT_EQ(weights.convolutionNumbers(), 115347) << "those of texture networks";
    std::size_t learned = 0;
    weights.everyLearned(
        [&](const std::string&, const std::vector<float>& values) { learned += values.size(); });
    EXPECT_EQ(learned, 115347U + 1568U) << "with the scales and shifts of normalisations";
    EXPECT_LT(weights.model()->bytes().size(), 500'000U);
}

TEST(GeneratorWeights, surviveTheirFile) {
    const GeneratorWeights weights = stirred({});
    const std::string bytes = weights.model()->bytes();
    EXPECT_LT(bytes.size(), 500'000U);
    GeneratorWeights read = GeneratorWeights::from(modelFromBytes(bytes, "a file"));
    EXPECT_EQ(*read.model(), *weights.model());
}

TEST(GeneratorWeights, refuseOtherModels) {
    Model other = *stirred(smallShape()).model();
    other.kind = "dictionary";
    EXPECT_THROW(GeneratorWeights::from(other), Error);
    other = *stirred(smallShape()).model();
    std::get<std::vector<std::int64_t>>(other.arrays["shape"].values)[1] = 99;
    EXPECT_THAT([&] { GeneratorWeights::from(other); },
                testing::ThrowsMessage<Error>(testing::HasSubstr("99")));
    other = *stirred(smallShape()).model();
    other.arrays.erase("last.bias");
    EXPECT_THAT([&] { GeneratorWeights::from(other); },
                testing::ThrowsMessage<Error>(testing::HasSubstr("last.bias")));
}

/// Every voxel of `part` as `whole` has it.
void expectPart(const Volume& part, const Box& partBox, const Volume& whole, const Box& box) {
    for (int c = 0; c < part.channels(); ++c)
        for (int z = 0; z < part.depth(); ++z)
            for (int y = 0; y < part.height(); ++y)
                for (int x = 0; x < part.width(); ++x)
                    ASSERT_EQ(part(x, y, z, c), whole(x + static_cast<int>(partBox.x - box.x),
                                                      y + static_cast<int>(partBox.y - box.y),
                                                      z + static_cast<int>(partBox.z - box.z), c));
}

TEST(Generator, makesBoxesThatFitTogetherBitForBit) {
    Work work;
    const Generator generator(stirred({}));
    const GeneratorNoise noise(5);
    const Box whole{-21, -9, -17, {40, 33, 36}};
    const Volume all = generator.evaluate(whole, noise, work.context);
    for (const Box& part :
         {Box{-21, -9, -17, {1, 1, 1}}, Box{18, 23, 18, {1, 1, 1}}, Box{-1, -1, -1, {2, 2, 2}},
          Box{-5, -3, -2, {11, 17, 9}}, Box{0, 0, 0, {16, 1, 16}}, Box{3, -9, 1, {1, 33, 5}}})
        expectPart(generator.evaluate(part, noise, work.context), part, all, whole);
}

TEST(Generator, givesTheSameBitsForAnyNumberOfThreads) {
    Work one(1), many(5);
    const Generator generator(stirred(smallShape()));
    const Box box{-3, 5, 7, {13, 10, 11}};
    EXPECT_TRUE(sameVoxels(generator.evaluate(box, GeneratorNoise(2), one.context),
                           generator.evaluate(box, GeneratorNoise(2), many.context)));
}

TEST(Generator, repeatsWhereItsNoiseDoes) {
    Work work;
    const auto generator = std::make_shared<const Generator>(stirred(smallShape()));
    const GeneratorSource solid(generator, 3, {32, 16, 8});
    const Volume here = solid.sample({-4, 1, 2, {9, 8, 7}}, work.context);
    const Volume there = solid.sample({28, 17, -6, {9, 8, 7}}, work.context);
    EXPECT_TRUE(sameVoxels(here, there));
    EXPECT_FALSE(sameVoxels(here, solid.sample({5, 1, 2, {9, 8, 7}}, work.context)));
}

TEST(Generator, ofPicturesLeavesZAlone) {
    Work work;
    const Generator generator(stirred(smallShape(2)));
    const GeneratorNoise noise(5);
    const Box whole{-8, -6, 0, {30, 20, 1}};
    const Volume all = generator.evaluate(whole, noise, work.context);
    const Box part{3, -2, 0, {5, 7, 1}};
    expectPart(generator.evaluate(part, noise, work.context), part, all, whole);
}

/// Feature maps on a torus, the oracle of pictures: written down as the source has it (Gutierrez 2020,
/// section 4.1.2), with circular padding and normalisations that are not folded.
struct Maps {
    int width, height;
    std::vector<std::vector<double>> channels;

    double at(std::size_t c, int x, int y) const {
        const int right = (x % width + width) % width, down = (y % height + height) % height;
        return channels[c][static_cast<std::size_t>(down * width + right)];
    }
};

Maps convolved(const Maps& in, const FieldFilters& filters) {
    Maps out{in.width, in.height, {}};
    const int reach = filters.taps == 1 ? 0 : 1;
    for (int o = 0; o < filters.outputs; ++o) {
        std::vector<double>& to = out.channels.emplace_back();
        for (int y = 0; y < in.height; ++y)
            for (int x = 0; x < in.width; ++x) {
                auto sum = static_cast<double>(filters.bias[static_cast<std::size_t>(o)]);
                for (int c = 0; c < filters.inputs; ++c)
                    for (int t = 0; t < filters.taps; ++t)
                        sum += static_cast<double>(filters.filter(o, c)[t]) *
                               in.at(static_cast<std::size_t>(c), x + t % 3 - reach, y + t / 3 - reach);
                to.push_back(sum);
            }
    }
    return out;
}

Maps normalised(Maps maps, const Normalisation& norm, bool rectified) {
    for (std::size_t c = 0; c < maps.channels.size(); ++c)
        for (double& value : maps.channels[c]) {
            value = static_cast<double>(norm.scale[c]) * (value - static_cast<double>(norm.mean[c])) /
                        std::sqrt(static_cast<double>(norm.variance[c]) + 1e-5) +
                    static_cast<double>(norm.shift[c]);
            if (rectified)
                value = std::max(0.0, value);
        }
    return maps;
}

Maps throughBlock(Maps maps, const GeneratorBlock& block) {
    for (const GeneratorLayer& layer : block)
        maps = normalised(convolved(maps, layer.filters), layer.norm, true);
    return maps;
}

Maps picture(const GeneratorWeights& weights, const GeneratorNoise& noise, int width, int height) {
    const int coarsest = weights.shape.coarsest;
    Maps made{};
    for (int k = coarsest; k >= 0; --k) {
        const GeneratorWeights::Scale& scale = weights.scales[static_cast<std::size_t>(k)];
        Maps z{periodAt(width, k), periodAt(height, k), {}};
        for (int c = 0; c < weights.shape.noiseChannels; ++c) {
            std::vector<double>& to = z.channels.emplace_back();
            for (int y = 0; y < z.height; ++y)
                for (int x = 0; x < z.width; ++x)
                    to.push_back(static_cast<double>(noise.at(x, y, 0, k, c)));
        }
        const Maps own = throughBlock(z, scale.noise);
        if (k == coarsest) {
            made = own;
            continue;
        }
        Maps up{z.width, z.height, {}};
        for (std::size_t c = 0; c < made.channels.size(); ++c) {
            std::vector<double>& to = up.channels.emplace_back();
            for (int y = 0; y < z.height; ++y)
                for (int x = 0; x < z.width; ++x)
                    to.push_back(made.at(c, x / 2, y / 2));
        }
        Maps joined = normalised(up, scale.up, false);
        const Maps side = normalised(own, scale.side, false);
        joined.channels.insert(joined.channels.end(), side.channels.begin(), side.channels.end());
        made = throughBlock(joined, scale.joined);
    }
    return convolved(made, weights.last);
}

TEST(Generator, ofPicturesIsWhatTheSourceWritesDown) {
    Work work;
    for (const int coarsest : {0, 1, 2})
        for (const Box& box : {Box{0, 0, 0, {4, 4, 1}}, Box{0, 0, 0, {8, 4, 1}}, Box{0, 0, 0, {7, 5, 1}}}) {
            GeneratorShape shape = smallShape(2);
            shape.coarsest = coarsest;
            const GeneratorWeights weights = stirred(shape);
            const GeneratorNoise noise(5, {box.size.width, box.size.height, 0});
            const Volume made = Generator(weights).evaluate(box, noise, work.context);
            const Maps wanted = picture(weights, noise, box.size.width, box.size.height);
            for (int c = 0; c < 3; ++c)
                for (int y = 0; y < made.height(); ++y)
                    for (int x = 0; x < made.width(); ++x)
                        EXPECT_NEAR(made(x, y, 0, c), wanted.at(static_cast<std::size_t>(c), x, y), 1e-5);
        }
}

TEST(Generator, ofPicturesShiftsWithItsNoise) {
    Work work;
    const Generator generator(stirred(smallShape(2)));
    constexpr int kSlice = 24, kShift = 8; // 2^K
    const GeneratorNoise noise(5, {kSlice, kSlice, 0});
    const Volume all = generator.evaluate({0, 0, 0, {kSlice, kSlice, 1}}, noise, work.context);
    const Volume shifted = generator.evaluate({kShift, -kShift, 0, {kSlice, kSlice, 1}}, noise, work.context);
    for (int y = 0; y < kSlice; ++y)
        for (int x = 0; x < kSlice; ++x)
            ASSERT_EQ(shifted(x, y, 0, 0), all((x + kShift) % kSlice, (y + kSlice - kShift) % kSlice, 0, 0));
}

TEST(Generator, ofPicturesClosesOnItselfAfterAnyNumberOfPixels) {
    Work work;
    const Generator generator(stirred(smallShape(2)));
    for (const int width : {1, 5, 22, 31, 32}) {
        const GeneratorNoise noise(5, {width, 13, 0});
        const Box whole{-2 * width, -13, 0, {4 * width, 39, 1}};
        const Volume all = generator.evaluate(whole, noise, work.context);
        for (int y = 0; y < 26; ++y)
            for (int x = 0; x < 3 * width; ++x) {
                ASSERT_EQ(all(x, y, 0, 1), all(x + width, y, 0, 1));
                ASSERT_EQ(all(x, y, 0, 1), all(x, y + 13, 0, 1));
            }
        const Box part{width / 2, 3, 0, {width, 9, 1}};
        expectPart(generator.evaluate(part, noise, work.context), part, all, whole);
    }
}

TEST(GeneratorNoise, isUniformAndDiffersBetweenScales) {
    const GeneratorNoise noise(1);
    double sum = 0, squares = 0;
    for (int i = 0; i < 4000; ++i) {
        const auto value = static_cast<double>(noise.at(i - 2000, 3 * i, -i, 2, i % 3));
        ASSERT_GE(value, 0);
        ASSERT_LT(value, 1);
        sum += value / 4000;
        squares += value * value / 4000;
    }
    EXPECT_NEAR(sum, 0.5, 0.02);
    EXPECT_NEAR(squares - sum * sum, 1.0 / 12, 0.005);
    EXPECT_NE(noise.at(1, 2, 3, 0, 0), noise.at(1, 2, 3, 1, 0));
}

/// ½ Σ (voxel × its place's number), whose derivative is that number.
Volume lossGradient(const Box& box, int channels) {
    Volume gradient(box.size, channels);
    const Random random(3);
    for (int c = 0; c < channels; ++c)
        for (int z = 0; z < gradient.depth(); ++z)
            for (int y = 0; y < gradient.height(); ++y)
                for (int x = 0; x < gradient.width(); ++x)
                    gradient(x, y, z, c) =
                        static_cast<float>(random.normal(x + 100 * z, y, static_cast<std::uint32_t>(c)));
    return gradient;
}

double lossOf(const GeneratorWeights& weights, const Box& box, const GeneratorNoise& noise,
              const Volume& by) {
    Work work;
    GeneratorTrainer trainer(weights);
    const Volume& made = trainer.forward(box, noise, work.context);
    double sum = 0;
    for (int c = 0; c < made.channels(); ++c)
        for (int z = 0; z < made.depth(); ++z)
            for (int y = 0; y < made.height(); ++y)
                for (int x = 0; x < made.width(); ++x)
                    sum += static_cast<double>(made(x, y, z, c)) * static_cast<double>(by(x, y, z, c));
    return sum;
}

/// Every second channel so high above 0, and the others so far below, that no small change crosses a kink of
/// the rectifiers.
GeneratorWeights farFromKinks(GeneratorWeights weights) {
    weights.everyLearned([](const std::string& name, std::vector<float>& values) {
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (name.ends_with("norm.shift"))
                values[i] += i % 2 == 0 ? 3.0F : -3.0F;
            if (name.ends_with("norm.scale"))
                values[i] *= 0.4F;
        }
    });
    return weights;
}

void expectDerivatives(const GeneratorShape& shape, const Box& box, const VolumeSize& period = {}) {
    const GeneratorNoise noise(9, period);
    Work work;
    const GeneratorWeights weights = farFromKinks(stirred(shape));
    const Volume by = lossGradient(box, shape.channels);
    GeneratorTrainer trainer(weights);
    trainer.forward(box, noise, work.context);
    trainer.backward(by, work.context);
    std::vector<std::vector<float>> found;
    GeneratorWeights gradients = trainer.gradients();
    gradients.everyLearned(
        [&](const std::string&, const std::vector<float>& values) { found.push_back(values); });
    // Single precision still tells the ends of such a step apart.
    constexpr float kStep = 2e-3F;
    std::size_t list = 0;
    double squares = 0, errors = 0;
    GeneratorWeights names = weights;
    names.everyLearned([&](const std::string& name, const std::vector<float>& values) {
        const std::size_t i = values.size() / 2;
        const auto moved = [&](float by2) {
            GeneratorWeights copy = weights;
            copy.everyLearned([&](const std::string& other, std::vector<float>& numbers) {
                if (other == name)
                    numbers[i] += by2;
            });
            return copy;
        };
        const double difference =
            (lossOf(moved(kStep), box, noise, by) - lossOf(moved(-kStep), box, noise, by)) /
            (2 * static_cast<double>(kStep));
        const auto derivative = static_cast<double>(found[list++][i]);
        squares += difference * difference;
        errors += (difference - derivative) * (difference - derivative);
        EXPECT_NEAR(derivative, difference, 0.05 * std::abs(difference) + 0.2) << name;
    });
    EXPECT_LT(std::sqrt(errors / squares), 0.02);
}

TEST(GeneratorTrainer, derivativesAreThoseOfDifferences) {
    expectDerivatives(smallShape(), {3, -2, 5, {12, 11, 1}});
    expectDerivatives(smallShape(2), {3, -2, 0, {12, 11, 1}});
    expectDerivatives(smallShape(2), {0, 0, 0, {12, 11, 1}}, {12, 11, 0});
}

TEST(GeneratorTrainer, goesOnFromItsStateBitForBit) {
    Work work;
    const Box box{1, 2, 3, {10, 1, 10}};
    const Volume by = lossGradient(box, 3);
    GeneratorTrainer whole(stirred(smallShape())), second(GeneratorWeights::drawn(smallShape(), 1));
    for (int n = 0; n < 3; ++n) {
        whole.forward(box, GeneratorNoise(static_cast<std::uint64_t>(n)), work.context);
        whole.backward(by, work.context);
        whole.step(0.01);
        if (n == 0)
            second.restore(whole.state());
        if (n == 0)
            continue;
        second.forward(box, GeneratorNoise(static_cast<std::uint64_t>(n)), work.context);
        second.backward(by, work.context);
        second.step(0.01);
    }
    EXPECT_EQ(whole.state(), second.state());
    EXPECT_THROW(second.restore("short"), Error);
}

TEST(GeneratorTrainer, evaluationIsTrainingWithItsOwnStatistics) {
    constexpr int kSlice = 64;
    Work work;
    const Box box{0, 0, 0, {kSlice, kSlice, 1}};
    GeneratorTrainer trainer(stirred(smallShape()));
    for (int n = 0; n < 200; ++n) // until the running statistics are those of this box
        trainer.forward(box, GeneratorNoise(4), work.context);
    const Volume trained = trainer.forward(box, GeneratorNoise(4), work.context);
    const Volume evaluated = Generator(trainer.weights()).evaluate(box, GeneratorNoise(4), work.context);
    for (int y = 0; y < kSlice; ++y)
        for (int x = 0; x < kSlice; ++x)
            EXPECT_NEAR(evaluated(x, y, 0, 0), trained(x, y, 0, 0), 0.03)
                << "the running variance is that of a larger population";
}

} // namespace
} // namespace texloom::test
