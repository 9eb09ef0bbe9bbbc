#include "core/base/error.h"
#include "core/io/image_file.h"
#include "core/volume/coloured_mesh.h"
#include "core/volume/mesh_file.h"
#include "core/volume/solid_placement.h"
#include "core/volume/volume_file.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/volumes.h"

#include <Eigen/LU>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

namespace texloom::test {
namespace {

/// Colours are the coordinates.
std::shared_ptr<const VolumeSource> coordinates() {
    return std::make_shared<FunctionSource>(
        [](std::int64_t x, std::int64_t y, std::int64_t z, int c) {
            return static_cast<double>(c == 0 ? x : c == 1 ? y : z);
        },
        3);
}

Mesh placedTriangle() {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}};
    mesh.normals.assign(3, Eigen::Vector3f::UnitZ());
    mesh.triangles = {{0, 1, 2}};
    return mesh;
}

double area(const Mesh& mesh) {
    double sum = 0;
    for (const auto& [a, b, c] : mesh.triangles) {
        const Eigen::Vector3f p = mesh.positions[b] - mesh.positions[a],
                              q = mesh.positions[c] - mesh.positions[a];
        const double cross = static_cast<double>(p.x() * q.y() - p.y() * q.x());
        sum += std::abs(cross) / 2;
    }
    return sum;
}

TEST(SolidPlacement, TurnsScalesAndMoves) {
    SolidPlacement placement;
    placement.scale = 3;
    placement.angles = {0, 0, std::numbers::pi / 2};
    placement.offset = {10, -20, 30};
    EXPECT_LT((placement.at({1, 0, 0}) - Eigen::Vector3d(10, -17, 30)).norm(), 1e-12);
    placement.angles = {std::numbers::pi / 2, 0, std::numbers::pi / 2}; // about x first
    EXPECT_LT((placement.at({0, 1, 0}) - Eigen::Vector3d(10, -20, 33)).norm(), 1e-12);
    const Eigen::Matrix3d turn = placement.rotation();
    EXPECT_LT((turn * turn.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-12);
    EXPECT_NEAR(turn.determinant(), 1, 1e-12);
}

TEST(SolidPlacement, VerticesHaveTheColourOfTheirVoxel) {
    SolidPlacement placement;
    placement.scale = 8;
    placement.angles = {0.3, -0.4, 1.1};
    placement.offset = {-5.5, 7, 100};
    TestContext context;
    const Mesh mesh = placedTriangle();
    const std::vector<float> colours = vertexColours(mesh, *coordinates(), placement, context);
    ASSERT_EQ(colours.size(), 9U);
    for (std::size_t i = 0; i < 3; ++i) {
        const Eigen::Vector3d at = placement.at(mesh.positions[i].cast<double>());
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(colours[3 * i + c], at[static_cast<Eigen::Index>(c)], 1e-4);
    }
}

TEST(SolidPlacement, SolidsOfOneChannelAreGrey) {
    const FunctionSource grey(
        [](std::int64_t x, std::int64_t, std::int64_t, int) { return 0.1 * static_cast<double>(x); });
    TestContext context;
    const std::vector<float> colours = vertexColours(placedTriangle(), grey, {}, context);
    EXPECT_FLOAT_EQ(colours[3], 0.1F);
    EXPECT_FLOAT_EQ(colours[4], 0.1F);
    EXPECT_FLOAT_EQ(colours[5], 0.1F);
}

TEST(SolidPlacement, WhatCannotBeColouredIsRefused) {
    TestContext context;
    EXPECT_THROW(vertexColours(Mesh(), *coordinates(), {}, context), UsageError);
    SolidPlacement none;
    none.scale = 0;
    EXPECT_THROW(vertexColours(placedTriangle(), *coordinates(), none, context), UsageError);
    SolidPlacement far;
    far.offset.x() = 1e13;
    EXPECT_THROW(vertexColours(placedTriangle(), *coordinates(), far, context), UsageError);
}

TEST(RefinedMesh, HasShortEdgesAndTheSameSurface) {
    TestContext context;
    const Mesh fine = refined(placedTriangle(), 0.3, 1'000'000, context);
    EXPECT_EQ(fine.triangles.size(), 64U); // √5 halved three times
    EXPECT_EQ(fine.positions.size(), 45U) << "neighbours share what they have in common";
    EXPECT_EQ(fine.normals.size(), fine.positions.size());
    EXPECT_NEAR(area(fine), 1, 1e-6);
    EXPECT_EQ(refined(placedTriangle(), 0.3, 16, context).triangles.size(), 16U);
    EXPECT_EQ(refined(placedTriangle(), 10, 16, context).triangles.size(), 1U);
}

TEST(ColouredMesh, HasItsRecipe) {
    const TemporaryFolder folder;
    TestContext context;
    const std::vector<float> colours(9, 0.5F);
    const std::string recipe = "{\n  \"seed\": 7\n}";
    for (const char* name : {"a.ply", "a.obj", "a.glb"}) {
        writeColouredMesh(folder.path() / name, placedTriangle(), colours, {}, recipe);
        EXPECT_THAT(readText(folder.path() / name), testing::HasSubstr("seed")) << name;
        EXPECT_EQ(readMesh(folder.path() / name, context).triangles.size(), 1U) << name;
    }
}

TEST(FileBox, OfTooManyVoxelsIsRefusedWithBothNumbers) {
    checkFileBox({0, 0, 0, {512, 512, 512}});
    try {
        checkFileBox({0, 0, 0, {10000, 10000, 10000}});
        FAIL();
    } catch (const UsageError& error) {
        const std::string sentence = error.what();
        EXPECT_THAT(sentence, testing::HasSubstr("10000 × 10000 × 10000"));
        EXPECT_THAT(sentence, testing::HasSubstr("536"));
    }
}

} // namespace
} // namespace texloom::test
