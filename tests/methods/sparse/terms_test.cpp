#include "core/methods/sparse/enlarged_cubic.h"
#include "core/methods/sparse/synthesizer.h"
#include "core/methods/sparse/terms.h"
#include "tests/support/textures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <utility>

namespace texloom::sparse::test {
namespace {

using texloom::test::blobs;
using texloom::test::constant;
using texloom::test::noise;

template <class Body> auto inJob(const Body& body) {
    JobMonitor monitor;
    JobContext context(
        {3, 2, false}, [] { return false; }, monitor);
    context.stage(1, "testing");
    return body(context);
}

/// Adds a term's gradient to an image and says its energy.
using Add = std::function<double(const Image& image, double weight, JobContext& context, Image& gradient)>;

struct Slope {
    double energy;
    Image gradient;
};

Slope slopeOf(const Add& add, const Image& image, double weight = 1) {
    Slope slope{0, Image(image.size(), image.channels())};
    inJob([&](JobContext& context) { slope.energy = add(image, weight, context, slope.gradient); });
    return slope;
}

double dot(const Image& a, const Image& b) {
    double sum = 0;
    for (int c = 0; c < a.channels(); ++c)
        for (int y = 0; y < a.height(); ++y)
            for (int x = 0; x < a.width(); ++x)
                sum += static_cast<double>(a(x, y, c)) * static_cast<double>(b(x, y, c));
    return sum;
}

Image plus(const Image& a, double factor, const Image& b) {
    Image sum(a);
    for (int c = 0; c < a.channels(); ++c)
        for (int y = 0; y < a.height(); ++y)
            for (int x = 0; x < a.width(); ++x)
                sum(x, y, c) += static_cast<float>(factor) * b(x, y, c);
    return sum;
}

/// The change of the energy along a direction is twice the product with half the gradient.
void expectSlope(const Add& add, const Image& image, double tolerance) {
    const Image direction = noise(image.size(), image.channels(), 77);
    const double step = 1e-3;
    const double rise = slopeOf(add, plus(image, step, direction)).energy -
                        slopeOf(add, plus(image, -step, direction)).energy;
    const double wanted = 2 * 2 * step * dot(slopeOf(add, image).gradient, direction);
    EXPECT_NEAR(rise, wanted, tolerance * std::abs(wanted));
}

Add histogramOf(const Image& exemplar, bool principal = true) {
    auto term = inJob([&](JobContext& context) {
        return std::make_shared<HistogramTerm>(PatchSource{exemplar.view(), {}}, principal, context);
    });
    return [term](const Image& image, double weight, JobContext& context, Image& gradient) {
        return term->add(image, weight, context, gradient);
    };
}

Add lowPassOf(Image target, Wrap wrap, int patch) {
    auto term = std::make_shared<LowPassTerm>(std::move(target), wrap, patch);
    return [term](const Image& image, double weight, JobContext& context, Image& gradient) {
        return term->add(image, weight, context, gradient);
    };
}

Add spectrumOf(const Image& exemplar, Size size) {
    auto term = inJob(
        [&](JobContext& context) { return std::make_shared<SpectrumTerm>(exemplar.view(), size, context); });
    return [term](const Image& image, double weight, JobContext& context, Image& gradient) {
        return term->add(image, weight, context, gradient);
    };
}

TEST(SparseTerms, gradientsAreThoseOfTheEnergies) {
    const Image exemplar = blobs({24, 20}, 3), image = noise({31, 23}, 3, 5);
    expectSlope(histogramOf(exemplar), image, 0.02);
    for (const Wrap wrap : {Wrap{}, Wrap{true, false}, Wrap{true, true}})
        expectSlope(lowPassOf(blobs({31, 23}, 3), wrap, 7), image, 0.02);
    expectSlope(spectrumOf(exemplar, {31, 23}), image, 0.02);
}

TEST(SparseTerms, weightsCountOnce) {
    const Image image = noise({20, 20}, 2, 6);
    const Add terms[] = {histogramOf(blobs({20, 20}, 2)), lowPassOf(blobs({20, 20}, 2), {}, 5),
                         spectrumOf(blobs({20, 20}, 2), {20, 20})};
    for (const Add& add : terms) {
        const Slope one = slopeOf(add, image, 1), three = slopeOf(add, image, 3);
        EXPECT_EQ(one.energy, three.energy);
        EXPECT_NEAR(dot(three.gradient, three.gradient), 9 * dot(one.gradient, one.gradient),
                    1e-3 * dot(three.gradient, three.gradient));
    }
}

TEST(SparseTerms, anExemplarsOwnPixelsInAnyOrderHaveItsDistribution) {
    const Image exemplar = blobs({24, 20}, 3);
    Image turned({24, 20}, 3);
    for (int c = 0; c < 3; ++c)
        for (int y = 0; y < 20; ++y)
            for (int x = 0; x < 24; ++x)
                turned(x, y, c) = exemplar((x + 5) % 24, 19 - y, c);
    for (const bool principal : {false, true})
        EXPECT_NEAR(slopeOf(histogramOf(exemplar, principal), turned).energy, 0, 1e-8);
    EXPECT_GT(slopeOf(histogramOf(exemplar), noise({24, 20}, 3)).energy, 1);
}

TEST(SparseTerms, lowPassIsTheSquareOfMeansOverPatches) {
    const Image image = noise({17, 13}, 1, 8), target = noise({17, 13}, 1, 9);
    const double energy = slopeOf(lowPassOf(target, {true, true}, 4), image).energy;
    double wanted = 0;
    for (int y = 0; y < 13; ++y)
        for (int x = 0; x < 17; ++x) {
            double sum = 0;
            for (int j = 0; j < 4; ++j)
                for (int i = 0; i < 4; ++i)
                    sum += static_cast<double>(image((x + i) % 17, (y + j) % 13, 0) -
                                               target((x + i) % 17, (y + j) % 13, 0));
            wanted += sum / 16 * (sum / 16);
        }
    EXPECT_NEAR(energy, wanted, 1e-4 * wanted);
}

TEST(SparseTerms, theSpectrumTermProjects) {
    const Image exemplar = blobs({32, 24}, 3);
    const Add add = spectrumOf(exemplar, {40, 36});
    const Image image = noise({40, 36}, 3, 4);
    const Slope first = slopeOf(add, image);
    const Image nearest = plus(image, -1, first.gradient);
    EXPECT_NEAR(first.energy, dot(first.gradient, first.gradient), 1e-3 * first.energy);
    EXPECT_LT(slopeOf(add, nearest).energy, 1e-6 * first.energy) << "S(S(u)) = S(u)";
    const std::vector<double> means = channelMeans(nearest), wanted = channelMeans(exemplar);
    for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(means[c], wanted[c], 1e-4);
}

/// The three terms of the source.
Settings published() {
    Settings settings;
    settings.spectrum = false;
    return settings;
}

/// Everything draws towards one value, from 1 beside it. @return how far it is after some steps.
double distanceAfter(int steps, double factor) {
    const Settings settings = published();
    const Image exemplar = constant({16, 16}, 1, 2);
    const Add histogram = histogramOf(exemplar), lowPass = lowPassOf(exemplar, {true, true}, 5);
    Image image = constant({16, 16}, 1, 3);
    const double eta = factor * 2 * Synthesizer::stepFor(settings, 1);
    for (int i = 0; i < steps; ++i) {
        Image gradient = plus(image, -1, exemplar);
        inJob([&](JobContext& context) {
            histogram(image, settings.histogramWeight(), context, gradient);
            lowPass(image, settings.lowPassWeight(), context, gradient);
        });
        image = plus(image, -2 * eta, gradient);
    }
    return std::abs(static_cast<double>(image(3, 4, 0)) - 2);
}

TEST(SparseTerms, stepsLeadDownAndLongerOnesAway) {
    EXPECT_NEAR(Synthesizer::stepFor(published(), 1), 0.5 / 3, 1e-12);
    EXPECT_NEAR(Synthesizer::stepFor({}, 1), 0.5 / 3.3, 1e-12) << "the spectrum counts too";
    EXPECT_LT(distanceAfter(10, 0.5), 1e-3);
    EXPECT_GT(distanceAfter(10, 1.1), 5) << "1.1 / (1 + α + β)";
    EXPECT_GT(distanceAfter(10, 3.9), 1000) << "below the bound that the source prints, 4 / (1 + α + β)";
}

TEST(SparseTerms, theEnergyNeverRisesWithAverages) {
    const Size size{41, 37};
    Settings settings;
    settings.spectrum = true;
    const PatchColumns grid(size, {true, false}, 8, 4);
    const Eigen::MatrixXf patches = Eigen::MatrixXf::Random(8 * 8 * 2, grid.count());
    const Image exemplar = blobs({30, 30}, 2);
    const Add terms[] = {histogramOf(exemplar), lowPassOf(blobs(size, 2, 2), {true, false}, 8),
                         spectrumOf(exemplar, size)};
    Image joined(size, 2), image = noise(size, 2, 11);
    inJob([&](JobContext& context) {
        grid.average([&](int k, Eigen::Ref<Eigen::VectorXf> to) { to = patches.col(k); }, context, joined);
    });
    constexpr double kOverlaps = 4;
    const double step = 2 * Synthesizer::stepFor(settings, grid.mostCovering() / kOverlaps);
    double before = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 30; ++i) {
        Image gradient = plus(image, -1, joined);
        double energy = 0;
        for (int c = 0; c < 2; ++c)
            for (int y = 0; y < size.height; ++y)
                for (int x = 0; x < size.width; ++x) {
                    const double share = grid.covering(x, y) / kOverlaps;
                    energy += share * std::pow(static_cast<double>(gradient(x, y, c)), 2);
                    gradient(x, y, c) *= static_cast<float>(share);
                }
        inJob([&](JobContext& context) {
            for (const Add& add : terms)
                energy += add(image, 1, context, gradient);
        });
        EXPECT_LE(energy, before * (1 + 1e-6)) << "step " << i;
        before = energy;
        image = plus(image, -step, gradient);
    }
}

TEST(SparseTerms, enlargingKeepsWavesAndCloses) {
    Image wave({24, 16}, 1);
    const double turn = 2 * std::acos(-1.0);
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 24; ++x)
            wave(x, y, 0) =
                static_cast<float>(std::sin(turn * (x + 0.5) / 24) * std::cos(turn * (y + 0.5) / 16));
    const Image large = inJob([&](JobContext& context) {
        return enlargedCubic(wave, {48, 33}, {true, true}, context);
    });
    for (int y = 0; y < 33; ++y)
        for (int x = 0; x < 48; ++x)
            EXPECT_NEAR(large(x, y, 0), std::sin(turn * (x + 0.5) / 48) * std::cos(turn * (y + 0.5) / 33),
                        0.01);
}

} // namespace
} // namespace texloom::sparse::test
