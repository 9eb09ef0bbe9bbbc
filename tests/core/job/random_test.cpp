#include "core/job/random.h"
#include "tests/core/job/chi_square.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <set>
#include <thread>
#include <vector>

namespace texloom::test {

namespace {

using Four = std::array<std::uint32_t, 4>;
using Two = std::array<std::uint32_t, 2>;

/// Philox 4x32-10 written out from Salmon et al. (SC 2011), section 3.3.
Four philox(Four counter, Two key) {
    for (int round = 0; round < 10; ++round) {
        const std::uint64_t a = 0xD2511F53ULL * counter[0];
        const std::uint64_t b = 0xCD9E8D57ULL * counter[2];
        counter = {static_cast<std::uint32_t>(b >> 32) ^ counter[1] ^ key[0], static_cast<std::uint32_t>(b),
                   static_cast<std::uint32_t>(a >> 32) ^ counter[3] ^ key[1], static_cast<std::uint32_t>(a)};
        key[0] += 0x9E3779B9U;
        key[1] += 0xBB67AE85U;
    }
    return counter;
}

} // namespace

TEST(Philox, GivesThePublishedAnswers) {
    // Random123's kat_vectors, "philox4x32 10".
    EXPECT_EQ(philox({0, 0, 0, 0}, {0, 0}), (Four{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
    EXPECT_EQ(philox({0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff}, {0xffffffff, 0xffffffff}),
              (Four{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
    EXPECT_EQ(philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
              (Four{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

TEST(Random, GivesThePublishedAnswerAtTheOrigin) {
    const Random random(0);
    EXPECT_EQ((Four{random.bits(0, 0, 0), random.bits(0, 0, 1), random.bits(0, 0, 2), random.bits(0, 0, 3)}),
              (Four{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
}

TEST(Random, IsPhiloxOfThePlace) {
    const std::uint64_t seed = 0x299f31d0a4093822ULL;
    const Random random(seed);
    for (const int x : {0, 1, 77, 65535, -1})
        for (const int y : {0, 3, 4096})
            for (const std::uint32_t n : {0U, 1U, 6U, 4000000003U}) {
                const Four words =
                    philox({static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), n / 4, 0},
                           {static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)});
                EXPECT_EQ(random.bits(x, y, n), words[n % 4]) << x << ' ' << y << ' ' << n;
            }
}

TEST(Random, IsUniformInEachByte) {
    const Random random(11);
    for (const int shift : {0, 8, 16, 24}) {
        std::vector<int> counts(256);
        for (int y = 0; y < 256; ++y)
            for (int x = 0; x < 256; ++x)
                ++counts[(random.bits(x, y) >> shift) & 255U];
        EXPECT_GT(chiSquare(counts), kLeast255) << shift;
        EXPECT_LT(chiSquare(counts), kMost255) << shift;
    }
}

TEST(Random, NeighboursAreIndependent) {
    const Random random(12);
    std::vector<int> pairs(256);
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 256; ++x)
            ++pairs[((random.bits(x, y) >> 28) << 4) | (random.bits(x + 1, y) >> 28)];
    EXPECT_GT(chiSquare(pairs), kLeast255);
    EXPECT_LT(chiSquare(pairs), kMost255);
}

TEST(Random, EverySeedPlaceAndDrawDiffers) {
    std::set<std::uint32_t> seen;
    for (const std::uint64_t seed : {0ULL, 1ULL, 1ULL << 32, ~0ULL})
        for (int y = 0; y < 4; ++y)
            for (int x = 0; x < 4; ++x)
                for (std::uint32_t n = 0; n < 8; ++n)
                    seen.insert(Random(seed).bits(x, y, n));
    EXPECT_EQ(seen.size(), 512U);
}

TEST(Random, UniformLiesBelowOne) {
    const Random random(13);
    double sum = 0;
    for (int x = 0; x < 100000; ++x) {
        const double draw = random.uniform(x, 0);
        ASSERT_GE(draw, 0);
        ASSERT_LT(draw, 1);
        sum += draw;
    }
    EXPECT_NEAR(sum / 100000, 0.5, 0.005);
}

TEST(Random, BelowReachesEveryNumberAlike) {
    const Random random(14);
    std::vector<int> counts(256);
    for (int x = 0; x < 65536; ++x)
        ++counts.at(random.below(256, x, 9));
    EXPECT_GT(chiSquare(counts), kLeast255);
    EXPECT_LT(chiSquare(counts), kMost255);
}

TEST(Random, BelowOneIsZero) {
    EXPECT_EQ(Random(1).below(1, 5, 6, 7), 0U);
}

TEST(Random, DoesNotDependOnTheThread) {
    const Random random(15);
    std::vector<std::uint32_t> here, there;
    for (int x = 0; x < 1000; ++x)
        here.push_back(random.bits(x, 2, 1));
    std::thread([&] {
        for (int x = 999; x >= 0; --x)
            there.insert(there.begin(), random.bits(x, 2, 1));
    }).join();
    EXPECT_EQ(here, there);
}

TEST(Random, NumbersByCoordinateKeepTheirBits) {
    // Every result of every method depends on these.
    const Random random(20261128, 3);
    std::uint32_t sum = 0;
    for (int y = -2; y < 30; ++y)
        for (int x = -2; x < 30; ++x)
            for (std::uint32_t n = 0; n < 9; ++n)
                sum = sum * 31 + random.bits(x, y, n) + random.below(1000, x, y, n);
    EXPECT_EQ(sum, 3306636801U);
    EXPECT_EQ(random.bits(5, 6, 7), 2944811106U);
    EXPECT_EQ(random.uniform(5, 6, 7), 0.6856422652490437);
    EXPECT_EQ(random.normal(5, 6, 7), 0.65985615310429735);
}

TEST(Random, NormalHasTheMomentsAndTailsOfTheNormalDistribution) {
    const Random random(5);
    constexpr int kSide = 400;
    double sums[5] = {};
    int beyondTwo = 0;
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            const double value = random.normal(x, y, 3);
            for (int power = 1; power <= 4; ++power)
                sums[power] += std::pow(value, power) / (kSide * kSide);
            beyondTwo += std::abs(value) > 2 ? 1 : 0;
        }
    EXPECT_NEAR(sums[1], 0, 0.01);
    EXPECT_NEAR(sums[2], 1, 0.015);
    EXPECT_NEAR(sums[3], 0, 0.04);
    EXPECT_NEAR(sums[4], 3, 0.1);
    EXPECT_NEAR(beyondTwo / static_cast<double>(kSide * kSide), 0.0455, 0.002);
}

} // namespace texloom::test
