#include "core/image/mirror.h"
#include "core/tools/join_region.h"
#include "core/tools/tool.h"
#include "tests/core/refusal.h"
#include "tests/support/textures.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

/// Mixing and cloning by gradients (Pérez, Gangnet & Blake 2003; Raad, thesis 2016, section 5.8).
namespace texloom::test {
namespace {

constexpr Size kPictureSize{53, 40};
constexpr double kResidual = 1e-5;

Image joinedBy(const char* tool, const JoinPictures& pictures, const Values& settings) {
    JobMonitor monitor;
    JobContext context(
        {}, [] { return false; }, monitor);
    return findTool(tool).joined(pictures, findTool(tool).resolved(settings), context);
}

double laplacian(const ImageView& f, int x, int y, int c, bool wraps = false) {
    double sum = 0;
    for (const auto& [dx, dy] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}}) {
        const int u = wraps ? repeated(x + dx, f.width) : std::clamp(x + dx, 0, f.width - 1);
        const int v = wraps ? repeated(y + dy, f.height) : std::clamp(y + dy, 0, f.height - 1);
        sum += static_cast<double>(f(u, v, c)) - static_cast<double>(f(x, y, c));
    }
    return sum;
}

double largestDifference(const ImageView& a, const ImageView& b) {
    double most = 0;
    for (int c = 0; c < a.channels; ++c)
        for (int y = 0; y < a.height; ++y)
            for (int x = 0; x < a.width; ++x)
                most = std::max(most,
                                std::abs(static_cast<double>(a(x, y, c)) - static_cast<double>(b(x, y, c))));
    return most;
}

/// Equation 5.1, pixel by pixel: the gradient chosen at one pixel for one channel.
class Chosen {
public:
    Chosen(const Image& first, const Image& second, double preference, bool perChannel, bool wraps)
        : m_first(first), m_second(second), m_preference(preference), m_perChannel(perChannel),
          m_wraps(wraps) {}

    double divergence(int x, int y, int c) const {
        return at(x, y, c).first - before(x - 1, y, c).first + at(x, y, c).second -
               before(x, y - 1, c).second;
    }

private:
    using Gradient = std::pair<double, double>;

    Gradient before(int x, int y, int c) const {
        if (!m_wraps && (x < 0 || y < 0))
            return {0, 0};
        return at(repeated(x, m_first.width()), repeated(y, m_first.height()), c);
    }
    Gradient of(const Image& image, int x, int y, int c) const {
        const int u = m_wraps ? repeated(x + 1, image.width()) : std::min(x + 1, image.width() - 1);
        const int v = m_wraps ? repeated(y + 1, image.height()) : std::min(y + 1, image.height() - 1);
        const auto here = static_cast<double>(image(x, y, c));
        return {static_cast<double>(image(u, y, c)) - here, static_cast<double>(image(x, v, c)) - here};
    }
    Gradient at(int x, int y, int c) const {
        double one = 0, two = 0;
        for (int k = m_perChannel ? c : 0; k < (m_perChannel ? c + 1 : m_first.channels()); ++k) {
            const Gradient a = of(m_first, x, y, k), b = of(m_second, x, y, k);
            one += a.first * a.first + a.second * a.second;
            two += b.first * b.first + b.second * b.second;
        }
        return of(m_preference * std::sqrt(one) >= std::sqrt(two) ? m_first : m_second, x, y, c);
    }

    const Image& m_first;
    const Image& m_second;
    double m_preference;
    bool m_perChannel, m_wraps;
};

/// A mask that is black on a disc.
Image disc(Size size, double x, double y, double radius) {
    Image mask(size, 1);
    for (int v = 0; v < size.height; ++v)
        for (int u = 0; u < size.width; ++u)
            mask(u, v, 0) = std::hypot(u - x, v - y) < radius ? 0.0F : 1.0F;
    return mask;
}

Image constant(float value) {
    Image image(kPictureSize, 3);
    for (int c = 0; c < 3; ++c)
        for (int y = 0; y < kPictureSize.height; ++y)
            std::fill_n(image.plane(c).row(y), kPictureSize.width, value);
    return image;
}

} // namespace

TEST(PoissonMix, TheResultHasTheGradientsThatEquation51Chooses) {
    const Image first = blobs(kPictureSize, 3, 1), second = noise(kPictureSize, 3, 2);
    for (const char* border : {"free", "wrap", "first"})
        for (const bool perChannel : {false, true})
            for (const double preference : {1.0, 3.0}) {
                const bool wraps = std::string(border) == "wrap", fixed = std::string(border) == "first";
                const Image made = joinedBy("poisson-mix", {first, second},
                                            {{"border", std::string(border)},
                                             {"per-channel", perChannel},
                                             {"preference", preference}});
                const Chosen chosen(first, second, preference, perChannel, wraps);
                const int edge = fixed ? 1 : 0;
                for (int c = 0; c < 3; ++c)
                    for (int y = edge; y < kPictureSize.height - edge; ++y)
                        for (int x = edge; x < kPictureSize.width - edge; ++x)
                            ASSERT_NEAR(laplacian(made, x, y, c, wraps), chosen.divergence(x, y, c),
                                        kResidual)
                                << border << " " << x << ", " << y;
                if (!fixed) {
                    for (std::size_t c = 0; c < 3; ++c)
                        EXPECT_NEAR(channelMeans(made)[c], channelMeans(first)[c], 1e-6);
                } else {
                    EXPECT_EQ(made(0, 7, 1), first(0, 7, 1));
                    EXPECT_EQ(made(kPictureSize.width - 1, kPictureSize.height - 1, 2),
                              first(kPictureSize.width - 1, kPictureSize.height - 1, 2));
                }
            }
}

TEST(PoissonMix, WithAConstantOrItselfTheFirstStays) {
    const Image first = noise(kPictureSize, 3, 1);
    for (const char* border : {"free", "wrap", "first"}) {
        const Values values = {{"border", std::string(border)}};
        EXPECT_LT(largestDifference(joinedBy("poisson-mix", {first, constant(0.3F)}, values), first), 1e-5);
        EXPECT_LT(largestDifference(joinedBy("poisson-mix", {first, first}, values), first), 1e-5);
    }
}

TEST(PoissonMix, SwappedOnlyTheMeanChanges) {
    const Image first = blobs(kPictureSize, 3, 1), second = noise(kPictureSize, 3, 2);
    const Image one = joinedBy("poisson-mix", {first, second}, {}),
                two = joinedBy("poisson-mix", {second, first}, {});
    for (int c = 0; c < 3; ++c) {
        const double mean =
            channelMeans(one)[static_cast<std::size_t>(c)] - channelMeans(two)[static_cast<std::size_t>(c)];
        EXPECT_GT(std::abs(mean), 1e-4);
        for (int y = 0; y < kPictureSize.height; ++y)
            for (int x = 0; x < kPictureSize.width; ++x)
                ASSERT_NEAR(one(x, y, c) - two(x, y, c), mean, 2e-5);
    }
}

TEST(PoissonMix, OnATorusItMovesWithThePictures) {
    const auto shifted = [](const Image& image) {
        Image moved(image.size(), image.channels());
        for (int c = 0; c < image.channels(); ++c)
            for (int y = 0; y < image.height(); ++y)
                for (int x = 0; x < image.width(); ++x)
                    moved(repeated(x + 19, image.width()), repeated(y + 8, image.height()), c) =
                        image(x, y, c);
        return moved;
    };
    const Image first = blobs(kPictureSize, 2, 1), second = noise(kPictureSize, 2, 2);
    const Values wrap = {{"border", std::string("wrap")}};
    EXPECT_LT(largestDifference(joinedBy("poisson-mix", {shifted(first), shifted(second)}, wrap),
                                shifted(joinedBy("poisson-mix", {first, second}, wrap))),
              2e-5);
}

TEST(PoissonMix, OneRowOrColumnIsMixed) {
    for (const Size size : {Size{9, 1}, Size{1, 9}, Size{1, 1}, Size{2, 2}})
        for (const char* border : {"free", "wrap", "first"}) {
            const Image first = noise(size, 1, 1);
            EXPECT_LT(largestDifference(
                          joinedBy("poisson-mix", {first, first}, {{"border", std::string(border)}}), first),
                      1e-5);
        }
}

TEST(PoissonClone, InTheRegionTheSecondsStructureOutsideTheFirstToTheBit) {
    const Image first = blobs(kPictureSize, 3, 1), second = noise({70, 61}, 3, 2);
    // Within the first picture, and over its left and upper border.
    for (const auto& [dx, dy] : {std::pair{-11, -9}, {-33, -28}}) {
        const Image mask = disc(second.size(), 35, 30, 9);
        const Image made =
            joinedBy("poisson-clone", {first, second, &mask}, {{"offset-x", dx}, {"offset-y", dy}});
        int inside = 0;
        for (int y = 0; y < kPictureSize.height; ++y)
            for (int x = 0; x < kPictureSize.width; ++x) {
                const bool cloned = x - dx < 70 && y - dy < 61 && mask(x - dx, y - dy, 0) == 0;
                inside += cloned ? 1 : 0;
                for (int c = 0; c < 3; ++c) {
                    if (!cloned) {
                        ASSERT_EQ(made(x, y, c), first(x, y, c));
                        continue;
                    }
                    double wanted = 0;
                    for (const auto& [u, v] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}})
                        if (x + u >= 0 && y + v >= 0)
                            wanted += static_cast<double>(second(x - dx + u, y - dy + v, c)) -
                                      static_cast<double>(second(x - dx, y - dy, c));
                    ASSERT_NEAR(laplacian(made, x, y, c), wanted, kResidual) << x << ", " << y;
                }
            }
        EXPECT_GT(inside, 60);
    }
}

TEST(PoissonClone, WhatIsClonedOverItselfStays) {
    const Image image = noise(kPictureSize, 3, 4);
    for (const char* mode : {"replace", "mix", "paste"})
        EXPECT_LT(largestDifference(joinedBy("poisson-clone", {image, image}, {{"mode", std::string(mode)}}),
                                    image),
                  1e-5);
}

TEST(PoissonClone, OfAConstantTheRegionIsHarmonicAndMixedTheFirst) {
    const Image first = noise(kPictureSize, 3, 4), plain = constant(0.9F);
    const Image made = joinedBy("poisson-clone", {first, plain}, {});
    const Region middle = middleRegion(kPictureSize);
    EXPECT_EQ(middle, (Region{13, 10, {26, 20}}));
    for (int y = middle.y; y < middle.bottom(); ++y)
        for (int x = middle.x; x < middle.right(); ++x)
            ASSERT_NEAR(laplacian(made, x, y, 1), 0, kResidual);
    EXPECT_LT(
        largestDifference(joinedBy("poisson-clone", {first, plain}, {{"mode", std::string("mix")}}), first),
        1e-5);
}

TEST(PoissonClone, MixedItHasTheStrongerGradients) {
    const Image first = blobs(kPictureSize, 3, 1), second = noise(kPictureSize, 3, 2),
                mask = disc(kPictureSize, 26, 20, 12);
    const Image made = joinedBy("poisson-clone", {first, second, &mask},
                                {{"mode", std::string("mix")}, {"preference", 2.0}});
    const Chosen chosen(first, second, 2, false, false);
    for (int y = 0; y < kPictureSize.height; ++y)
        for (int x = 0; x < kPictureSize.width; ++x)
            if (mask(x, y, 0) == 0) {
                ASSERT_NEAR(laplacian(made, x, y, 0), chosen.divergence(x, y, 0), kResidual);
            }
}

TEST(PoissonClone, PastedThePixelsAreThoseOfTheSecond) {
    const Image first = blobs(kPictureSize, 3, 1), second = noise(kPictureSize, 3, 2),
                mask = disc(kPictureSize, 26, 20, 8);
    const Image made = joinedBy("poisson-clone", {first, second, &mask},
                                {{"mode", std::string("paste")}, {"offset-x", 20}, {"offset-y", 3}});
    for (int y = 0; y < kPictureSize.height; ++y)
        for (int x = 0; x < kPictureSize.width; ++x) {
            const bool cloned = x >= 20 && y >= 3 && mask(x - 20, y - 3, 0) == 0;
            ASSERT_EQ(made(x, y, 2), cloned ? second(x - 20, y - 3, 2) : first(x, y, 2));
        }
}

TEST(PoissonClone, RefusesARegionOutsideOrOverAllOfTheFirst) {
    const Image image = noise(kPictureSize, 3, 4), all(kPictureSize, 1);
    const auto cloned = [&](const Image* mask, int right) {
        return [&image, mask, right] {
            joinedBy("poisson-clone", {image, image, mask}, {{"offset-x", right}});
        };
    };
    EXPECT_THAT(cloned(nullptr, 53), usageRefusal("53, 0", "53 × 40"));
    EXPECT_THAT(cloned(&all, 0), usageRefusal("covers", "53 × 40"));
    EXPECT_NO_THROW(cloned(&all, 1)());
}

} // namespace texloom::test
