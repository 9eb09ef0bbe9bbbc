// Which methods are named first for a texture, and why.

#include "core/methods/advice.h"
#include "tests/support/lattices.h"
#include "tests/support/textures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace texloom::test::advice_tests {
namespace {

using testing::HasSubstr;

TextureCharacter character(double regularity, double longest, double grain) {
    TextureCharacter made;
    made.size = {200, 200};
    made.regularity = regularity;
    made.period = 20;
    made.shortest = made.longest = longest;
    made.grain = grain;
    return made;
}

const Suits& fittest(const TextureCharacter& texture) {
    return adviceFor(texture).methods.front()->info().suits;
}

int best(int Suits::*kind) {
    int most = 0;
    for (const Method& method : methods())
        most = std::max(most, method.info().suits.*kind);
    return most;
}

TEST(Advice, aTextureOfOneKindGetsTheMethodThatSuitsThatKindBest) {
    EXPECT_EQ(fittest(character(1, 10, 0)).regular, best(&Suits::regular));
    EXPECT_EQ(fittest(character(0, 2, 1)).grain, best(&Suits::grain));
    EXPECT_EQ(fittest(character(0, 10, 0)).objects, best(&Suits::objects));
    EXPECT_EQ(fittest(character(0, 60, 0)).large, best(&Suits::large));
}

TEST(Advice, sharesOfKindsMakeUpTheWholeAndFollowTheTexture) {
    for (const double regularity : {0.0, 0.4, 0.6, 1.0})
        for (const double longest : {1.0, 9.0, 25.0, 90.0})
            for (const double grain : {0.0, 0.5, 1.0}) {
                const KindShares kinds = kindsOf(character(regularity, longest, grain));
                EXPECT_NEAR(kinds.regular + kinds.grain + kinds.objects + kinds.large, 1, 1e-12);
                for (const double share : {kinds.regular, kinds.grain, kinds.objects, kinds.large})
                    EXPECT_GE(share, 0);
            }
    EXPECT_GT(kindsOf(character(0.7, 10, 0)).regular, kindsOf(character(0.5, 10, 0)).regular);
    EXPECT_GT(kindsOf(character(0, 30, 0)).large, kindsOf(character(0, 20, 0)).large);
    EXPECT_GT(kindsOf(character(0, 4, 0.9)).grain, kindsOf(character(0, 4, 0.3)).grain);
}

TEST(Advice, theReasonNamesWhatWasMeasured) {
    EXPECT_THAT(adviceFor(character(1, 10, 0)).reason.text(), HasSubstr("every 20 px"));
    EXPECT_THAT(adviceFor(character(0, 3, 1)).reason.text(), HasSubstr("3 px"));
    EXPECT_THAT(adviceFor(character(0, 9, 0)).reason.text(), HasSubstr("9 px"));
    EXPECT_THAT(adviceFor(character(0, 60, 0)).reason.text(), HasSubstr("60 px of 200 × 200 px"));
    TextureCharacter rows = character(1, 10, 0);
    rows.rowsOnly = true;
    EXPECT_THAT(adviceFor(rows).reason.text(), HasSubstr("rows 20 px apart"));
}

TEST(Advice, namesEachMethodThatMakesMoreOfAnExemplarOnce) {
    const MethodAdvice advice = adviceFor(character(0, 10, 0));
    const std::set<const Method*> once(advice.methods.begin(), advice.methods.end());
    EXPECT_EQ(once.size(), advice.methods.size());
    for (const Method& method : methods()) {
        EXPECT_EQ(once.contains(&method), method.info().suits.any()) << method.id();
        const Suits& suits = method.info().suits;
        for (const int value : {suits.regular, suits.grain, suits.objects, suits.large})
            EXPECT_TRUE(value >= 0 && value <= 5) << method.id();
    }
}

TEST(Advice, knowsMadeUpTextures) {
    EXPECT_GE(fittest(characterOf(regularTexture({200, 200}, 3, {{33, 0}, {0, 25}}, {}, 1))).regular, 4);
    EXPECT_GE(fittest(characterOf(noise({128, 128}, 3))).grain, 4);
}

} // namespace
} // namespace texloom::test::advice_tests
