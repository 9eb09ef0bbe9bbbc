#include "core/session/run/run.h"
#include "core/volume/volume_source.h"
#include "tests/support/textures.h"

#include <gtest/gtest.h>

#include <memory>

namespace texloom::test {
namespace {

TEST(SolidTexture, trainingThatIsStoppedKeepsItsGeneratorAndSaysHowFarItCame) {
    RunInput input;
    input.steps.front() = {"solid-texture", {{"train-side", 32}, {"iterations", 100000}}};
    RunExemplar& exemplar = input.exemplars.emplace_back();
    exemplar.image.path = "made up";
    exemplar.image.image = std::make_shared<const Image>(blobs({48, 48}, 3));
    input.size = {40, 30};
    input.judged = false;
    const auto job = startRun(planRun(input), false);
    job->stopAndKeep();
    const Outcome<Result> outcome = job->take();
    ASSERT_TRUE(std::holds_alternative<Result>(outcome));
    const auto& result = std::get<Result>(outcome);
    ASSERT_TRUE(result.stoppedAt);
    EXPECT_LT(*result.stoppedAt, 0.5);
    EXPECT_TRUE(result.synthesis.outputs.first<VolumeSource>("volume"));
    EXPECT_EQ(result.synthesis.outputs.at("solid-generator").size(), 1U);
    EXPECT_EQ(result.synthesis.image.size(), input.size);
}

} // namespace
} // namespace texloom::test
