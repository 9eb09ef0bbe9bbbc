#include "core/job/random.h"
#include "core/math/transport.h"

#include <gtest/gtest.h>

namespace texloom::test {
namespace {

std::vector<float> bump(int length, int from, int width, float height, float floor = 0) {
    std::vector<float> signal(static_cast<std::size_t>(length), floor);
    for (int x = from; x < from + width; ++x)
        signal[static_cast<std::size_t>(x)] +=
            height * static_cast<float>(1 + std::min(x - from, from + width - 1 - x));
    return signal;
}

std::vector<float> noisy(int length, std::uint64_t seed) {
    std::vector<float> signal;
    for (int x = 0; x < length; ++x)
        signal.push_back(static_cast<float>(Random(seed).uniform(x, 0)));
    return signal;
}

TEST(Midway, shiftedBumpsMeetHalfWay) {
    const std::vector<float> middle = Midway(bump(60, 10, 9, 1), bump(60, 30, 9, 1)).signal();
    const std::vector<float> expected = bump(60, 20, 9, 1);
    for (std::size_t x = 0; x < 60; ++x)
        EXPECT_NEAR(middle[x], expected[x], 1e-5) << x;
}

TEST(Midway, bumpsOfOtherMassMeetHalfWayWithTheirMeanMass) {
    const std::vector<float> middle = Midway(bump(60, 10, 9, 1), bump(60, 30, 9, 3)).signal();
    const std::vector<float> expected = bump(60, 20, 9, 2);
    for (std::size_t x = 0; x < 60; ++x)
        EXPECT_NEAR(middle[x], expected[x], 1e-5) << x;
}

TEST(Midway, overAFloorTheBumpsDoNotSimplyMove) {
    // R figure 4.6: the mass of the floor takes part.
    const std::vector<float> middle = Midway(bump(60, 10, 9, 1, 1), bump(60, 30, 9, 1, 1)).signal();
    const std::vector<float> moved = bump(60, 20, 9, 1, 1);
    double difference = 0;
    for (std::size_t x = 0; x < 60; ++x)
        difference += std::abs(static_cast<double>(middle[x] - moved[x]));
    EXPECT_GT(difference, 5);
    EXPECT_NEAR(massOf(middle), massOf(moved), 1e-4);
}

TEST(Midway, massIsTheMeanAndSharesGoFromOneToTheOther) {
    const std::vector<float> a = noisy(41, 1), b = noisy(41, 2);
    for (const double share : {0.0, 0.25, 0.5, 1.0}) {
        const std::vector<float> between = Midway(a, b, share).signal();
        EXPECT_NEAR(massOf(between), (1 - share) * massOf(a) + share * massOf(b), 1e-4);
        for (std::size_t x = 0; x < 41 && (share == 0 || share == 1); ++x)
            EXPECT_NEAR(between[x], (share == 0 ? a : b)[x], 1e-5);
    }
}

TEST(Midway, bothDeformationsGiveTheMiddle) {
    for (const std::uint64_t seed : {1U, 5U}) {
        std::vector<float> a = noisy(50, seed), b = noisy(50, seed + 1);
        std::fill_n(a.begin() + 10, 8, 0.0F);
        std::fill_n(b.begin() + 30, 20, 0.0F);
        const Midway midway(a, b);
        const std::vector<float> middle = midway.signal();
        const double mass = massOf(middle);
        const std::vector<float> fromA = deformed(a, midway.firstPlaces(), mass);
        const std::vector<float> fromB = deformed(b, midway.secondPlaces(), mass);
        for (std::size_t x = 0; x < 50; ++x) {
            EXPECT_NEAR(fromA[x], middle[x], 1e-5) << x;
            EXPECT_NEAR(fromB[x], middle[x], 1e-5) << x;
        }
    }
}

TEST(Midway, signalsWithoutMassAreEven) {
    const std::vector<float> nothing(12, 0.0F);
    for (const float value : Midway(nothing, nothing).signal())
        EXPECT_EQ(value, 0);
    const std::vector<float> half = Midway(nothing, std::vector<float>(12, 2.0F)).signal();
    for (const float value : half)
        EXPECT_NEAR(value, 1, 1e-6);
}

} // namespace
} // namespace texloom::test
