#include "core/volume/volume_source.h"
#include "tests/core/refusal.h"
#include "tests/support/volumes.h"

#include <gtest/gtest.h>

#include <limits>

namespace texloom::test {

namespace {

constexpr std::int64_t kFar = Box::kFarthest;

int modulo(std::int64_t a, int b) {
    return static_cast<int>(((a % b) + b) % b);
}

} // namespace

TEST(Box, CommonPartsAreTakenVoxelByVoxel) {
    const Box a{-3, 0, 5, {6, 4, 2}};
    for (std::int64_t x = -8; x < 8; ++x)
        for (const Box& b : {Box{x, 1, 4, {3, 9, 2}}, Box{x, -9, 6, {1, 10, 7}}}) {
            const Box common = intersection(a, b);
            std::int64_t voxels = 0;
            for (std::int64_t k = a.z; k < a.endZ(); ++k)
                for (std::int64_t j = a.y; j < a.endY(); ++j)
                    for (std::int64_t i = a.x; i < a.endX(); ++i)
                        voxels += Box{i, j, k, {1, 1, 1}}.within(b) ? 1 : 0;
            EXPECT_EQ(common.size.voxels(), voxels) << x;
            if (voxels > 0) {
                EXPECT_TRUE(common.within(a));
                EXPECT_TRUE(common.within(b));
            }
        }
}

TEST(Box, CountsThatDoNotFitAreTheLargestThereIs) {
    constexpr int kMost = std::numeric_limits<int>::max();
    EXPECT_EQ((VolumeSize{kMost, kMost, kMost}.voxels()), std::numeric_limits<std::int64_t>::max());
    EXPECT_EQ(Volume::bytesFor({kMost, kMost, 2}, 64), std::numeric_limits<std::uint64_t>::max());
    EXPECT_EQ(Volume::bytesFor({3, 4, 5}, 2), 480U);
}

TEST(Box, LiesWithinTheCoordinatesThereAre) {
    EXPECT_NO_THROW((Box{kFar - 4, -kFar, 0, {4, 1, 1}}.check()));
    EXPECT_THAT(([] {
                    Box{kFar - 3, 0, 0, {4, 1, 1}}.check();
                }),
                usageRefusal("too far", "1,099,511,627,776"));
    EXPECT_THAT(([] {
                    Box{0, std::numeric_limits<std::int64_t>::min(), 0, {4, 1, 1}}.check();
                }),
                usageRefusal("too far"));
    EXPECT_THAT(([] {
                    Box{0, 0, std::numeric_limits<std::int64_t>::max(), {1, 1, 1}}.check();
                }),
                usageRefusal("too far"));
    EXPECT_THAT(([] { Box{0, 0, 0, {4, 0, 1}}.check(); }), usageRefusal("4 × 0 × 1"));
}

TEST(Volume, SlicesAreViewsOfIt) {
    const Volume volume = sampleVolume({5, 4, 3}, 2);
    for (int z = 0; z < 3; ++z)
        for (int y = 0; y < 4; ++y)
            for (int x = 0; x < 5; ++x)
                for (int c = 0; c < 2; ++c)
                    EXPECT_EQ(volume.slice(z)(x, y, c), volume(x, y, z, c));
    EXPECT_THAT([] { Volume({3, 0, 3}, 1); }, refusal("3 × 0 × 3"));
    EXPECT_THAT([] { Volume({3, 3, 3}, 0); }, refusal("0 channels"));
    EXPECT_THAT([] { Volume({1 << 20, 1 << 20, 1 << 20}, 3); }, refusal("not enough memory"));
}

TEST(DenseSource, RepeatsWithoutEnd) {
    const Volume volume = sampleVolume({5, 4, 3}, 2);
    const DenseSource source(volume, DenseSource::Edge::Repeats, 1, 0, -2);
    EXPECT_FALSE(source.bounds());
    EXPECT_EQ(source.period(), volume.size());
    TestContext context;
    for (const Box& box :
         {Box{-7, -3, -9, {17, 11, 13}}, Box{kFar - 20, -kFar, 4, {20, 2, 1}}, Box{0, 0, 0, {1, 1, 1}}}) {
        const Volume part = source.sample(box, context);
        for (int c = 0; c < 2; ++c)
            for (int z = 0; z < part.depth(); ++z)
                for (int y = 0; y < part.height(); ++y)
                    for (int x = 0; x < part.width(); ++x)
                        ASSERT_EQ(part(x, y, z, c), volume(modulo(box.x + x - 1, 5), modulo(box.y + y, 4),
                                                           modulo(box.z + z + 2, 3), c));
    }
}

TEST(DenseSource, EndsWhereTheVolumeDoes) {
    const Volume volume = sampleVolume({5, 4, 3}, 1);
    const DenseSource source(volume, DenseSource::Edge::Ends, -2, 10, 0);
    TestContext context;
    ASSERT_TRUE(source.bounds());
    EXPECT_TRUE(sameVoxels(source.sample(*source.bounds(), context), volume));
    EXPECT_EQ(source.sample({2, 13, 2, {1, 1, 1}}, context)(0, 0, 0, 0), volume(4, 3, 2, 0));
    EXPECT_THAT(
        [&] {
            source.sample({2, 13, 2, {2, 1, 1}}, context);
        },
        usageRefusal("x 2 to 3", "x -2 to 2, y 10 to 13, z 0 to 2"));
    EXPECT_THAT([&] { source.sample({2, 13, 2, {1, 1, -1}}, context); }, usageRefusal("1 × 1 × -1"));
}

TEST(VolumeSource, TooLargeABoxIsRefusedWithBothFigures) {
    const DenseSource source(sampleVolume({5, 4, 3}, 3), DenseSource::Edge::Repeats);
    TestContext context;
    EXPECT_THAT(
        [&] {
            source.sample({0, 0, 0, {10000, 10000, 10000}}, context);
        },
        refusal("10000 × 10000 × 10000", "memory are free"));
}

TEST(VolumeSource, StopsWhenTheJobIsCalledOff) {
    const DenseSource source(sampleVolume({5, 4, 3}, 3), DenseSource::Edge::Repeats);
    JobMonitor monitor;
    JobContext context(
        {1, 2, false}, [] { return true; }, monitor);
    EXPECT_THROW(source.sample({0, 0, 0, {9, 9, 9}}, context), Cancelled);
}

} // namespace texloom::test
