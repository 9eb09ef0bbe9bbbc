#include "core/base/error.h"
#include "core/volume/coloured_mesh.h"
#include "core/volume/point_samples.h"
#include "tests/support/volumes.h"

#include <gtest/gtest.h>

#include <limits>

namespace texloom::test {
namespace {

std::vector<float> sampledIn(const VolumeSource& source, const std::vector<Eigen::Vector3d>& points) {
    JobMonitor monitor;
    JobContext context(
        {0, 2, false}, [] { return false; }, monitor);
    return sampledAt(source, points, context);
}

TEST(PointSamples, ofALinearSolidAreExact) {
    const FunctionSource linear(
        [](auto x, auto y, auto z, int c) {
            return static_cast<double>(x) + 2 * static_cast<double>(y) - 0.5 * static_cast<double>(z) +
                   10 * c;
        },
        2);
    const std::vector<Eigen::Vector3d> points = {
        {0, 0, 0}, {31.75, 0.5, 31.25}, {-0.25, -32.5, 64}, {-33, 100.125, -7.5}};
    const std::vector<float> found = sampledIn(linear, points);
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t c = 0; c < 2; ++c)
            EXPECT_FLOAT_EQ(found[2 * i + c],
                            static_cast<float>(points[i].x() + 2 * points[i].y() - 0.5 * points[i].z() +
                                               10 * static_cast<double>(c)));
}

TEST(PointSamples, beyondASolidThatEndsAreZero) {
    const DenseSource dense(sampleVolume({4, 4, 4}, 1), DenseSource::Edge::Ends);
    const std::vector<float> found = sampledIn(dense, {{3, 3, 3}, {40, 0, 0}, {-9, 1, 1}});
    EXPECT_EQ(found[0], dense.volume()(3, 3, 3, 0));
    EXPECT_EQ(found[1], 0);
    EXPECT_EQ(found[2], 0);
}

TEST(PointSamples, refuseWhatIsNowhere) {
    const DenseSource dense(sampleVolume({4, 4, 4}, 1), DenseSource::Edge::Repeats);
    EXPECT_THROW(sampledIn(dense, {{std::numeric_limits<double>::quiet_NaN(), 0, 0}}), UsageError);
    EXPECT_THROW(sampledIn(dense, {{0, 1e15, 0}}), UsageError);
}

TEST(ColouredMesh, wantsThreeNumbersAVertexAndAKnownName) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
    mesh.triangles = {{0, 1, 2}};
    EXPECT_THROW(writeColouredMesh("mesh.ply", mesh, {0, 0, 0}), UsageError);
    EXPECT_THROW(writeColouredMesh("mesh.stl", mesh, std::vector<float>(9)), UsageError);
}

} // namespace
} // namespace texloom::test
