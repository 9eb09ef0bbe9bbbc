#include "core/base/error.h"
#include "core/io/model_file.h"
#include "core/methods/dictionary_model.h"
#include "core/methods/method.h"
#include "tests/support/method_run.h"
#include "tests/support/textures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace texloom::test::sparse_tests {
namespace {

using testing::HasSubstr;

Request requestFor(Image exemplar, Size size) {
    return requestOf(std::move(exemplar), size, {}, 5);
}

const Values kBrief = {
    {"patch", 8}, {"spacing", 4}, {"atoms", 48}, {"learning-iterations", 4}, {"iterations", 6}};

Values brief(const Values& also) {
    return with(kBrief, also);
}

Synthesis runMethod(const char* id, const Request& request, const Values& settings, JobOptions options = {}) {
    options.threads = 2;
    return resultOf(findMethod(id), request, settings, options);
}

Synthesis synthesise(const Request& request, const Values& settings, const JobOptions& options = {}) {
    return runMethod("sparse", request, settings, options);
}

std::map<std::string, std::vector<double>> curvesOf(const Synthesis& result) {
    std::map<std::string, std::vector<double>> curves;
    for (const Curve& curve : result.curves)
        curves[curve.name.text()] = curve.values;
    return curves;
}

double meanSquare(const Image& a, const Image& b) {
    double sum = 0;
    for (int c = 0; c < a.channels(); ++c)
        for (int y = 0; y < a.height(); ++y)
            for (int x = 0; x < a.width(); ++x)
                sum += std::pow(static_cast<double>(a(x, y, c) - b(x, y, c)), 2);
    return sum / static_cast<double>(a.size().area() * a.channels());
}

/// Figure 4 of the source: each adds one constraint to those before it.
std::vector<Values> ablation() {
    std::vector<Values> all = {
        {{"frequency", false}, {"reconstruction", "average"}, {"scales", 1}, {"low-pass", false}}};
    for (const auto& [name, value] :
         std::vector<std::pair<std::string, Value>>{{"frequency", true},
                                                    {"reconstruction", std::string("cut")},
                                                    {"scales", 3},
                                                    {"low-pass", true}}) {
        all.push_back(all.back());
        all.back()[name] = value;
    }
    return all;
}

TEST(Sparse, everySwitchDoesSomething) {
    const Request request = requestFor(blobs({48, 44}, 3), {48, 44});
    std::vector<Image> images;
    for (const Values& settings : ablation())
        images.push_back(synthesise(request, brief(settings)).image);
    for (std::size_t i = 0; i < images.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_FALSE(samePixels(images[i], images[j])) << i << " and " << j;
}

TEST(Sparse, orthogonalPursuitCodesAnExemplarMoreClosely) {
    const Image exemplar = blobs({48, 48}, 2);
    Request request = requestFor(exemplar, exemplar.size());
    request.inputs.set(kInitialPort, std::make_shared<const Image>(exemplar));
    const auto codingWith = [&](const char* pursuit) {
        return curvesOf(synthesise(request, brief({{"scales", 1},
                                                   {"frequency", false},
                                                   {"iterations", 1},
                                                   {"pursuit", std::string(pursuit)}})))
            .at("Sparse coding")
            .front();
    };
    EXPECT_LT(codingWith("orthogonal"), codingWith("plain"));
}

TEST(Sparse, draftsThatAreLookedAtChangeNothing) {
    const Request request = requestFor(blobs({40, 40}, 3), {52, 48});
    const Values settings = brief({{"scales", 2}, {"iterations", 2}});
    JobOptions looked;
    looked.previews = true;
    EXPECT_TRUE(samePixels(synthesise(request, settings).image, synthesise(request, settings, looked).image));
}

TEST(Sparse, hasACurveForEachTermThatIsOn) {
    const Request request = requestFor(blobs({40, 40}, 1), {44, 40});
    const auto all = curvesOf(synthesise(request, brief({{"spectrum", true}, {"scales", 1}})));
    for (const char* name :
         {"Energy of a pixel", "Sparse coding", "Histogram", "Low frequencies", "Spectrum"}) {
        ASSERT_TRUE(all.contains(name)) << name;
        EXPECT_EQ(all.at(name).size(), all.at("Energy of a pixel").size()) << name;
    }
    for (std::size_t i = 0; i < all.at("Energy of a pixel").size(); ++i)
        EXPECT_NEAR(all.at("Energy of a pixel")[i],
                    all.at("Sparse coding")[i] + all.at("Histogram")[i] + all.at("Low frequencies")[i] +
                        all.at("Spectrum")[i],
                    1e-9);
    const auto few = curvesOf(synthesise(
        request, brief({{"histogram", false}, {"low-pass", false}, {"spectrum", false}, {"scales", 1}})));
    EXPECT_FALSE(few.contains("Histogram"));
    EXPECT_FALSE(few.contains("Low frequencies"));
    EXPECT_FALSE(few.contains("Spectrum"));
    EXPECT_EQ(few.at("Energy of a pixel"), few.at("Sparse coding"));
}

TEST(Sparse, coloursComeCloserToTheExemplars) {
    for (const char* axes : {"pca", "channels"}) {
        const auto curves = curvesOf(synthesise(requestFor(blobs({48, 48}, 3), {56, 60}),
                                                brief({{"scales", 1}, {"colours", std::string(axes)}})));
        EXPECT_LT(curves.at("Histogram").back(), 0.5 * curves.at("Histogram").front());
    }
}

TEST(Sparse, anExemplarStaysAsItIsButForItsCoding) {
    const Image exemplar = blobs({48, 48}, 2);
    Request request = requestFor(exemplar, exemplar.size());
    request.inputs.set(kInitialPort, std::make_shared<const Image>(exemplar));
    const Synthesis result =
        synthesise(request, brief({{"scales", 1}, {"atoms", 200}, {"sparsity", 8}, {"iterations", 3}}));
    double variance = 0;
    const std::vector<double> means = channelMeans(exemplar);
    for (int c = 0; c < 2; ++c)
        variance += meanSquare(exemplar, constant({48, 48}, 2,
                                                  static_cast<float>(means[static_cast<std::size_t>(c)]))) /
                    2;
    EXPECT_LT(meanSquare(result.image, exemplar), 0.1 * variance);
    request.inputs.clear(kInitialPort);
    const Synthesis fresh =
        synthesise(request, brief({{"scales", 1}, {"atoms", 200}, {"sparsity", 8}, {"iterations", 3}}));
    EXPECT_GT(meanSquare(fresh.image, exemplar), meanSquare(result.image, exemplar));
}

TEST(Sparse, takesUpADictionaryAsThoughItHadLearntIt) {
    Request request = requestFor(blobs({48, 40}, 3), {60, 52});
    const Synthesis own = synthesise(request, kBrief);
    Values learning = kBrief;
    for (const char* name : {"spacing", "iterations"})
        learning.erase(name);
    const Synthesis learnt = runMethod("dictionary", request, learning);
    request.inputs.set(kDictionaryPort, learnt.outputs.at(kDictionaryPort).front());
    EXPECT_TRUE(samePixels(synthesise(request, kBrief).image, own.image));
    EXPECT_EQ(own.pictures.size(), learnt.pictures.size());
}

TEST(Sparse, goesOnFromACheckpoint) {
    const Request request = requestFor(blobs({64, 64}, 3), {128, 128});
    const Values settings = brief({{"iterations", 60}, {"gradient-steps", 12}, {"spectrum", true}});
    std::vector<Checkpoint> kept;
    JobOptions options;
    options.keep = [&](const Checkpoint& checkpoint) { kept.push_back(checkpoint); };
    const Synthesis whole = synthesise(request, settings, options);
    ASSERT_FALSE(kept.empty());
    for (const Checkpoint* from : {&kept.front(), &kept.back()}) {
        JobOptions resumed;
        resumed.resumed = std::make_shared<const Checkpoint>(*from);
        const Synthesis rest = synthesise(request, settings, resumed);
        EXPECT_TRUE(samePixels(rest.image, whole.image));
        EXPECT_EQ(curvesOf(rest), curvesOf(whole));
    }
}

void expectRefusal(const Request& request, const Values& settings, const char* words) {
    try {
        synthesise(request, settings);
        ADD_FAILURE() << "was taken: " << words;
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), HasSubstr(words));
    }
}

TEST(Sparse, refusesWhatMakesNoSenseInASentence) {
    const Request request = requestFor(blobs({40, 40}, 1), {50, 50});
    expectRefusal(request, brief({{"spacing", 9}}), "9 px");
    expectRefusal(request, {{"patch", 4}, {"spacing", 2}, {"sparsity", 17}}, "17");
    expectRefusal(requestFor(blobs({7, 40}, 1), {50, 50}), kBrief, "8 px");
    expectRefusal(request, brief({{"low-pass-target", std::string("exemplar")}}), "40 × 40");
}

TEST(Sparse, refusesADictionaryOfOtherPatchesOrChannels) {
    const Values learning = {{"patch", 10}, {"atoms", 20}, {"learning-iterations", 1}};
    Request request = requestFor(blobs({40, 40}, 1), {50, 50});
    request.inputs.set(kDictionaryPort,
                       runMethod("dictionary", request, learning).outputs.at(kDictionaryPort).front());
    expectRefusal(request, kBrief, "10 px");
    Request colour = requestFor(blobs({40, 40}, 3), {50, 50});
    colour.inputs = request.inputs;
    expectRefusal(colour, {{"patch", 10}, {"spacing", 5}}, "3");
}

TEST(Sparse, masksKeepWhatTheyHideOut) {
    Image exemplar = blobs({60, 48}, 1);
    Image mask = constant({60, 48}, 1, 1);
    for (int y = 0; y < 48; ++y)
        for (int x = 40; x < 60; ++x) {
            exemplar(x, y, 0) = 50;
            mask(x, y, 0) = 0;
        }
    Request request = requestFor(std::move(exemplar), {60, 48});
    request.exemplars.front().inputs.set(kMaskPort, std::make_shared<const Image>(std::move(mask)));
    EXPECT_LT(valueRange(synthesise(request, kBrief).image).largest, 3);
}

TEST(Sparse, smallOutputsAndExemplarsUseFewerScales) {
    const auto scales = [](const Synthesis& result) { return result.figures.front().value; };
    EXPECT_EQ(scales(synthesise(requestFor(blobs({64, 64}, 1), {40, 40}), kBrief)), 3);
    EXPECT_EQ(scales(synthesise(requestFor(blobs({40, 64}, 1), {40, 40}), kBrief)), 2);
    Request wrapped = requestFor(blobs({64, 64}, 1), {20, 90});
    wrapped.wrap = {true, false};
    EXPECT_EQ(scales(synthesise(wrapped, kBrief)), 1);
}

} // namespace
} // namespace texloom::test::sparse_tests
