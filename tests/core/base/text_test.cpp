#include "core/base/text.h"
#include "core/job/random.h"

#include <gmock/gmock.h>

#include <bit>
#include <cmath>
#include <limits>

namespace texloom::test {

TEST(ParseNumber, TakesTheWholeTextOrNothing) {
    for (const char* text :
         {"", " ", "1.5x", " 1", "1 ", "+1", "0x10", "1,5", "nan", "inf", "-inf", "1e999"}) {
        double number = 7;
        EXPECT_FALSE(parseNumber(text, number)) << text;
        EXPECT_EQ(number, 7) << text;
    }
}

TEST(ParseNumber, ReadsDecimalsAndExponents) {
    double number = 0;
    EXPECT_TRUE(parseNumber("-2.5e-3", number));
    EXPECT_EQ(number, -0.0025);
}

TEST(ParseInteger, TakesTheWholeTextOrNothing) {
    for (const char* text : {"", "1.0", "12px", "9223372036854775808", "--1"}) {
        long long number = 7;
        EXPECT_FALSE(parseInteger(text, number)) << text;
        EXPECT_EQ(number, 7) << text;
    }
}

TEST(ParseInteger, ReadsTheSmallestNumber) {
    long long number = 0;
    EXPECT_TRUE(parseInteger("-9223372036854775808", number));
    EXPECT_EQ(number, std::numeric_limits<long long>::min());
}

TEST(NumberText, ReadsBackAsTheSameDouble) {
    const Random random(3);
    for (int i = 0; i < 10000; ++i) {
        const std::uint64_t bits = (static_cast<std::uint64_t>(random.bits(i, 0)) << 32) | random.bits(i, 1);
        const auto number = std::bit_cast<double>(bits);
        if (!std::isfinite(number))
            continue;
        double back = 0;
        ASSERT_TRUE(parseNumber(numberText(number), back)) << numberText(number);
        EXPECT_EQ(std::bit_cast<std::uint64_t>(back), bits) << numberText(number);
    }
}

TEST(NumberText, IsAsShortAsCanBe) {
    EXPECT_EQ(numberText(0.1), "0.1");
    EXPECT_EQ(numberText(512), "512");
    EXPECT_EQ(numberText(0.1 + 0.2), "0.30000000000000004");
}

TEST(Grouped, SetsACommaBeforeEachThreeDigits) {
    EXPECT_EQ(grouped(0), "0");
    EXPECT_EQ(grouped(999), "999");
    EXPECT_EQ(grouped(1536), "1,536");
    EXPECT_EQ(grouped(123456), "123,456");
    EXPECT_EQ(grouped(18446744073709551615ULL), "18,446,744,073,709,551,615");
}

TEST(ByteText, CountsInBinaryUnits) {
    EXPECT_EQ(byteText(1), "0.1 MiB");
    EXPECT_EQ(byteText(96ULL << 20), "96 MiB");
    EXPECT_EQ(byteText(3ULL << 29), "1.5 GiB");
}

TEST(DurationText, FitsTheLength) {
    EXPECT_EQ(durationText(0.44), "0.4 s");
    EXPECT_EQ(durationText(9.96), "10 s");
    EXPECT_EQ(durationText(12.4), "12 s");
    EXPECT_EQ(durationText(59.7), "1 min 0 s");
    EXPECT_EQ(durationText(200), "3 min 20 s");
    EXPECT_EQ(durationText(3660), "1 h 1 min");
}

TEST(Nearest, FindsASlipOfTheFinger) {
    const std::vector<std::string> known = {"overlap", "patch", "tolerance"};
    EXPECT_EQ(nearest("pach", known), "patch");
    EXPECT_EQ(nearest("tolerence", known), "tolerance");
    EXPECT_EQ(nearest("ovelrap", known), "overlap");
}

TEST(Nearest, IsSilentWhenNothingIsNear) {
    EXPECT_EQ(nearest("zzzzzz", {"overlap", "patch"}), "");
    EXPECT_EQ(nearest("patch", {}), "");
}

} // namespace texloom::test
