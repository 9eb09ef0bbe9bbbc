#include "core/base/error.h"
#include "core/volume/block_cache.h"
#include "core/volume/point_samples.h"
#include "tests/support/volumes.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>

namespace texloom::test {
namespace {

std::shared_ptr<const VolumeSource> ramp() {
    return std::make_shared<FunctionSource>(
        [](std::int64_t x, std::int64_t y, std::int64_t z, int c) {
            return static_cast<double>((x * 7 + y * 131 + z * 1021 + c * 13) & 1023) / 1023;
        },
        3);
}

TEST(BlockCache, AnyBoxIsThatOfItsSource) {
    const auto source = ramp();
    const BlockCache cache(source);
    TestContext context;
    for (const Box& box :
         {Box{-5, -40, 20, {12, 70, 35}}, Box{0, 0, 0, {33, 33, 33}}, Box{-33, -32, -31, {64, 3, 34}},
          Box{31, 32, 33, {3, 5, 66}}, Box{-7, 3, 9, {100, 100, 1}}})
        EXPECT_TRUE(sameVoxels(cache.sample(box, context), source->sample(box, context))) << boxText(box);
}

TEST(BlockCache, ABlockAndWhatLiesBehindItIsOneBlock) {
    const BlockCache cache(ramp());
    TestContext context;
    cache.sample({0, 0, 0, {33, 33, 33}}, context);
    EXPECT_EQ(cache.blocks(), 1U);
    cache.sample({0, 0, 0, {34, 33, 33}}, context);
    EXPECT_EQ(cache.blocks(), 2U);
}

TEST(BlockCache, PointsHaveTheValuesOfTheSourceAndBlocksAreMadeOnce) {
    std::atomic<int> asked = 0;
    const auto source =
        std::make_shared<FunctionSource>([&asked](std::int64_t x, std::int64_t y, std::int64_t z, int) {
            ++asked;
            return static_cast<double>(x + 3 * y - z);
        });
    const BlockCache cache(source);
    std::vector<Eigen::Vector3d> points;
    for (int i = 0; i < 500; ++i)
        points.emplace_back(0.37 * i - 70, 12 - 0.11 * i, 5 * std::sin(i));
    TestContext context;
    const BlockCache::Samples samples = cache.at(points, std::nullopt, context);
    EXPECT_TRUE(samples.whole);
    EXPECT_EQ(samples.values, sampledAt(*source, points, context));
    for (std::size_t i = 0; i < points.size(); ++i) // linear functions are met by interpolation
        EXPECT_NEAR(samples.values[i], points[i].x() + 3 * points[i].y() - points[i].z(), 1e-4);
    const int before = asked;
    EXPECT_EQ(cache.at(points, std::nullopt, context).values, samples.values);
    EXPECT_EQ(asked, before);
}

TEST(BlockCache, WhatIsLateIsNoNumberAndComesLater) {
    const BlockCache cache(ramp());
    const std::vector<Eigen::Vector3d> points{{1, 2, 3}, {100, 2, 3}, {-100, 2, 3}};
    TestContext context;
    const BlockCache::Samples none = cache.at(points, std::chrono::milliseconds(-1), context);
    EXPECT_FALSE(none.whole);
    EXPECT_TRUE(std::isnan(none.values.front()));
    EXPECT_EQ(cache.blocks(), 0U);
    const BlockCache::Samples all = cache.at(points, std::chrono::hours(1), context);
    EXPECT_TRUE(all.whole);
    EXPECT_TRUE(cache.at(points, std::chrono::milliseconds(-1), context).whole) << "they are kept";
}

TEST(BlockCache, KeepsNoMoreThanItMay) {
    const std::uint64_t each = Volume::bytesFor(boxOf({}).size, 3);
    const BlockCache cache(ramp(), 3 * each);
    const auto source = ramp();
    TestContext context;
    const Box wide{0, 0, 0, {320, 8, 8}};
    EXPECT_TRUE(sameVoxels(cache.sample(wide, context), source->sample(wide, context)));
    EXPECT_EQ(cache.blocks(), 3U);
    // More blocks than it holds are made in one go: it would never come to an end else.
    std::vector<Eigen::Vector3d> points;
    for (int i = 0; i < 8; ++i)
        points.emplace_back(40 * i, 0, 0);
    EXPECT_TRUE(cache.at(points, std::chrono::milliseconds(-1), context).whole);
}

TEST(BlockCache, VolumesThatEndDoSo) {
    const auto source =
        std::make_shared<DenseSource>(sampleVolume({40, 30, 20}, 1), DenseSource::Edge::Ends, -10, 0, 5);
    const BlockCache cache(source);
    TestContext context;
    EXPECT_TRUE(sameVoxels(cache.sample(*source->bounds(), context), source->volume()));
    const std::vector<Eigen::Vector3d> points{{-10, 0, 5}, {29, 29, 24}, {31, 0, 10}};
    const std::vector<float> values = cache.at(points, std::nullopt, context).values;
    EXPECT_EQ(values[0], source->volume()(0, 0, 0, 0));
    EXPECT_EQ(values[1], source->volume()(39, 29, 19, 0));
    EXPECT_EQ(values[2], 0);
    EXPECT_THROW(cache.sample({30, 0, 5, {1, 1, 1}}, context), UsageError);
}

} // namespace
} // namespace texloom::test
