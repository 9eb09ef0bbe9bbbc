#include "core/base/large_memory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <new>
#include <vector>

namespace texloom::test {
namespace {

constexpr std::size_t kSmall = 1000, kLarge = kLargeMemory / sizeof(float) + 777;

TEST(LargeMemory, buffersAreZeroAndAligned) {
    for (const std::size_t count : {kSmall, kLarge}) {
        for (int again = 0; again < 3; ++again) { // memory that comes back from an earlier buffer, too
            ZeroedBuffer<float> buffer(count);
            EXPECT_EQ(reinterpret_cast<std::uintptr_t>(buffer.data()) % 64, 0U);
            EXPECT_TRUE(std::all_of(buffer.begin(), buffer.end(), [](float value) { return value == 0; }));
            std::fill(buffer.begin(), buffer.end(), 7.0F);
        }
    }
}

TEST(LargeMemory, copiesAreApartAndWhatWasMovedIsEmpty) {
    for (const std::size_t count : {kSmall, kLarge}) {
        ZeroedBuffer<float> first(count);
        first[count - 1] = 3;
        ZeroedBuffer<float> second = first;
        second[count - 1] = 4;
        EXPECT_EQ(first[count - 1], 3);
        const ZeroedBuffer<float> third = std::move(second);
        EXPECT_EQ(third[count - 1], 4);
        EXPECT_EQ(second.size(), 0U); // NOLINT(bugprone-use-after-move): that is what is asked
        first = third;
        EXPECT_EQ(first[count - 1], 4);
        EXPECT_EQ(first.size(), count);
    }
}

TEST(LargeMemory, containersGrowAndShrinkInIt) {
    std::vector<std::uint16_t, LargeAllocator<std::uint16_t>> values(kSmall, 5);
    values.resize(3 * kLarge, 6);
    EXPECT_EQ(values[kSmall - 1], 5);
    EXPECT_EQ(values[kSmall], 6);
    values.resize(2);
    values.resize(kLarge);
    EXPECT_EQ(values[2], 0);
}

TEST(LargeMemory, tooMuchIsRefused) {
    EXPECT_THROW(allocateMemory(std::numeric_limits<std::size_t>::max()), std::bad_alloc);
    EXPECT_THROW(allocateMemory(std::size_t{1} << 60U), std::bad_alloc);
}

} // namespace
} // namespace texloom::test
