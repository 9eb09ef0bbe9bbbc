#include "core/base/param.h"
#include "tests/core/refusal.h"

#include <gmock/gmock.h>

#include <limits>

namespace texloom::test {

namespace {

enum class Join { Hard, Soft, None };

struct Sample {
    bool mirror = true;
    int patch = 40;
    double overlap = 0.25;
    Join join = Join::Soft;
};

Param mirror() {
    return field(&Sample::mirror, "mirror", "Mirror");
}
Param patch() {
    return field(&Sample::patch, "patch", "Patch size").range(4, 512).unit("px").scaled(0.16);
}
Param overlap() {
    return field(&Sample::overlap, "overlap", "Overlap").range(0.02, 0.5);
}
Param join() {
    return field(&Sample::join, "join", "Join")
        .choices({{"hard", "Hard"}, {"soft", "Soft"}, {"no-join", "None"}})
        .when("mirror", true);
}

} // namespace

TEST(Param, TakesItsTypeFromTheMember) {
    EXPECT_EQ(mirror().type(), Param::Type::Toggle);
    EXPECT_EQ(patch().type(), Param::Type::Integer);
    EXPECT_EQ(overlap().type(), Param::Type::Real);
    EXPECT_EQ(join().type(), Param::Type::Choice);
}

TEST(Param, TakesItsDefaultFromTheMember) {
    EXPECT_EQ(mirror().defaultFor(0), Value(true));
    EXPECT_EQ(patch().defaultFor(0), Value(40));
    EXPECT_EQ(overlap().defaultFor(0), Value(0.25));
    EXPECT_EQ(join().defaultFor(0), Value("soft"));
}

TEST(Param, ReadsTogglesInWords) {
    for (const char* yes : {"on", "true", "yes", "1"})
        EXPECT_EQ(mirror().parse(yes), Value(true)) << yes;
    for (const char* no : {"off", "false", "no", "0"})
        EXPECT_EQ(mirror().parse(no), Value(false)) << no;
}

TEST(Param, RefusesAToggleThatIsNone) {
    EXPECT_THAT([] { mirror().parse("maybe"); }, usageRefusal("mirror", "maybe", "on or off"));
}

TEST(Param, ReadsWholeNumbers) {
    EXPECT_EQ(patch().parse("4"), Value(4));
    EXPECT_EQ(patch().parse("512"), Value(512));
    EXPECT_EQ(patch().parse("40.0"), Value(40));
}

TEST(Param, NamesValueAndLimitsBelowTheRange) {
    EXPECT_THAT([] { patch().parse("3"); }, usageRefusal("patch = 3", "Patch size", "4 to 512 px"));
}

TEST(Param, NamesValueAndLimitsAboveTheRange) {
    EXPECT_THAT([] { overlap().parse("0.7"); }, usageRefusal("overlap = 0.7", "0.02 to 0.5"));
}

TEST(Param, RefusesAFractionWhereNumbersAreWhole) {
    EXPECT_THAT([] { patch().parse("4.5"); }, usageRefusal("patch = 4.5"));
}

TEST(Param, RefusesWholeNumbersThatNoIntHolds) {
    const Param free = field(&Sample::patch, "patch", "Patch size");
    EXPECT_THAT([&] { free.parse("1e10"); }, usageRefusal("patch"));
    EXPECT_EQ(free.parse("-2147483647"), Value(-2147483647));
}

TEST(Param, RefusesNoNumber) {
    EXPECT_THAT([] { overlap().parse("half"); }, usageRefusal("overlap = half"));
    EXPECT_THAT([] { overlap().parse(""); }, usageRefusal("overlap", "(nothing)"));
    for (const char* text : {"0x10", " 0.2", "0.2 ", "0,2"})
        EXPECT_THAT([&] { overlap().parse(text); }, usageRefusal(text, "decimal digits")) << text;
    for (const char* text : {"1e-400", "1e400"})
        EXPECT_THAT([&] { overlap().parse(text); }, usageRefusal(text, "too near 0")) << text;
}

TEST(Param, RefusesValuesThatAreNotFinite) {
    const Param free = field(&Sample::overlap, "overlap", "Overlap");
    EXPECT_THROW(free.checked(std::numeric_limits<double>::quiet_NaN()), UsageError);
    EXPECT_THROW(free.checked(std::numeric_limits<double>::infinity()), UsageError);
}

TEST(Param, AllowsBothEndsOfTheRange) {
    EXPECT_EQ(overlap().checked(0.02), Value(0.02));
    EXPECT_EQ(overlap().checked(0.5), Value(0.5));
}

TEST(Param, TakesAWholeNumberForAReal) {
    const Param free = field(&Sample::overlap, "overlap", "Overlap");
    EXPECT_EQ(free.checked(2), Value(2.0));
}

TEST(Param, RefusesValuesOfAnotherKind) {
    EXPECT_THROW(patch().checked(true), UsageError);
    EXPECT_THROW(patch().checked(std::string("40")), UsageError);
    EXPECT_THROW(overlap().checked(false), UsageError);
    EXPECT_THROW(mirror().checked(1), UsageError);
    EXPECT_THROW(join().checked(0), UsageError);
}

TEST(Param, TakesTogglesOfOldRecipesAsYesAndNo) {
    const Param light = field(&Sample::join, "light", "Light")
                            .choices({{"automatic", "Automatic"}, {"yes", "Always"}, {"no", "Never"}});
    EXPECT_EQ(light.checked(true), Value("yes"));
    EXPECT_EQ(light.checked(false), Value("no"));
    EXPECT_THAT([&] { light.checked(1); }, usageRefusal("light", "1", "automatic, yes, no"));
    EXPECT_THAT([] { join().checked(true); }, usageRefusal("join", "hard, soft, no-join"));
}

TEST(Param, RefusesAChoiceThatIsNoneAndListsThem) {
    EXPECT_THAT([] { join().parse("sharp"); }, usageRefusal("join = sharp", "hard, soft, no-join"));
}

TEST(Param, ScalesItsDefaultWithTheExemplar) {
    EXPECT_EQ(patch().defaultFor(250), Value(40));
    EXPECT_EQ(patch().defaultFor(1000), Value(160));
}

TEST(Param, KeepsAScaledDefaultWithinTheRange) {
    EXPECT_EQ(patch().defaultFor(3), Value(4));
    EXPECT_EQ(patch().defaultFor(100000), Value(512));
}

TEST(Param, AppliesOnlyUnderItsCondition) {
    EXPECT_TRUE(join().applies({{"mirror", true}}));
    EXPECT_FALSE(join().applies({{"mirror", false}}));
    EXPECT_FALSE(join().applies({}));
    EXPECT_TRUE(patch().applies({}));
}

TEST(Param, AssignsEachChoiceItsEnumerator) {
    for (const auto& [id, expected] : std::vector<std::pair<std::string, Join>>{
             {"hard", Join::Hard}, {"soft", Join::Soft}, {"no-join", Join::None}}) {
        Sample sample;
        join().assign(&sample, id);
        EXPECT_EQ(sample.join, expected) << id;
    }
}

TEST(Param, AssignsNumbersAndToggles) {
    Sample sample;
    mirror().assign(&sample, false);
    patch().assign(&sample, 12);
    overlap().assign(&sample, 0.125);
    EXPECT_FALSE(sample.mirror);
    EXPECT_EQ(sample.patch, 12);
    EXPECT_EQ(sample.overlap, 0.125);
}

TEST(Param, SaysItsLimits) {
    EXPECT_EQ(mirror().limits().text(), "on or off");
    EXPECT_EQ(patch().limits().text(), "4 to 512 px");
    EXPECT_EQ(join().limits().text(), "hard, soft, no-join");
}

TEST(Value, ReadsBackFromItsText) {
    EXPECT_EQ(mirror().parse(toText(Value(false))), Value(false));
    EXPECT_EQ(patch().parse(toText(Value(77))), Value(77));
    EXPECT_EQ(overlap().parse(toText(Value(0.1))), Value(0.1));
    EXPECT_EQ(join().parse(toText(Value("no-join"))), Value("no-join"));
}

} // namespace texloom::test
