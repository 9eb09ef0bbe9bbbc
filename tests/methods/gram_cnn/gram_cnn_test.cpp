#include "core/base/error.h"
#include "core/io/model_file.h"
#include "core/methods/gram_cnn/minimiser.h"
#include "core/methods/method.h"
#include "core/network/filter_banks.h"
#include "core/session/run/exemplar_file.h"
#include "tests/support/method_run.h"
#include "tests/support/textures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace texloom::test::gram_cnn_tests {
namespace {

using testing::HasSubstr;

const Method& gramCnn() {
    return findMethod("gram-cnn");
}

Synthesis made(const Request& request, const Values& settings, const JobOptions& options = {.threads = 2}) {
    return resultOf(gramCnn(), request, settings, options);
}

std::string refusal(const Request& request, const Values& settings) {
    return refusalOf(gramCnn(), request, settings);
}

const Curve& lossOf(const Synthesis& synthesis) {
    return synthesis.curves.front();
}

double meanDifference(const Image& a, const Image& b) {
    double sum = 0;
    for (int c = 0; c < a.channels(); ++c)
        for (int y = 0; y < a.height(); ++y)
            for (int x = 0; x < a.width(); ++x)
                sum += std::abs(static_cast<double>(a(x, y, c)) - static_cast<double>(b(x, y, c)));
    return sum / static_cast<double>(a.channels() * a.size().area());
}

Image middle(const char* file, int side) {
    const auto whole = loadExemplar(bundled(file)).image;
    return Image(whole->view().crop(100, 100, {side, side}));
}

TEST(GramCnn, lossFallsAHundredfoldWithRandomFilters) {
    const Request request = requestOf(middle("gravel_gray.png", 64), {64, 64});
    const Synthesis result = made(
        request, {{"descriptor", std::string("random")}, {"levels", 2}, {"scales", 1}, {"iterations", 150}});
    EXPECT_LT(100 * lossOf(result).values.back(), lossOf(result).values.front());
    EXPECT_TRUE(std::is_sorted(lossOf(result).values.rbegin(), lossOf(result).values.rend()))
        << "it never rises";
}

TEST(GramCnn, everyTapHasItsCurve) {
    const Request request = requestOf(blobs({48, 48}, 3), {48, 48});
    const Synthesis result = made(request, {{"iterations", 3}, {"scales", 1}});
    ASSERT_EQ(result.curves.size(), 8U) << "the loss, three taps on two levels, colours";
    for (const Curve& curve : result.curves)
        EXPECT_EQ(curve.values.size(), 3U);
    ASSERT_EQ(result.notes.size(), 1U);
    EXPECT_THAT(result.notes.front().text(), HasSubstr("CC0-1.0"));
}

/// A texture that tiles is its own optimum, as far as its own edges are reflected and the output's closed.
TEST(GramCnn, anExemplarThatIsGivenAsTheStartStays) {
    Image exemplar({64, 64}, 1);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            exemplar(x, y, 0) =
                static_cast<float>(0.5 + 0.2 * std::sin(0.3926990817 * x) + 0.2 * std::sin(0.1963495408 * y));
    Request request = requestOf(exemplar, {64, 64});
    request.wrap = {true, true};
    request.inputs.add("initial", std::make_shared<const Image>(exemplar));
    const Values settings = {{"iterations", 20}, {"scales", 1}};
    const double kept = meanDifference(made(request, settings).image, exemplar);
    request.inputs = {};
    EXPECT_LT(kept, 0.03);
    EXPECT_GT(meanDifference(made(request, settings).image, exemplar), 3 * kept);
}

TEST(GramCnn, greyExemplarsGiveGrey) {
    Image grey = blobs({40, 40}, 3);
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 40; ++x)
            grey(x, y, 1) = grey(x, y, 2) = grey(x, y, 0);
    const Image image = made(requestOf(grey, {40, 40}), {{"iterations", 5}}).image;
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 40; ++x)
            ASSERT_NEAR(image(x, y, 1), image(x, y, 2), 1e-4);
}

TEST(GramCnn, valuesStayThoseOfTheExemplar) {
    const Image exemplar = blobs({40, 40}, 3);
    for (const bool histogram : {true, false}) {
        const Image image =
            made(requestOf(exemplar, {50, 30}), {{"iterations", 4}, {"histogram", histogram}}).image;
        for (int c = 0; c < 3; ++c) {
            const ValueRange wanted = valueRange(exemplar.view().channelRange(c, 1));
            const ValueRange range = valueRange(image.view().channelRange(c, 1));
            EXPECT_GE(range.smallest, wanted.smallest);
            EXPECT_LE(range.largest, wanted.largest);
        }
    }
}

TEST(GramCnn, adamLowersTheLossToo) {
    const Request request = requestOf(blobs({32, 32}, 3), {32, 32});
    const Synthesis result =
        made(request, {{"optimiser", std::string("adam")}, {"iterations", 60}, {"colours", false}});
    EXPECT_LT(3 * lossOf(result).values.back(), lossOf(result).values.front());
}

TEST(GramCnn, goesOnFromACheckpointWithTheSameBits) {
    const Request request = requestOf(blobs({64, 64}, 3), {48, 40});
    for (const char* optimiser : {"l-bfgs", "adam"}) {
        const Values settings = {{"iterations", 12}, {"scales", 2}, {"optimiser", std::string(optimiser)}};
        std::vector<Checkpoint> kept;
        JobOptions options{3, 2};
        options.keep = [&](const Checkpoint& checkpoint) { kept.push_back(checkpoint); };
        const Synthesis whole = made(request, settings, options);
        ASSERT_FALSE(kept.empty());
        JobOptions again{3, 1};
        again.resumed = std::make_shared<const Checkpoint>(kept[kept.size() / 2]);
        const Synthesis resumed = made(request, settings, again);
        EXPECT_TRUE(samePixels(whole.image, resumed.image));
        EXPECT_EQ(lossOf(whole).values, lossOf(resumed).values);
        again.resumed =
            std::make_shared<const Checkpoint>(Checkpoint{0, 0.5, kept.front().state.substr(0, 40)});
        EXPECT_THROW(made(request, settings, again), Error);
    }
}

TEST(GramCnn, mapsBesideColoursAreMadeAsChannels) {
    Request request = requestOf(blobs({40, 40}, 5), {40, 40});
    request.companionChannels = 2;
    for (const char* descriptor : {"automatic", "random", "wavelet"}) {
        const Synthesis result = made(request, {{"descriptor", std::string(descriptor)}, {"iterations", 2}});
        EXPECT_EQ(result.image.channels(), 5);
    }
    EXPECT_THAT(refusal(request, {{"descriptor", std::string("own")}}), HasSubstr("sees 3 channels"));
}

TEST(GramCnn, takesADescriptorFromAFile) {
    Request request = requestOf(blobs({40, 40}, 3), {40, 40});
    Descriptor bank = randomDescriptor(3);
    bank.name = "mine";
    request.inputs.add("descriptor", std::make_shared<const Model>(bank.model()));
    const Synthesis result = made(request, {{"iterations", 2}});
    EXPECT_THAT(result.notes.front().text(), HasSubstr("mine"));
    EXPECT_THAT(result.notes.front().text(), HasSubstr(bank.model().hash()));
    EXPECT_THAT(refusal(request, {{"descriptor", std::string("own")}}), HasSubstr("file"));
    Model other;
    other.kind = "sparse-dictionary";
    request.inputs = {};
    request.inputs.add("descriptor", std::make_shared<const Model>(other));
    EXPECT_NE(refusal(request, {}), "was taken");
}

TEST(GramCnn, refusesInASentence) {
    const Request request = requestOf(blobs({40, 40}, 3), {40, 40});
    EXPECT_THAT(refusal(request, {{"first-tap", 4}}), HasSubstr("the descriptor has 3"));
    EXPECT_THAT(refusal(request, {{"first-tap", 3}, {"last-tap", 2}}), HasSubstr("after the last"));
    EXPECT_THAT(refusal(requestOf(blobs({15, 40}, 3), {40, 40}), {}), HasSubstr("needs 16 px"));
}

TEST(GramCnn, weightsThatOverflowAreRefusedInASentence) {
    Descriptor bank = randomDescriptor(3);
    for (auto& chain : bank.chains)
        for (float& weight : chain.front().filters.weights)
            weight *= 1e25F;
    Request request = requestOf(blobs({40, 40}, 3), {40, 40});
    request.inputs.add("descriptor", std::make_shared<const Model>(bank.model()));
    try {
        made(request, {{"iterations", 4}});
        ADD_FAILURE() << "taken";
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), HasSubstr("not numbers at its tap random3"));
    }
}

TEST(GramCnn, aStepThatGivesNoNumberEndsWithTheLastThatDoes) {
    for (const auto optimiser : {gram_cnn::Optimiser::Lbfgs, gram_cnn::Optimiser::Adam}) {
        gram_cnn::Settings settings;
        settings.optimiser = optimiser;
        gram_cnn::Minimiser minimiser(settings, {1, 2});
        int calls = 0;
        const Objective objective = [&](std::span<const float> x, std::span<float> gradient) {
            gradient[0] = x[0];
            gradient[1] = x[1];
            return ++calls > 3 ? std::nan("") : 0.5 * static_cast<double>(x[0] * x[0] + x[1] * x[1]);
        };
        int steps = 0;
        while (steps < 50 && minimiser.step(objective))
            ++steps;
        EXPECT_LT(steps, 10);
        for (const float x : minimiser.x())
            EXPECT_TRUE(std::isfinite(x));
    }
}

} // namespace
} // namespace texloom::test::gram_cnn_tests
