#include "core/math/anamorphosis.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace texloom::test {
namespace {

constexpr AnamorphosisKind kAlongOneAxis[] = {AnamorphosisKind::Affine, AnamorphosisKind::Parabola,
                                              AnamorphosisKind::Sinusoid};

constexpr AnamorphosisAxis kAcross = AnamorphosisAxis::X;

TEST(Anamorphosis, keepsTheEndsAndNeverTurnsRound) {
    for (const AnamorphosisKind kind : kAlongOneAxis)
        for (const AnamorphosisAxis axis : {AnamorphosisAxis::X, AnamorphosisAxis::Y})
            for (std::uint64_t seed = 0; seed < 10000; ++seed) {
                const double amplitude = 0.95 * static_cast<double>(seed % 20 + 1) / 20;
                const AnamorphosisOptions options{kind, axis, amplitude, static_cast<int>(seed % 16) + 1, 8};
                const Anamorphosis warp({200, 200}, options, {}, Random(seed));
                ASSERT_NEAR(warp.along(0), 0, 1e-12);
                ASSERT_NEAR(warp.along(200), 200, 1e-12);
                for (int i = 0; i < 40; ++i) {
                    const double at = 5 * i + 2.5, slope = (warp.along(at + 0.01) - warp.along(at)) / 0.01;
                    ASSERT_GT(slope, 1 - amplitude - 1e-9) << seed;
                    ASSERT_LT(slope, 1 + amplitude + 1e-9) << seed;
                    ASSERT_GE(warp.jacobian({at, at}).determinant(), warp.leastDeterminant() - 1e-12);
                }
            }
}

TEST(Anamorphosis, areTheCurvesThatTheyAreSaidToBe) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const Anamorphosis parabola({100, 10}, {AnamorphosisKind::Parabola, kAcross, 0.8}, {}, Random(seed));
        const double sign = parabola.along(50) > 50 ? 1 : -1;
        EXPECT_NEAR(parabola.along(30), 100 * (0.3 + sign * 0.8 * 0.3 * 0.7), 1e-9);
        const Anamorphosis sinusoid({100, 10}, {AnamorphosisKind::Sinusoid, kAcross, 0.5, 2}, {},
                                    Random(seed));
        const double pi = 3.14159265358979;
        const double up = sinusoid.along(5) > 5 ? 1 : -1;
        EXPECT_NEAR(sinusoid.along(30), 100 * (0.3 + up * 0.5 / (4 * pi) * std::sin(4 * pi * 0.3)), 1e-9);
        // Two straight pieces: a second difference at the knot alone, where the map is c + a c (1 − c).
        const Anamorphosis affine({1000, 10}, {AnamorphosisKind::Affine, kAcross, 0.6}, {}, Random(seed));
        int bends = 0;
        for (int x = 1; x < 1000; ++x)
            if (std::abs(affine.along(x - 1) + affine.along(x + 1) - 2 * affine.along(x)) > 1e-6) {
                const double c = x / 1000.0;
                EXPECT_GT(c, 0.298);
                EXPECT_LT(c, 0.702);
                EXPECT_NEAR(std::abs(affine.along(x) / 1000 - c), 0.6 * c * (1 - c), 2e-3);
                ++bends;
            }
        EXPECT_GE(bends, 1);
        EXPECT_LE(bends, 2);
    }
}

TEST(Anamorphosis, turbulenceNeverFoldsForTenThousandSeeds) {
    int lowered = 0;
    for (std::uint64_t seed = 0; seed < 10000; ++seed) {
        const AnamorphosisOptions options{AnamorphosisKind::Turbulence, kAcross, 0.95, 1, 12};
        const Wrap wrap{seed % 2 == 1, seed % 4 > 1};
        const Anamorphosis warp({60, 48}, options, wrap, Random(seed));
        ASSERT_GT(warp.leastDeterminant(), 0.1) << seed;
        lowered += warp.amplitude() < 0.95 ? 1 : 0;
        std::vector<PlanePoint> points(60);
        std::vector<Eigen::Matrix2d> jacobians(60);
        for (double y = 0.5; y < 48; y += 3) {
            warp.row(0.5, y, 60, points.data(), jacobians.data());
            for (const Eigen::Matrix2d& jacobian : jacobians)
                ASSERT_GE(jacobian.determinant(), warp.leastDeterminant() - 1e-12) << seed;
        }
    }
    EXPECT_GT(lowered, 5000); // so that the limit was put to the test
}

TEST(Anamorphosis, jacobiansAreThoseOfTheMap) {
    for (const AnamorphosisKind kind :
         {AnamorphosisKind::Parabola, AnamorphosisKind::Sinusoid, AnamorphosisKind::Turbulence}) {
        const Anamorphosis warp({90, 70}, {kind, AnamorphosisAxis::Y, 0.7, 3, 10}, {}, Random(7));
        for (double y = 2; y < 68; y += 4.3)
            for (double x = 2; x < 88; x += 4.7) {
                const double h = 1e-5;
                const PlanePoint left = warp.toSource({x - h, y}), right = warp.toSource({x + h, y});
                const PlanePoint above = warp.toSource({x, y - h}), below = warp.toSource({x, y + h});
                const Eigen::Matrix2d jacobian = warp.jacobian({x, y});
                EXPECT_NEAR(jacobian(0, 0), (right.x - left.x) / (2 * h), 1e-6);
                EXPECT_NEAR(jacobian(1, 0), (right.y - left.y) / (2 * h), 1e-6);
                EXPECT_NEAR(jacobian(0, 1), (below.x - above.x) / (2 * h), 1e-6);
                EXPECT_NEAR(jacobian(1, 1), (below.y - above.y) / (2 * h), 1e-6);
            }
    }
}

TEST(Anamorphosis, turbulenceHasTheDeviationAskedFor) {
    const double amplitude = 0.05, scale = 10; // too weak to fold
    const Anamorphosis warp({600, 500}, {AnamorphosisKind::Turbulence, kAcross, amplitude, 1, scale}, {},
                            Random(3));
    EXPECT_EQ(warp.amplitude(), amplitude);
    double squares = 0, count = 0;
    for (double y = 0.5; y < 500; y += 2)
        for (double x = 0.5; x < 600; x += 2) {
            const PlanePoint from = warp.toSource({x, y});
            squares += (from.x - x) * (from.x - x) + (from.y - y) * (from.y - y);
            count += 2;
        }
    EXPECT_NEAR(std::sqrt(squares / count), amplitude * scale, 0.1 * amplitude * scale);
}

TEST(Anamorphosis, whatWrapsRepeatsWithThePlane) {
    for (const Size size : {Size{96, 80}, Size{4000, 60}, Size{7, 5}})
        for (const AnamorphosisKind kind : {AnamorphosisKind::Sinusoid, AnamorphosisKind::Turbulence}) {
            const Anamorphosis warp(size, {kind, kAcross, 0.8, 3, 6}, {true, true}, Random(11));
            for (double x = 0.25; x < size.width; x += size.width / 13.0) {
                const PlanePoint one = warp.toSource({x, 2}),
                                 round = warp.toSource({x + size.width, 2.0 + size.height});
                EXPECT_NEAR(round.x - size.width, one.x, 1e-9);
                EXPECT_NEAR(round.y - size.height, one.y, 1e-9);
            }
        }
}

TEST(Anamorphosis, withoutAmplitudeNothingMovesByABit) {
    for (const AnamorphosisKind kind : {AnamorphosisKind::Affine, AnamorphosisKind::Parabola,
                                        AnamorphosisKind::Sinusoid, AnamorphosisKind::Turbulence}) {
        const Anamorphosis warp({300, 200}, {kind, kAcross, 0, 3, 20}, {}, Random(5));
        for (int x = 0; x < 300; ++x)
            ASSERT_EQ(warp.toSource({x + 0.5, 17.5}), (PlanePoint{x + 0.5, 17.5}));
    }
}

} // namespace
} // namespace texloom::test
