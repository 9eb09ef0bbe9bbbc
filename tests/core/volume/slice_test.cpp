#include "core/volume/slice.h"
#include "tests/core/refusal.h"
#include "tests/support/volumes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numbers>

namespace texloom::test {

namespace {

using Eigen::Vector3d;

constexpr double kPi = std::numbers::pi;

/// Linear in the place, so that linear interpolation of it is exact.
double ramp(const Vector3d& place) {
    return 0.001 * place.x() - 0.002 * place.y() + 0.003 * place.z() + 0.5;
}

const FunctionSource kRamp([](std::int64_t x, std::int64_t y, std::int64_t z, int) {
    return ramp({static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)});
});

/// Every voxel different, without any order.
const FunctionSource kChaos(
    [](std::int64_t x, std::int64_t y, std::int64_t z, int c) {
        return static_cast<double>((x * 7919 + y * 104729 + z * 1299709 + c * 31) & 1023) / 1024;
    },
    2);

double chaosAt(const Vector3d& place, int channel) {
    const Vector3d corner = place.array().floor();
    double sum = 0;
    for (int i = 0; i < 8; ++i) {
        const Vector3d voxel = corner + Vector3d(i & 1, i >> 1 & 1, i >> 2);
        const Vector3d near = Vector3d::Ones() - (place - voxel).cwiseAbs();
        TestContext context(1);
        const Volume one = kChaos.sample({static_cast<std::int64_t>(voxel.x()),
                                          static_cast<std::int64_t>(voxel.y()),
                                          static_cast<std::int64_t>(voxel.z()),
                                          {1, 1, 1}},
                                         context);
        sum += near.prod() * static_cast<double>(one(0, 0, 0, channel));
    }
    return sum;
}

} // namespace

TEST(Slice, AlongTheAxesIsTheVoxels) {
    const Volume volume = sampleVolume({7, 5, 6}, 2);
    const DenseSource source(volume, DenseSource::Edge::Ends);
    TestContext context;
    const Image z = slice(source, axisPlane(Axis::Z, {0, 0, 4}), {7, 5}, context);
    const Image y = slice(source, axisPlane(Axis::Y, {0, 3, 0}), {7, 6}, context);
    const Image x = slice(source, axisPlane(Axis::X, {2, 0, 0}), {6, 5}, context);
    for (int c = 0; c < 2; ++c)
        for (int i = 0; i < 7; ++i)
            for (int j = 0; j < 5; ++j)
                for (int k = 0; k < 6; ++k) {
                    ASSERT_EQ(z(i, j, c), volume(i, j, 4, c));
                    ASSERT_EQ(y(i, k, c), volume(i, 3, k, c));
                    ASSERT_EQ(x(k, j, c), volume(2, j, k, c));
                }
}

TEST(Slice, ThatIsTallerThanABandIsWhole) {
    TestContext context;
    const Image image = slice(kChaos, axisPlane(Axis::X, {-5, -100, -3}), {9, 200}, context);
    const Volume volume = kChaos.sample({-5, -100, -3, {1, 200, 9}}, context);
    for (int y = 0; y < 200; ++y)
        for (int x = 0; x < 9; ++x)
            ASSERT_EQ(image(x, y, 1), volume(0, y, x, 1));
}

TEST(Slice, MirroredAxesAreExactToo) {
    TestContext context;
    const Plane plane{{4, 5, 6}, -Vector3d::UnitX(), Vector3d::UnitZ()};
    const Image image = slice(kChaos, plane, {9, 7}, context);
    const Volume volume = kChaos.sample({-4, 5, 6, {9, 1, 7}}, context);
    for (int y = 0; y < 7; ++y)
        for (int x = 0; x < 9; ++x)
            ASSERT_EQ(image(x, y, 0), volume(8 - x, 0, y, 0));
}

TEST(Slice, ObliqueIsInterpolatedLinearly) {
    TestContext context;
    const Plane plane = turned(axisPlane(Axis::Z, {-20.3, 11.8, -7}), {3, 4, 5}, 0.7, -0.4);
    const Image image = slice(kRamp, plane, {70, 40}, context);
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 70; ++x)
            ASSERT_NEAR(image(x, y, 0), ramp(plane.at(x, y)), 1e-6);
    const Image chaos = slice(kChaos, plane, {5, 4}, context);
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 5; ++x)
            for (int c = 0; c < 2; ++c)
                ASSERT_NEAR(chaos(x, y, c), chaosAt(plane.at(x, y), c), 1e-6);
}

TEST(Slice, APixelDoesNotDependOnTheSliceItIsIn) {
    TestContext one(1), many(3);
    const Plane plane = turned(axisPlane(Axis::Y, {-9, 2, 4}), {0, 0, 0}, kPi / 4, 0.3);
    const Image whole = slice(kChaos, plane, {90, 75}, one);
    EXPECT_TRUE(samePixels(whole, slice(kChaos, plane, {90, 75}, many)));
    const Plane part{plane.at(17, 21), plane.right, plane.down};
    const Image cut = slice(kChaos, part, {40, 40}, many);
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 40; ++x)
            ASSERT_NEAR(cut(x, y, 0), whole(x + 17, y + 21, 0), 1e-6);
}

TEST(Slice, AFullTurnOrAQuarterMeetsTheVoxels) {
    TestContext context;
    const Vector3d pivot(3, 3, 3);
    const Plane z = axisPlane(Axis::Z, {0, 0, 3});
    const Image quarter = slice(kChaos, turned(z, pivot, -kPi / 2, 0), {7, 7}, context);
    const Image x = slice(kChaos, axisPlane(Axis::X, {3, 0, 0}), {7, 7}, context);
    for (int j = 0; j < 7; ++j)
        for (int i = 0; i < 7; ++i)
            ASSERT_NEAR(quarter(i, j, 0), x(i, j, 0), 1e-6);
    const DenseSource ends(sampleVolume({7, 7, 7}, 1), DenseSource::Edge::Ends);
    const Image full = slice(ends, turned(z, pivot, 2 * kPi, 0), {7, 7}, context);
    const Image same = slice(ends, z, {7, 7}, context);
    for (int j = 0; j < 7; ++j)
        for (int i = 0; i < 7; ++i)
            ASSERT_NEAR(full(i, j, 0), same(i, j, 0), 1e-6);
}

TEST(Slice, SlicesAgreeWhereTheyCross) {
    TestContext context;
    const Image z = slice(kChaos, axisPlane(Axis::Z, {-10, -10, 2}), {20, 20}, context);
    const Image y = slice(kChaos, axisPlane(Axis::Y, {-10, 1, -10}), {20, 20}, context);
    for (int x = 0; x < 20; ++x)
        ASSERT_EQ(z(x, 11, 0), y(x, 12, 0));
}

TEST(Slice, BeyondTheBoundsThereIsNothing) {
    const DenseSource source(sampleVolume({4, 4, 4}, 1), DenseSource::Edge::Ends, 10, 10, 10);
    TestContext context;
    const Image image = slice(source, axisPlane(Axis::Z, {8, 8, 13}), {8, 8}, context);
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x) {
            const bool inside = x >= 2 && x < 6 && y >= 2 && y < 6;
            ASSERT_EQ(image(x, y, 0), inside ? source.volume()(x - 2, y - 2, 3, 0) : 0.0F);
        }
    EXPECT_THAT(
        [&] {
            slice(source, axisPlane(Axis::Z, {8, 8, 14}), {8, 8}, context);
        },
        usageRefusal("beside the volume", "z 10 to 13"));
    EXPECT_THAT(
        [&] {
            slice(source, axisPlane(Axis::Y, {0, 0, 0}), {8, 8}, context);
        },
        usageRefusal("beside the volume"));
}

TEST(Slice, PlanesThatAreNoneAreRefused) {
    TestContext context;
    const auto refused = [&](const Plane& plane) { slice(kRamp, plane, {8, 8}, context); };
    EXPECT_THAT(
        [&] {
            refused({Vector3d::Zero(), Vector3d::Zero(), Vector3d::UnitY()});
        },
        usageRefusal("0 voxels"));
    EXPECT_THAT(
        [&] {
            refused({Vector3d::Zero(), 9 * Vector3d::UnitX(), Vector3d::UnitY()});
        },
        usageRefusal("9 voxels", "up to 8"));
    EXPECT_THAT(
        [&] {
            refused({Vector3d::Constant(std::nan("")), Vector3d::UnitX(), Vector3d::UnitY()});
        },
        usageRefusal("too far"));
    EXPECT_THAT([&] { refused(axisPlane(Axis::Z, {0, std::nan(""), 0})); }, usageRefusal("too far"));
    EXPECT_THAT([&] { refused(axisPlane(Axis::Z, {0, 2e12, 0})); }, usageRefusal("too far"));
    EXPECT_THAT([&] { slice(kRamp, {}, {8, 0}, context); }, usageRefusal("8 × 0"));
    EXPECT_NO_THROW(refused(axisPlane(Axis::Z, {-1e12, 1e12, 1e12})));
}

} // namespace texloom::test
