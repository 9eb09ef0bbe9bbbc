#include "core/io/recipe.h"
#include "core/session/run/edited_exemplar.h"
#include "core/tools/edits.h"
#include "tests/core/session/sample_run.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <numbers>

/// A tool that is one file, tests/doors/ripple.cpp, goes wherever a tool goes.
namespace texloom::test {

namespace {

/// How far the kernel that resamples may miss a ramp between two pixels.
constexpr double kRampError = 0.02;
const ExemplarEdit kRipple = {{"ripple", 3.0}, {"length", 12}};

} // namespace

TEST(ToolDoors, ARippleMovesRowsByItsSine) {
    Image ramp(Size{40, 24}, 1);
    for (int y = 0; y < 24; ++y)
        for (int x = 0; x < 40; ++x)
            ramp(x, y, 0) = static_cast<float>(x);
    RunExemplar exemplar;
    exemplar.image.image = std::make_shared<const Image>(std::move(ramp));
    const RunExemplar made = edited(exemplar, {kRipple});
    for (int y = 0; y < 24; ++y)
        for (int x = 8; x < 32; ++x)
            EXPECT_NEAR((*made.image.image)(x, y, 0), x + 3 * std::sin(2 * std::numbers::pi * (y + 0.5) / 12),
                        kRampError);
}

TEST(ToolDoors, ARecipeKeepsIt) {
    SampleRun sample;
    sample.input.exemplars.front() = edited(sample.input.exemplars.front(), {kRipple, {{"rotate", 5.0}}});
    const Result first = sample.run();
    const std::string json = first.plan.recipe.toJson(sample.folder.path());
    EXPECT_EQ(nlohmann::json::parse(json)["exemplars"][0]["edits"][0],
              (nlohmann::json{{"ripple", 3.0}, {"length", 12}}));
    sample.input = loadRecipe(Recipe::fromJson(json, sample.folder.path()));
    EXPECT_TRUE(samePixels(first.synthesis.image, sample.run().synthesis.image));
}

} // namespace texloom::test
