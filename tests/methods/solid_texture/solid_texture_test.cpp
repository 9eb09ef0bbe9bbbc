#include "core/volume/volume_source.h"
#include "tests/support/stopped_run.h"

#include <gtest/gtest.h>

namespace texloom::test::solid_texture_tests {
namespace {

TEST(SolidTexture, trainingThatIsStoppedKeepsItsGeneratorAndSaysHowFarItCame) {
    const Result result =
        stoppedAtOnce("solid-texture", {{"train-side", 32}, {"iterations", 100000}}, {40, 30});
    ASSERT_TRUE(result.stoppedAt);
    EXPECT_LT(*result.stoppedAt, 0.5);
    EXPECT_TRUE(result.synthesis.outputs.first<VolumeSource>("volume"));
    EXPECT_EQ(result.synthesis.outputs.at("solid-generator").size(), 1U);
    EXPECT_EQ(result.synthesis.image.size(), (Size{40, 30}));
}

} // namespace
} // namespace texloom::test::solid_texture_tests
