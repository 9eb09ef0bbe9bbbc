#include "core/methods/conditional_gaussian/conditional_patch.h"
#include "core/methods/method.h"
#include "tests/support/method_run.h"
#include "tests/support/textures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace texloom::test::gaussian_tests {
namespace {

using testing::HasSubstr;

Image made(const char* id, const Request& request, const Values& settings) {
    return resultOf(findMethod(id), request, settings).image;
}

double largestDifference(const Image& a, const Image& b) {
    double largest = 0;
    for (int c = 0; c < a.channels(); ++c)
        for (int y = 0; y < a.height(); ++y)
            for (int x = 0; x < a.width(); ++x)
                largest = std::max(largest, std::abs(static_cast<double>(a(x, y, c) - b(x, y, c))));
    return largest;
}

TEST(Gaussian, periodicTexturesGoOnWithTheirPeriod) {
    // As many equal patches as neighbours: every Gaussian is a point.
    const Image exemplar = periodic({48, 45}, {8, 9}, 2);
    for (const char* id : {"locally-gaussian", "conditional-gaussian"})
        for (const char* stitch : {"cut", "average", "none"}) {
            Values settings = {{"patch", 18}, {"neighbours", 6}};
            if (id == std::string("locally-gaussian"))
                settings["stitch"] = std::string(stitch);
            else
                settings["sigma"] = 0.01;
            const Image image = made(id, requestOf(exemplar, {70, 61}), settings);
            for (int y = 0; y + 9 < 61; ++y)
                for (int x = 0; x + 8 < 70; ++x) {
                    ASSERT_NEAR(image(x, y, 0), image(x + 8, y, 0), 0.002) << id << " " << x << "," << y;
                    ASSERT_NEAR(image(x, y, 0), image(x, y + 9, 0), 0.002) << id << " " << x << "," << y;
                }
        }
}

TEST(Gaussian, replacingPatchesByTheirNearestGivesTheExemplarBack) {
    const Image exemplar = blobs({60, 52}, 3);
    const Image image =
        made("gaussian-patches", requestOf(exemplar, {60, 52}), {{"patch", 12}, {"neighbours", 1}});
    // The last patches reach beyond the exemplar, where it is mirrored and no patch is quite alike.
    EXPECT_LE(largestDifference(Image(image.view().crop(0, 0, {44, 36})),
                                Image(exemplar.view().crop(0, 0, {44, 36}))),
              1e-5);
}

TEST(Gaussian, moreNeighboursThanPatchesTakeAllThereAre) {
    const Image exemplar = blobs({20, 20}, 1);
    for (const char* id : {"gaussian-patches", "locally-gaussian", "conditional-gaussian"}) {
        const Image image = made(id, requestOf(exemplar, {50, 40}), {{"patch", 19}, {"neighbours", 300}});
        EXPECT_TRUE(std::isfinite(valueRange(image).largest)) << id;
    }
    const Image whole =
        made("locally-gaussian", requestOf(exemplar, {20, 20}), {{"patch", 20}, {"neighbours", 50}});
    EXPECT_LE(largestDifference(whole, exemplar), 1e-6);
}

TEST(Gaussian, patchesTooLargeForTheCoarsestScaleAreNamed) {
    EXPECT_THAT(refusalOf(findMethod("multiscale-gaussian"), requestOf(blobs({64, 60}, 3), {90, 90}),
                          {{"patch", 20}, {"scales", 3}}),
                testing::AllOf(HasSubstr("16 × 15 px"), HasSubstr("20 px")));
}

TEST(Gaussian, oneScaleIsLocallyGaussianWithAverages) {
    const Request request = requestOf(blobs({50, 50}, 3), {90, 70});
    const Image one =
        made("multiscale-gaussian", request,
             {{"patch", 16}, {"scales", 1}, {"neighbours", 7}, {"coarsest-stitch", std::string("average")}});
    const Image other = made("locally-gaussian", request,
                             {{"patch", 16}, {"stitch", std::string("average")}, {"neighbours", 7}});
    EXPECT_LE(largestDifference(one, other), 1e-6);
}

/// The mean deviation of squares of 8 × 8 px.
double localContrast(const Image& image) {
    double total = 0, count = 0;
    for (int top = 0; top + 8 <= image.height(); top += 8)
        for (int left = 0; left + 8 <= image.width(); left += 8, ++count) {
            double sum = 0, squares = 0;
            for (int y = top; y < top + 8; ++y)
                for (int x = left; x < left + 8; ++x) {
                    const auto value = static_cast<double>(image(x, y, 0));
                    sum += value / 64;
                    squares += value * value / 64;
                }
            total += std::sqrt(std::max(0.0, squares - sum * sum));
        }
    return total / count;
}

TEST(Gaussian, outputsDoNotFadeWhereNothingFits) {
    // Noise without any likeness, weaker in one half: the nearest patch is a weak one, whatever it shows.
    Image exemplar = noise({96, 96}, 1);
    for (int y = 0; y < 96; ++y)
        for (int x = 0; x < 48; ++x)
            exemplar(x, y, 0) = 0.5F + 0.2F * (exemplar(x, y, 0) - 0.5F);
    const Request request = requestOf(exemplar, {192, 192});
    const double wanted = localContrast(exemplar);
    for (const char* id : {"locally-gaussian", "multiscale-gaussian"}) {
        const auto contrast = [&](double share) {
            return localContrast(made(id, request, {{"patch", 16}, {"contrast", share}})) / wanted;
        };
        EXPECT_LT(contrast(0), 0.6) << id;
        EXPECT_GT(contrast(1), 0.6) << id;
    }
}

TEST(Gaussian, conditionedSamplesKeepTheContrastThatTheSourceLoses) {
    const Image exemplar = noise({96, 96}, 1);
    const auto contrast = [&](const Values& settings) {
        return localContrast(made("conditional-gaussian", requestOf(exemplar, {192, 192}), settings)) /
               localContrast(exemplar);
    };
    EXPECT_LT(contrast({{"patch", 16}, {"neighbours", 30}, {"border", 0}, {"contrast", 0.0}}), 0.6);
    EXPECT_GT(contrast({{"patch", 16}}), 0.75);
}

/// The least and the greatest lightness, and excess of the first channel over the mean of all.
std::pair<ValueRange, ValueRange> lightAndRed(const Image& image) {
    Image light(image.size(), 1), red(image.size(), 1);
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            for (int c = 0; c < image.channels(); ++c)
                light(x, y, 0) += image(x, y, c) / static_cast<float>(image.channels());
            red(x, y, 0) = image(x, y, 0) - light(x, y, 0);
        }
    return {valueRange(light), valueRange(red)};
}

TEST(Gaussian, boundedSamplesMakeNoSparksAndNoOppositeColours) {
    // Grey, with a few spots that are brighter and red.
    const Image random = noise({80, 80}, 2);
    Image exemplar({80, 80}, 3);
    for (int y = 0; y < 80; ++y)
        for (int x = 0; x < 80; ++x) {
            const bool spot = random(x / 4, y / 4, 0) > 0.85F;
            const float grey = 0.4F + 0.1F * random(x, y, 1);
            for (int c = 0; c < 3; ++c)
                exemplar(x, y, c) = spot && c == 0 ? grey + 0.4F : grey;
        }
    const auto [light, red] = lightAndRed(exemplar);
    const auto inside = [](const ValueRange& one, const ValueRange& all) {
        return one.smallest >= all.smallest - 1e-5F && one.largest <= all.largest + 1e-5F;
    };
    for (const bool bounded : {false, true}) {
        const auto [itsLight, itsRed] = lightAndRed(
            made("locally-gaussian", requestOf(exemplar, {160, 160}), {{"patch", 12}, {"bounded", bounded}}));
        EXPECT_EQ(inside(itsLight, light), bounded);
        EXPECT_EQ(inside(itsRed, red), bounded);
    }
}

TEST(Gaussian, finerScalesKeepTheCoarseLayout) {
    // Blocks far larger than the patch: only the coarse scale can know how they lie.
    Image exemplar = noise({128, 128}, 1);
    for (int y = 0; y < 128; ++y)
        for (int x = 0; x < 128; ++x)
            exemplar(x, y, 0) = 0.1F * exemplar(x, y, 0) + ((x / 32 + y / 32) % 2 == 0 ? 1.0F : 0.0F);
    const Image image = made("multiscale-gaussian", requestOf(exemplar, {192, 192}),
                             {{"patch", 16}, {"scales", 4}, {"neighbours", 4}});
    int opposite = 0, count = 0;
    for (int y = 0; y < 192; ++y)
        for (int x = 0; x + 32 < 192; ++x, ++count)
            opposite += (image(x, y, 0) > 0.55F) != (image(x + 32, y, 0) > 0.55F);
    EXPECT_GT(opposite, count * 7 / 10);
}

std::vector<ImageView> patchesOf(const Image& source, int patch, int count) {
    std::vector<ImageView> patches;
    for (int i = 0; i < count; ++i)
        patches.push_back(source.view().crop(3 * i, 2 * i, {patch, patch}));
    return patches;
}

TEST(ConditionalPatch, keepsTheOverlapAndContinuesAPatchOfTheModel) {
    const Image source = blobs({60, 60}, 2);
    const std::vector<ImageView> patches = patchesOf(source, 12, 6);
    Image known({12, 12}, 2), fresh({12, 12}, 2);
    const std::vector<double> weights = {0.2, -0.3, 0.5, 0.4, 0.1, 0.1};
    for (int c = 0; c < 2; ++c)
        for (int y = 0; y < 12; ++y)
            for (int x = 0; x < 12; ++x)
                for (std::size_t i = 0; i < patches.size(); ++i)
                    known(x, y, c) += static_cast<float>(weights[i]) * patches[i](x, y, c);
    const Image whole = known;
    const Overlap overlap{6, 6, 0, 0};
    for (const bool sampled : {false, true}) {
        const std::vector<double> normals = {0.5, -1, 2, 0.1, 1, -0.4};
        conditional_gaussian::conditionPatch(patches, known, overlap, {1e-7},
                                             sampled ? normals : std::vector<double>{}, fresh);
        EXPECT_LE(largestDifference(fresh, whole), 1e-4);
        EXPECT_EQ(fresh(3, 9, 1), known(3, 9, 1));
    }
}

TEST(ConditionalPatch, aBorderOfWhatIsThereIsAllThatIsContinued) {
    const Image source = noise({60, 60}, 2);
    const std::vector<ImageView> patches = patchesOf(source, 12, 6);
    const Image known(source.view().crop(40, 30, {12, 12}));
    const Overlap overlap{6, 6, 0, 0};
    const std::vector<double> normals = {0.5, -1, 2, 0.1, 1, -0.4};
    const auto drawn = [&](int changedX, int changedY, int border) {
        Image there = known, fresh({12, 12}, 2);
        there(changedX, changedY, 1) += 1;
        conditional_gaussian::conditionPatch(patches, there, overlap, {0.05, border}, normals, fresh);
        return Image(fresh.view().crop(6, 6, {6, 6}));
    };
    // Three pixels from what is drawn, and two.
    EXPECT_TRUE(samePixels(drawn(0, 0, 2), drawn(3, 8, 2)));
    EXPECT_FALSE(samePixels(drawn(0, 0, 2), drawn(4, 8, 2)));
    EXPECT_FALSE(samePixels(drawn(0, 0, 2), drawn(9, 4, 2)));
    EXPECT_FALSE(samePixels(drawn(0, 0, 3), drawn(3, 8, 3)));
    EXPECT_FALSE(samePixels(drawn(0, 0, 0), drawn(3, 8, 0)));
}

TEST(ConditionalPatch, equalPatchesGiveThatPatch) {
    const Image source = constant({40, 40}, 1, 0.5F);
    Image known = constant({12, 12}, 1, 0.5F), fresh({12, 12}, 1);
    conditional_gaussian::conditionPatch(patchesOf(source, 12, 4), known, {6, 0, 0, 0}, {}, {}, fresh);
    EXPECT_LE(largestDifference(fresh, known), 1e-6);
}

} // namespace
} // namespace texloom::test::gaussian_tests
