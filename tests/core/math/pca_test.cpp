#include "core/job/random.h"
#include "core/math/pca.h"

#include <gtest/gtest.h>

#include <cmath>

namespace texloom::test {
namespace {

TEST(Pca, findsTheAxesThatPointsWereSpreadAlong) {
    const Random random(4);
    std::vector<double> points;
    for (int i = 0; i < 20000; ++i) {
        const double along = 3 * random.normal(i, 0), across = 0.5 * random.normal(i, 1);
        points.insert(points.end(), {7 + 0.6 * along - 0.8 * across, 1 + 0.8 * along + 0.6 * across});
    }
    const PrincipalAxes axes = principalAxes(points, 2, 2);
    EXPECT_NEAR(axes.mean[0], 7, 0.05);
    EXPECT_NEAR(axes.mean[1], 1, 0.05);
    EXPECT_NEAR(axes.variances[0], 9, 0.3);
    EXPECT_NEAR(axes.variances[1], 0.25, 0.01);
    EXPECT_NEAR(axes.axis(0)[0], 0.6, 0.01);
    EXPECT_NEAR(axes.axis(0)[1], 0.8, 0.01);
    EXPECT_NEAR(axes.axis(0)[0] * axes.axis(1)[0] + axes.axis(0)[1] * axes.axis(1)[1], 0, 1e-12);
}

TEST(Pca, ofOneVectorHasNoVariance) {
    const PrincipalAxes axes = principalAxes(std::vector<double>{1, 2, 3}, 3, 3);
    for (const double variance : axes.variances)
        EXPECT_EQ(variance, 0);
}

} // namespace
} // namespace texloom::test
