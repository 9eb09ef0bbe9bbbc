#include "core/job/random.h"
#include "core/job/voxel_random.h"
#include "tests/core/job/chi_square.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <vector>

namespace texloom::test {

namespace {

using Four64 = std::array<std::uint64_t, 4>;
using Two64 = std::array<std::uint64_t, 2>;

/// Philox 4x64-10, from the same section.
Four64 philox64(Four64 counter, Two64 key) {
    for (int round = 0; round < 10; ++round) {
        const auto a = static_cast<unsigned __int128>(0xD2E7470EE14C6C93ULL) * counter[0];
        const auto b = static_cast<unsigned __int128>(0xCA5A826395121157ULL) * counter[2];
        counter = {static_cast<std::uint64_t>(b >> 64) ^ counter[1] ^ key[0], static_cast<std::uint64_t>(b),
                   static_cast<std::uint64_t>(a >> 64) ^ counter[3] ^ key[1], static_cast<std::uint64_t>(a)};
        key[0] += 0x9E3779B97F4A7C15ULL;
        key[1] += 0xBB67AE8584CAA73BULL;
    }
    return counter;
}

} // namespace

TEST(Philox, GivesThePublishedAnswersOf64Bits) {
    // Random123's kat_vectors, "philox4x64 10".
    EXPECT_EQ(philox64({0, 0, 0, 0}, {0, 0}),
              (Four64{0x16554d9eca36314c, 0xdb20fe9d672d0fdc, 0xd7e772cee186176b, 0x7e68b68aec7ba23b}));
    constexpr std::uint64_t kOnes = ~std::uint64_t{0};
    EXPECT_EQ(philox64({kOnes, kOnes, kOnes, kOnes}, {kOnes, kOnes}),
              (Four64{0x87b092c3013fe90b, 0x438c3c67be8d0224, 0x9cc7d7c69cd777b6, 0xa09caebf594f0ba0}));
}

TEST(VoxelRandom, IsPhiloxOfThePlace) {
    const std::uint64_t seed = 0x299f31d0a4093822ULL;
    const std::uint32_t stream = 5;
    const VoxelRandom random(seed, stream);
    const std::int64_t far = std::int64_t{1} << 40;
    for (const std::int64_t x : {std::int64_t{0}, std::int64_t{-1}, far, -far})
        for (const std::int64_t y : {std::int64_t{3}, -far})
            for (const std::int64_t z : {std::int64_t{-7}, far + 1})
                for (const std::uint32_t n : {0U, 1U, 2U, 7U, 8U, 4000000003U}) {
                    const Four64 words =
                        philox64({static_cast<std::uint64_t>(x), static_cast<std::uint64_t>(y),
                                  static_cast<std::uint64_t>(z), n / 8},
                                 {seed, stream});
                    const auto bits = static_cast<std::uint32_t>(words[n / 2 % 4] >> (n % 2 * 32));
                    EXPECT_EQ(random.bits({x, y, z}, n), bits) << x << ' ' << y << ' ' << z << ' ' << n;
                    EXPECT_EQ(random.uniform({x, y, z}, n), bits * 0x1p-32);
                    EXPECT_EQ(random.below(1000, {x, y, z}, n), std::uint64_t{bits} * 1000 >> 32);
                }
}

TEST(VoxelRandom, IsEvenAndIndependentOfNumbersByPixel) {
    const VoxelRandom random(21);
    const Random plane(21);
    std::vector<int> places(256), pairs(256), planes(256);
    for (int z = -8; z < 8; ++z)
        for (int y = -32; y < 32; ++y)
            for (int x = -32; x < 32; ++x) {
                ++places[random.bits({x, y, z}) >> 24];
                ++pairs[((random.bits({x, y, z}) >> 28) << 4) | (random.bits({x, y, z + 1}) >> 28)];
                ++planes[((random.bits({x, y, z}) >> 28) << 4) |
                         (plane.bits(x, y, static_cast<std::uint32_t>(z + 8)) >> 28)];
            }
    for (const auto& counts : {places, pairs, planes}) {
        EXPECT_GT(chiSquare(counts), kLeast255);
        EXPECT_LT(chiSquare(counts), kMost255);
    }
}

TEST(VoxelRandom, NormalHasTheMomentsOfTheNormalDistribution) {
    const VoxelRandom random(6);
    constexpr int kSide = 54;
    double mean = 0, variance = 0;
    for (int z = 0; z < kSide; ++z)
        for (int y = 0; y < kSide; ++y)
            for (int x = 0; x < kSide; ++x) {
                const double value = random.normal({x, y, -z}, 2);
                mean += value / (kSide * kSide * kSide);
                variance += value * value / (kSide * kSide * kSide);
            }
    EXPECT_NEAR(mean, 0, 0.01);
    EXPECT_NEAR(variance, 1, 0.015);
}

} // namespace texloom::test
