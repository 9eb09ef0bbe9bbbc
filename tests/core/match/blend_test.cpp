#include "core/base/error.h"
#include "core/match/blend.h"
#include "core/match/patch_stitch.h"
#include "tests/support/textures.h"

#include <gtest/gtest.h>

#include <cmath>

namespace texloom::test {
namespace {

constexpr Size kSize{90, 80};
constexpr int kBand = 12;

std::vector<BlendCurve> curves() {
    return {BlendCurve::horizontal(kSize, 37), BlendCurve::vertical(kSize, 41),
            BlendCurve::circular(kSize, 45)};
}

/// blendAlong() within a job that nobody watches.
Image blended(const ImageView& first, const ImageView& second, const BlendCurve& curve,
              const BlendOptions& options) {
    JobMonitor monitor;
    JobContext context(
        {0, 1, false}, [] { return false; }, monitor);
    return blendAlong(first, second, curve, options, context);
}

std::vector<BlendOptions> ways() {
    std::vector<BlendOptions> all = {
        {BlendMethod::Cut, kBand, {}}, {BlendMethod::Poisson, kBand, {}}, {BlendMethod::Edge, kBand, {}}};
    for (const Propagation propagation : {Propagation::Linear, Propagation::Progressive})
        for (const BlendColor color : {BlendColor::Rgb, BlendColor::Dct, BlendColor::Pca})
            all.push_back({BlendMethod::Midway, kBand, {propagation, color}});
    return all;
}

TEST(Blend, nothingChangesBeyondTheBand) {
    const Image a = blobs(kSize, 3, 1), b = blobs(kSize, 3, 2);
    for (const BlendCurve& curve : curves())
        for (const BlendOptions& way : ways()) {
            const Image result = blended(a, b, curve, way);
            for (int y = 0; y < kSize.height; ++y)
                for (int x = 0; x < kSize.width; ++x) {
                    const double across = curve.placeOf({x + 0.5, y + 0.5}).across;
                    if (std::abs(across) < kBand)
                        continue;
                    ASSERT_EQ(result(x, y, 1), (across < 0 ? a : b)(x, y, 1)) << x << "," << y;
                }
        }
}

TEST(Blend, anImageWithItselfStaysAsItIs) {
    const Image a = blobs(kSize, 3, 1);
    for (const BlendCurve& curve : curves())
        for (const BlendOptions& way : ways()) {
            if (way.midway.propagation == Propagation::Progressive)
                continue; // it draws the band anew from its borders
            const Image result = blended(a, a, curve, way);
            for (int y = 0; y < kSize.height; ++y)
                for (int x = 0; x < kSize.width; ++x)
                    ASSERT_NEAR(result(x, y, 2), a(x, y, 2), 2e-5)
                        << x << "," << y << " method " << static_cast<int>(way.method) << " colour "
                        << static_cast<int>(way.midway.color);
        }
}

TEST(Blend, anEdgeLeavesBothAsTheyAre) {
    const Image a = blobs(kSize, 3, 1), b = blobs(kSize, 3, 2);
    for (const BlendCurve& curve : curves()) {
        const Image result = blended(a, b, curve, {BlendMethod::Edge, kBand, {}});
        for (int y = 0; y < kSize.height; ++y)
            for (int x = 0; x < kSize.width; ++x) {
                const double across = curve.placeOf({x + 0.5, y + 0.5}).across;
                ASSERT_EQ(result(x, y, 1), (across > 0 ? b : a)(x, y, 1)) << x << "," << y;
            }
    }
}

/// Stripes across the curve, those of the second picture shifted.
Image stripes(int shift) {
    Image image(kSize, 1);
    for (int y = 0; y < kSize.height; ++y)
        for (int x = 0; x < kSize.width; ++x)
            image(x, y, 0) = x >= 30 + shift && x < 40 + shift ? 1.0F : 0.0F;
    return image;
}

TEST(Blend, midwayBringsShiftedStripesTogetherHalfWay) {
    for (const Propagation propagation : {Propagation::Linear, Propagation::Progressive}) {
        const Image result = blended(stripes(0), stripes(8), BlendCurve::horizontal(kSize, 40),
                                     {BlendMethod::Midway, kBand, {propagation, BlendColor::Rgb}});
        const auto centre = [&](int y) {
            double sum = 0, mass = 0;
            for (int x = 0; x < kSize.width; ++x) {
                sum += (x + 0.5) * static_cast<double>(result(x, y, 0));
                mass += static_cast<double>(result(x, y, 0));
            }
            EXPECT_NEAR(mass, 10, 1e-3) << "row " << y;
            return sum / mass;
        };
        EXPECT_NEAR(centre(40), 39, 0.01);
        EXPECT_NEAR(centre(40 - kBand), 35, 0.01);
        EXPECT_NEAR(centre(40 - kBand / 2), 37, 0.3);
        EXPECT_NEAR(centre(40 + kBand / 2), 41, 0.3);
        EXPECT_NEAR(centre(40 + kBand), 43, 0.01);
    }
}

TEST(Blend, midwayLinesOfBothSidesAgreeOnTheCurve) {
    // With the curve on row 37, that row is the same whichever picture lies above, if both have the least
    // value.
    Image a = blobs(kSize, 3, 1), b = blobs(kSize, 3, 2);
    for (int c = 0; c < 3; ++c)
        a(5, 37, c) = b(5, 37, c) = -1;
    const BlendOptions way{BlendMethod::Midway, kBand, {Propagation::Linear, BlendColor::Rgb}};
    const Image one = blended(a, b, BlendCurve::horizontal(kSize, 37), way);
    const Image other = blended(b, a, BlendCurve::horizontal(kSize, 37), way);
    for (int x = 0; x < kSize.width; ++x)
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(one(x, 37, c), other(x, 37, c), 2e-5) << x;
}

TEST(Blend, poissonHidesAStepOfBrightness) {
    Image a = blobs(kSize, 1, 1), b = a;
    for (int y = 0; y < kSize.height; ++y)
        for (int x = 0; x < kSize.width; ++x)
            b(x, y, 0) += 1;
    const Image result = blended(a, b, BlendCurve::horizontal(kSize, 40), {BlendMethod::Poisson, kBand, {}});
    for (int y = 41 - kBand; y < 40 + kBand; ++y)
        for (int x = 0; x < kSize.width; ++x)
            EXPECT_NEAR(result(x, y, 0) - a(x, y, 0), (y - 40.0 + kBand) / (2 * kBand), 1e-3) << y;
}

TEST(Blend, canBeStoppedAllTheWay) {
    const Image a = blobs({320, 300}, 3, 1), b = blobs({320, 300}, 3, 2);
    for (const BlendMethod method : {BlendMethod::Cut, BlendMethod::Poisson, BlendMethod::Midway}) {
        const BlendOptions way{method, 100, {Propagation::Progressive, BlendColor::Pca}};
        const auto checksUntil = [&](int stop) {
            int checks = 0;
            JobMonitor monitor;
            JobContext context(
                {0, 1, false}, [&] { return ++checks > stop; }, monitor);
            try {
                blendAlong(a, b, BlendCurve::vertical({320, 300}, 160), way, context);
            } catch (const Cancelled&) {
                return -checks;
            }
            EXPECT_EQ(monitor.progress(), 1);
            return checks;
        };
        const int all = checksUntil(1 << 30);
        EXPECT_GT(all, 400) << static_cast<int>(method);
        for (const int stop : {0, all / 3, all - 1})
            EXPECT_EQ(checksUntil(stop), -stop - 1) << static_cast<int>(method);
    }
}

TEST(Blend, imagesThatDifferInSizeAreRefused) {
    EXPECT_THROW(blended(blobs({20, 20}, 3), blobs({20, 21}, 3), BlendCurve::horizontal({20, 20}, 9), {}),
                 UsageError);
    EXPECT_THROW(blended(blobs({20, 20}, 3), blobs({20, 20}, 1), BlendCurve::horizontal({20, 20}, 9), {}),
                 UsageError);
}

TEST(BlendCurve, placesAndPointsAreInverse) {
    std::vector<BlendCurve> all = curves();
    for (const Overlap& overlap :
         {Overlap{8, 8, 0, 0}, Overlap{8, 6, 8, 0}, Overlap{8, 8, 8, 8}, Overlap{8, 0, 8, 0}})
        for (const BlendCurve& curve : BlendCurve::around(overlap, 32))
            all.push_back(curve);
    for (const BlendCurve& curve : all)
        for (double along = 0.3; along < curve.length(); along += 1.7)
            for (const double across : {-2.0, 0.0, 1.5}) {
                const BlendCurve::Place place = curve.placeOf(curve.pointAt({along, across}));
                EXPECT_NEAR(place.along, along, 1e-6);
                EXPECT_NEAR(place.across, across, 1e-6);
            }
}

TEST(PatchStitcher, oldPixelsBeyondTheOverlapAreNeverUsed) {
    constexpr int kPatch = 24;
    for (const PatchStitch stitch :
         {PatchStitch::Cut, PatchStitch::SmoothCut, PatchStitch::Average, PatchStitch::None,
          PatchStitch::Poisson, PatchStitch::Midway, PatchStitch::Feather})
        for (const Overlap& overlap : {Overlap{8, 0, 0, 0}, Overlap{0, 7, 0, 0}, Overlap{8, 8, 0, 0},
                                       Overlap{12, 12, 0, 0}, Overlap{6, 0, 6, 0}, Overlap{6, 8, 6, 0},
                                       Overlap{6, 6, 7, 7}, Overlap{0, 6, 0, 6}, Overlap{2, 2, 0, 0}}) {
            Image old = blobs({kPatch, kPatch}, 3, 4), fresh = blobs({kPatch, kPatch}, 3, 5);
            for (int y = 0; y < kPatch; ++y)
                for (int x = 0; x < kPatch; ++x)
                    if (!overlap.contains(x, y, kPatch))
                        old(x, y, 1) = 1000;
            PatchStitcher stitcher(stitch, kPatch);
            stitcher.prepare(overlap);
            PatchStitcher::Scratch scratch = stitcher.scratch();
            stitcher.join(old, overlap, fresh, scratch);
            EXPECT_LT(valueRange(fresh).largest, 20)
                << static_cast<int>(stitch) << " overlap " << overlap.left << overlap.top << overlap.right
                << overlap.bottom;
        }
}

Image stitched(PatchStitch stitch, const Overlap& overlap, const Image& old, const Image& fresh) {
    PatchStitcher stitcher(stitch, fresh.width());
    stitcher.prepare(overlap);
    PatchStitcher::Scratch scratch = stitcher.scratch();
    Image joined(fresh);
    stitcher.join(old, overlap, joined, scratch);
    return joined;
}

const std::vector<Overlap> kSomeOverlaps = {{8, 0, 0, 0}, {0, 7, 0, 0}, {8, 8, 0, 0},    {6, 8, 6, 0},
                                            {6, 6, 7, 7}, {1, 2, 0, 0}, {12, 12, 12, 12}};

TEST(PatchStitcher, equalPatchesStayAsTheyAre) {
    const Image patch = blobs({24, 24}, 3);
    for (const PatchStitch stitch : {PatchStitch::Cut, PatchStitch::SmoothCut, PatchStitch::Average,
                                     PatchStitch::None, PatchStitch::Feather})
        for (const Overlap& overlap : kSomeOverlaps)
            EXPECT_TRUE(samePixels(stitched(stitch, overlap, patch, patch), patch));
    // Blending solves equations, which rounds.
    const Image solved = stitched(PatchStitch::Poisson, {8, 8, 0, 0}, patch, patch);
    for (int y = 0; y < 24; ++y)
        for (int x = 0; x < 24; ++x)
            EXPECT_NEAR(solved(x, y, 1), patch(x, y, 1), 1e-5F);
}

TEST(PatchStitcher, sharesOfTheOldAndTheNewPixelAddToOne) {
    const Image none = constant({24, 24}, 1, 0), all = constant({24, 24}, 1, 1);
    for (const PatchStitch stitch : {PatchStitch::Average, PatchStitch::None, PatchStitch::Feather})
        for (const Overlap& overlap : kSomeOverlaps) {
            Image share({24, 24}, 1);
            PatchStitcher(stitch, 24).shares(overlap, share.plane(0));
            const Image old = stitched(stitch, overlap, all, none),
                        fresh = stitched(stitch, overlap, none, all);
            for (int y = 0; y < 24; ++y)
                for (int x = 0; x < 24; ++x) {
                    EXPECT_FLOAT_EQ(old(x, y, 0) + fresh(x, y, 0), 1);
                    EXPECT_FLOAT_EQ(old(x, y, 0), share(x, y, 0));
                    EXPECT_GE(share(x, y, 0), 0);
                    EXPECT_LE(share(x, y, 0), overlap.contains(x, y, 24) ? 1 : 0);
                }
        }
}

TEST(PatchStitcher, featherOfAStepIsARampOverTheOverlap) {
    const Image low = constant({24, 24}, 1, 3), high = constant({24, 24}, 1, 10);
    for (const int width : {2, 5, 12}) {
        const Image left = stitched(PatchStitch::Feather, {width, 0, 0, 0}, low, high);
        const Image corner = stitched(PatchStitch::Feather, {width, 12, 0, 0}, low, high);
        for (int y = 0; y < 24; ++y)
            for (int x = 0; x < 24; ++x) {
                const auto ramp = [](int at, int over) {
                    return at < over ? static_cast<float>(at) / static_cast<float>(over - 1) : 1.0F;
                };
                EXPECT_NEAR(left(x, y, 0), 3 + 7 * ramp(x, width), 1e-5F);
                EXPECT_NEAR(corner(x, y, 0), 3 + 7 * ramp(x, width) * ramp(y, 12), 1e-5F);
            }
    }
}

TEST(PatchStitcher, blendedPatchesHaveTheSourceOfTheirSide) {
    Image share({24, 24}, 1);
    for (const PatchStitch stitch : {PatchStitch::Poisson, PatchStitch::Midway}) {
        PatchStitcher stitcher(stitch, 24);
        const Overlap overlap{8, 0, 8, 0};
        stitcher.prepare(overlap);
        stitcher.shares(overlap, share.plane(0));
        for (int y = 0; y < 24; ++y)
            for (int x = 0; x < 24; ++x)
                if (x != 3 && x != 4 && x != 19 && x != 20) { // the curves run through these
                    EXPECT_EQ(share(x, y, 0), x < 4 || x > 19 ? 1 : 0) << x;
                }
    }
}

} // namespace
} // namespace texloom::test
