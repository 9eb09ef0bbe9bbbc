#include "core/color/color_pipeline.h"
#include "core/render/solid.h"
#include "tests/core/render/straight_on.h"
#include "tests/support/volumes.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>

namespace texloom::test {
namespace {

using Eigen::Vector3f;

/// Colours are shares of the way through a block of 65 voxels.
std::shared_ptr<const BlockCache> ramps() {
    return std::make_shared<const BlockCache>(std::make_shared<FunctionSource>(
        [](std::int64_t x, std::int64_t y, std::int64_t z, int c) {
            return static_cast<double>(c == 0 ? x : c == 1 ? y : z) / 64;
        },
        3));
}

const Box kBlock{0, 0, 0, {65, 65, 65}};

Environment white(JobContext& context) {
    Image panorama({64, 32}, 3);
    for (int c = 0; c < 3; ++c)
        for (int y = 0; y < 32; ++y)
            std::fill_n(panorama.plane(c).row(y), 64, 1.0F);
    return Environment(panorama, context);
}

Look coloursStraightOn() {
    Look look = straightOn();
    look.shown = Shown::Color;
    return look;
}

/// A picture in the space of the voxels: renders are linear.
Image picture(const RenderMesh& mesh, const SolidPlacement& placement, const Look& look, int threads = 2) {
    TestContext context(threads);
    Image seen =
        rendered(mesh, *ramps(), placement, white(context), look, {64, 64}, std::nullopt, context).image;
    color::toWorking(seen, "linear");
    return seen;
}

double area(const RenderMesh& mesh) {
    double sum = 0;
    for (const auto& [a, b, c] : mesh.mesh.triangles) {
        const auto& p = mesh.mesh.positions;
        sum += static_cast<double>((p[b] - p[a]).cross(p[c] - p[a]).norm()) / 2;
    }
    return sum;
}

/// By the divergence theorem, which wants a closed surface that is seen from outside.
double volume(const RenderMesh& mesh) {
    double sum = 0;
    for (const auto& [a, b, c] : mesh.mesh.triangles) {
        const auto& p = mesh.mesh.positions;
        sum += static_cast<double>(p[a].dot(p[b].cross(p[c]))) / 6;
    }
    return sum;
}

TEST(CarvedBlock, HasWhatIsLeft) {
    const Vector3f sides(2, 4, 6);
    const double unit = 2 / static_cast<double>(sides.norm());
    const double whole = 48 * unit * unit * unit, surface = 88 * unit * unit;
    const Vector3f cut(0.25F, 0.5F, 0.75F);
    EXPECT_NEAR(volume(carvedBlock(sides, CutAway::Nothing, cut)), whole, 1e-5);
    EXPECT_NEAR(area(carvedBlock(sides, CutAway::Nothing, cut)), surface, 1e-5);
    const RenderMesh corner = carvedBlock(sides, CutAway::Corner, cut);
    EXPECT_NEAR(volume(corner), whole * (1 - 0.75 * 0.5 * 0.25), 1e-5);
    EXPECT_NEAR(area(corner), surface, 1e-5) << "what a corner takes away it lays open";
    EXPECT_NEAR(volume(carvedBlock(sides, CutAway::X, cut)), whole * 0.25, 1e-5);
    EXPECT_NEAR(volume(carvedBlock(sides, CutAway::Y, cut)), whole * 0.5, 1e-5);
    EXPECT_NEAR(volume(carvedBlock(sides, CutAway::Z, cut)), whole * 0.75, 1e-5);
    EXPECT_NEAR(corner.radius, 1, 1e-5);
    for (std::size_t t = 0; t < corner.mesh.triangles.size(); ++t) {
        const auto& [a, b, c] = corner.mesh.triangles[t];
        const auto& p = corner.mesh.positions;
        const Vector3f flat = (p[b] - p[a]).cross(p[c] - p[a]).normalized();
        EXPECT_GT(flat.dot(corner.mesh.normals[a]), 0.99F);
    }
}

TEST(CarvedBlock, CutsAtTheEndsLeaveAllOrNothingOfASide) {
    const Vector3f sides(1, 1, 1);
    const double unit = std::pow(2 / std::sqrt(3.0), 3);
    EXPECT_NEAR(volume(carvedBlock(sides, CutAway::X, {1, 1, 1})), unit, 1e-5);
    EXPECT_NEAR(volume(carvedBlock(sides, CutAway::Corner, {1, 0, 0})), unit, 1e-5);
    EXPECT_NEAR(volume(carvedBlock(sides, CutAway::Corner, {0, 0, 0})), 0, 1e-5);
}

TEST(SolidPicture, ABlockHasTheColoursOfItsVoxels) {
    const Image seen = picture(carvedBlock(sidesOf(kBlock), CutAway::Nothing, {0, 0, 0}), placementIn(kBlock),
                               coloursStraightOn());
    // The face in front is at z = 0, x to the right and y down.
    EXPECT_NEAR(seen(32, 32, 0), 0.5, 0.03);
    EXPECT_NEAR(seen(32, 32, 1), 0.5, 0.03);
    EXPECT_NEAR(seen(32, 32, 2), 0, 1e-5);
    EXPECT_GT(seen(40, 32, 0), seen(24, 32, 0) + 0.2F);
    EXPECT_GT(seen(32, 40, 1), seen(32, 24, 1) + 0.2F);
    EXPECT_EQ(seen(0, 0, 3), 0);
}

TEST(SolidPicture, TheCutShowsTheSliceThroughItsPoint) {
    const Vector3f cut(0.5F, 0.5F, 0.25F); // z from the viewer's side: three quarters of the way
    const Image seen =
        picture(carvedBlock(sidesOf(kBlock), CutAway::Z, cut), placementIn(kBlock), coloursStraightOn());
    EXPECT_NEAR(seen(32, 32, 2), 0.75, 1e-4);
}

TEST(SolidPicture, AMeshIsColouredWithoutPlacesInATexture) {
    RenderMesh sphere = renderMesh(BasicShape::Sphere);
    SolidPlacement placement;
    placement.scale = 32;
    placement.offset = {32, 32, 32};
    const Image seen = picture(sphere, placement, coloursStraightOn());
    EXPECT_NEAR(seen(32, 32, 2), 1, 0.03) << "its front is at z = 1";
    EXPECT_GT(seen(44, 32, 0), seen(20, 32, 0) + 0.3F);
    EXPECT_LT(seen(32, 44, 1), seen(32, 20, 1) - 0.3F) << "y points up in space";
    for (auto& uv : sphere.mesh.uvs)
        uv = {0.5F, 0.5F};
    const Image again = picture(sphere, placement, coloursStraightOn());
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            ASSERT_EQ(seen(x, y, 0), again(x, y, 0));
}

TEST(SolidPicture, IsTheSameForAnyNumberOfThreads) {
    Look look;
    look.samples = 2;
    const RenderMesh mesh = carvedBlock(sidesOf(kBlock), CutAway::Corner, {0.3F, 0.6F, 0.4F});
    const Image one = picture(mesh, placementIn(kBlock), look, 1),
                two = picture(mesh, placementIn(kBlock), look, 2);
    for (int c = 0; c < 4; ++c)
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x)
                ASSERT_EQ(one(x, y, c), two(x, y, c));
}

TEST(SolidPicture, WhatIsNotThereInTimeIsGreyAndSaid) {
    TestContext context;
    const auto solid = ramps();
    const RenderMesh mesh = carvedBlock(sidesOf(kBlock), CutAway::Nothing, {0, 0, 0});
    const Environment light = white(context);
    const SolidPicture early = rendered(mesh, *solid, placementIn(kBlock), light, coloursStraightOn(),
                                        {16, 16}, std::chrono::milliseconds(-1), context);
    EXPECT_FALSE(early.whole);
    EXPECT_EQ(early.image(8, 8, 0), early.image(8, 8, 2));
    EXPECT_TRUE(rendered(mesh, *solid, placementIn(kBlock), light, coloursStraightOn(), {16, 16},
                         std::nullopt, context)
                    .whole);
}

TEST(SolidPicture, AWhiteSolidInWhiteLightIsWhite) {
    TestContext context;
    const BlockCache solid(
        std::make_shared<FunctionSource>([](std::int64_t, std::int64_t, std::int64_t, int) { return 1.0; }));
    Look look = coloursStraightOn();
    look.shown = Shown::Lit;
    const SolidPicture lit = rendered(renderMesh(BasicShape::Sphere), solid, {}, white(context), look,
                                      {64, 64}, std::nullopt, context);
    EXPECT_NEAR(lit.image(32, 32, 0), 1, 0.02);
    EXPECT_NEAR(lit.image(32, 20, 1), 1, 0.02);
}

} // namespace
} // namespace texloom::test
