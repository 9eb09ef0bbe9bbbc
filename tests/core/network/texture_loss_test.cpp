#include "core/base/error.h"
#include "core/network/texture_loss.h"
#include "tests/core/network/network_job.h"

#include <gtest/gtest.h>

#include <cmath>

namespace texloom::test {
namespace {

using Kind = DescriptorLayer::Kind;

Filters smallFilters(int outputs, int inputs, int side, int seed) {
    Filters filters = Filters::zero(outputs, inputs, side);
    const Random random(static_cast<std::uint64_t>(seed));
    for (std::size_t i = 0; i < filters.weights.size(); ++i)
        filters.weights[i] = static_cast<float>(random.normal(static_cast<int>(i), 1) / side);
    for (std::size_t i = 0; i < filters.bias.size(); ++i)
        filters.bias[i] = static_cast<float>(0.2 * random.normal(static_cast<int>(i), 2));
    return filters;
}

/// Two chains, three taps, one of them not rectified.
Descriptor smallDescriptor(int channels) {
    Descriptor descriptor;
    descriptor.name = "small";
    descriptor.licence = "CC0-1.0";
    descriptor.credit = "made up";
    descriptor.channels = channels;
    descriptor.offset = 0.5F;
    descriptor.scale = 4;
    descriptor.chains = {{{Kind::Convolution, "a", smallFilters(6, channels, 3, 1)},
                          {Kind::Rectifier, "", {}},
                          {Kind::Tap, "first", {}},
                          {Kind::Pool, "", {}},
                          {Kind::Convolution, "b", smallFilters(5, 6, 3, 2)},
                          {Kind::Rectifier, "", {}},
                          {Kind::Tap, "second", {}}},
                         {{Kind::Convolution, "c", smallFilters(4, channels, 5, 3)},
                          {Kind::Tap, "plain", {}},
                          {Kind::Rectifier, "", {}},
                          {Kind::Tap, "third", {}}}};
    return descriptor;
}

/// Values from 0 to 1, smooth on one scale.
Tensor smoothPicture(int channels, int height, int width, int seed) {
    const Tensor noise = normalTensor(channels, height, width, seed);
    Tensor to(channels, height, width);
    for (int c = 0; c < channels; ++c)
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                to.row(c, y)[x] =
                    std::clamp(0.5F + 0.1F * (noise.row(c, y)[x] + noise.row(c, y)[(x + 1) % width] +
                                              noise.row(0, (y + 1) % height)[x]),
                               0.0F, 1.0F);
    return to;
}

struct LossCase {
    const char* name;
    TextureLossOptions options;
    Edges edges;
    int channels;
};

class LossGradient : public testing::TestWithParam<LossCase> {};

/// Along random directions the derivative is the central difference.
TEST_P(LossGradient, isTheCentralDifference) {
    NetworkJob job;
    const Tensor exemplar = smoothPicture(GetParam().channels, 24, 20, 1);
    const Descriptor descriptor = smallDescriptor(GetParam().channels == 1 ? 3 : GetParam().channels);
    const LossExemplar learned{&exemplar, 1};
    TextureLoss loss(descriptor, GetParam().options, {&learned, 1}, job.context);
    const Tensor at0 = smoothPicture(GetParam().channels, 16, 18, 2);
    Tensor gradient;
    loss.evaluate(at0, GetParam().edges, &gradient, job.context);
    for (int trial = 0; trial < 4; ++trial) {
        // The gradient itself, since along it rounding counts least, and others.
        Tensor along = trial == 0 ? gradient : normalTensor(at0.channels(), 16, 18, 10 + trial);
        const double norm = std::sqrt(innerProduct(along, along));
        const double step = 0.005;
        Tensor ahead = at0, behind = at0;
        for (std::size_t i = 0; i < at0.size(); ++i) {
            along.data()[i] = static_cast<float>(static_cast<double>(along.data()[i]) / norm);
            ahead.data()[i] += static_cast<float>(step) * along.data()[i];
            behind.data()[i] -= static_cast<float>(step) * along.data()[i];
        }
        const double difference = (loss.evaluate(ahead, GetParam().edges, nullptr, job.context) -
                                   loss.evaluate(behind, GetParam().edges, nullptr, job.context)) /
                                  (2 * step);
        const double wanted = innerProduct(gradient, along);
        EXPECT_NEAR(difference, wanted,
                    0.01 * std::abs(wanted) + 2e-3 * std::sqrt(innerProduct(gradient, gradient)));
    }
}

const Edges kCircular = Edges::all(Padding::Circular);
INSTANTIATE_TEST_SUITE_P(
    Every, LossGradient,
    testing::Values(LossCase{"normalised", {}, kCircular, 3},
                    LossCase{"gram", {.statistic = Statistic::Gram}, kCircular, 3},
                    LossCase{"relative", {.statistic = Statistic::Relative}, kCircular, 3},
                    LossCase{"maximum", {.pooling = Pooling::Maximum}, kCircular, 3},
                    LossCase{"grey", {}, kCircular, 1}, LossCase{"five", {.levels = 1}, kCircular, 5},
                    LossCase{"reflected", {}, Edges::all(Padding::Reflect), 3},
                    LossCase{"half", {.colours = false}, {Padding::Circular, Padding::Reflect}, 3},
                    LossCase{"tap", {.firstTap = 1, .lastTap = 2}, kCircular, 3},
                    LossCase{"variation", {.colours = false, .variation = 1}, kCircular, 3}),
    [](const auto& tested) { return std::string(tested.param.name); });

TEST(TextureLoss, isNothingForTheExemplarItself) {
    NetworkJob job;
    const Tensor exemplar = smoothPicture(3, 32, 32, 1);
    const LossExemplar learned{&exemplar, 1};
    for (const Statistic statistic : {Statistic::Normalised, Statistic::Gram, Statistic::Relative}) {
        TextureLoss loss(smallDescriptor(3), {.statistic = statistic}, {&learned, 1}, job.context);
        Tensor gradient;
        EXPECT_NEAR(loss.evaluate(exemplar, Edges::all(Padding::Reflect), &gradient, job.context), 0, 1e-8);
        EXPECT_NEAR(innerProduct(gradient, gradient), 0, 1e-10);
        EXPECT_GT(
            loss.evaluate(smoothPicture(3, 32, 32, 5), Edges::all(Padding::Reflect), nullptr, job.context),
            1e-4);
        double sum = 0;
        for (const double term : loss.terms())
            sum += term;
        EXPECT_GT(sum, 0);
        EXPECT_EQ(loss.terms().size(), loss.termNames().size());
    }
}

TEST(TextureLoss, doesNotSeeCircularShifts) {
    NetworkJob job;
    const Tensor exemplar = smoothPicture(3, 24, 24, 1), one = smoothPicture(3, 24, 32, 2);
    Tensor other = one;
    for (int c = 0; c < 3; ++c)
        for (int y = 0; y < 24; ++y)
            for (int x = 0; x < 32; ++x)
                other.row(c, (y + 8) % 24)[(x + 12) % 32] = one.row(c, y)[x];
    const LossExemplar learned{&exemplar, 1};
    TextureLoss loss(smallDescriptor(3), {}, {&learned, 1}, job.context);
    const double value = loss.evaluate(one, kCircular, nullptr, job.context);
    EXPECT_NEAR(loss.evaluate(other, kCircular, nullptr, job.context), value, 1e-5 * value);
}

TEST(TextureLoss, weighsExemplars) {
    NetworkJob job;
    const Tensor a = smoothPicture(3, 24, 24, 1), b = smoothPicture(3, 24, 24, 8);
    const LossExemplar twice[] = {{&a, 2}, {&b, 1}}, thrice[] = {{&a, 1}, {&a, 1}, {&b, 1}};
    const TextureLossOptions options{.colours = false};
    TextureLoss weighed(smallDescriptor(3), options, twice, job.context);
    TextureLoss repeated(smallDescriptor(3), options, thrice, job.context);
    const Tensor of = smoothPicture(3, 16, 16, 4);
    const double value = weighed.evaluate(of, kCircular, nullptr, job.context);
    EXPECT_NEAR(repeated.evaluate(of, kCircular, nullptr, job.context), value, 1e-9);
}

TEST(TextureLoss, hasTheSameBitsForAnyNumberOfThreads) {
    const Tensor exemplar = smoothPicture(3, 40, 40, 1), of = smoothPicture(3, 48, 40, 2);
    const LossExemplar learned{&exemplar, 1};
    Tensor gradients[2];
    double values[2] = {};
    for (const int i : {0, 1}) {
        NetworkJob job(i == 0 ? 1 : 4);
        TextureLoss loss(smallDescriptor(3), {}, {&learned, 1}, job.context);
        values[i] = loss.evaluate(of, kCircular, &gradients[i], job.context);
    }
    EXPECT_EQ(values[0], values[1]);
    EXPECT_TRUE(sameBits(gradients[0], gradients[1]));
}

TEST(TextureLoss, momentsAreMeansOfProducts) {
    NetworkJob job;
    TapWorkspace work;
    const Tensor features = normalTensor(17, 9, 13, 1);
    const TapMoments moments = momentsOf(features, work, job.context);
    for (const auto& [i, j] : {std::pair{0, 0}, {3, 16}, {16, 3}, {12, 5}}) {
        double sum = 0;
        for (std::size_t n = 0; n < features.area(); ++n)
            sum += static_cast<double>(features.channel(i)[n]) * static_cast<double>(features.channel(j)[n]);
        EXPECT_NEAR(moments.products(i, j), sum / 117, 1e-6);
    }
    Tensor constant(3, 8, 8);
    std::fill_n(constant.data(), constant.size(), 0.5F);
    const Eigen::MatrixXd products = momentsOf(constant, work, job.context).products;
    EXPECT_NEAR((products - Eigen::MatrixXd::Constant(3, 3, 0.25)).norm(), 0, 1e-9) << "of rank one";
}

TEST(TextureLoss, constantExemplarsHaveNoTexture) {
    NetworkJob job;
    Tensor exemplar(3, 20, 20);
    std::fill_n(exemplar.data(), exemplar.size(), 0.25F);
    const LossExemplar learned{&exemplar, 1};
    TextureLoss loss(smallDescriptor(3), {}, {&learned, 1}, job.context);
    Tensor gradient;
    EXPECT_TRUE(std::isfinite(loss.evaluate(smoothPicture(3, 16, 16, 1), kCircular, &gradient, job.context)));
}

TEST(TextureLoss, refusesWhatDoesNotSuit) {
    NetworkJob job;
    const Tensor two = smoothPicture(2, 24, 24, 1), small = smoothPicture(3, 15, 40, 1);
    const LossExemplar ofTwo{&two, 1}, tooSmall{&small, 1};
    EXPECT_THROW(TextureLoss(smallDescriptor(3), {}, {&ofTwo, 1}, job.context), UsageError);
    EXPECT_THROW(TextureLoss(smallDescriptor(3), {}, {&tooSmall, 1}, job.context), UsageError);
}

TEST(Descriptor, isTheSameFromItsFile) {
    const Descriptor descriptor = smallDescriptor(4);
    const Descriptor again = Descriptor::from(modelFromBytes(descriptor.model().bytes(), "again"));
    EXPECT_EQ(again.model(), descriptor.model());
    EXPECT_EQ(again.taps(), (std::vector<std::string>{"first", "second", "plain", "third"}));
    EXPECT_EQ(again.parameters(), descriptor.parameters());
}

TEST(Descriptor, refusesWhatDoesNotFitTogether) {
    const Model good = smallDescriptor(3).model();
    const auto refused = [&](const auto& change) {
        Model bad = good;
        change(bad);
        EXPECT_THROW(Descriptor::from(bad), Error);
    };
    refused([](Model& bad) { bad.kind = "other"; });
    refused([](Model& bad) { bad.notes.erase("licence"); });
    refused([](Model& bad) { bad.notes["channels"] = "many"; });
    refused([](Model& bad) { bad.notes["channels"] = "4"; });
    refused([](Model& bad) { bad.notes["pooling"] = "strange"; });
    refused([](Model& bad) { bad.notes["network"] = "conv:a relu"; });
    refused([](Model& bad) { bad.notes["network"] = "tap:first"; });
    refused([](Model& bad) { bad.notes["network"] = "conv:a relu tap:x conv:b tap:x"; });
    refused([](Model& bad) { bad.notes["network"] = "conv:absent tap:x"; });
    refused([](Model& bad) { bad.notes["network"] = "exec:rm tap:x"; });
    refused([](Model& bad) { bad.notes["network"] = "conv:a tap:x | conv:a tap:y"; });
    refused([](Model& bad) { bad.arrays.at("b.bias").shape = {4}; });
    refused([](Model& bad) { bad.arrays.at("a.weight") = bad.arrays.at("b.weight"); });
    refused([](Model& bad) { bad.arrays.at("a.weight").values = std::vector<double>(162); });
}

} // namespace
} // namespace texloom::test
