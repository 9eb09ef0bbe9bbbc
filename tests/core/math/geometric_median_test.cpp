#include "core/job/random.h"
#include "core/math/geometric_median.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace texloom::test {

namespace {

struct Cloud {
    std::vector<float> points, weights;
    int count, dimension;

    Cloud(int number, int size, int dimensions) : count(size), dimension(dimensions) {
        const Random random(8);
        for (int i = 0; i < count * dimension; ++i)
            points.push_back(static_cast<float>(random.normal(number, i)));
        for (int i = 0; i < count; ++i)
            weights.push_back(static_cast<float>(0.5 + random.uniform(number, i, 9)));
    }

    double sumAt(const float* x) const {
        double sum = 0;
        for (int i = 0; i < count; ++i) {
            double square = 0;
            for (int d = 0; d < dimension; ++d)
                square += std::pow(
                    static_cast<double>(x[d] - points[static_cast<std::size_t>(i * dimension + d)]), 2);
            sum += static_cast<double>(weights[static_cast<std::size_t>(i)]) * std::sqrt(square);
        }
        return sum;
    }
};

} // namespace

TEST(GeometricMedian, noStepToAnySideIsBetter) {
    for (int number = 0; number < 20; ++number) {
        const Cloud cloud(number, 4 + number, 1 + number % 4);
        std::array<float, 4> x{};
        geometricMedian(cloud.points.data(), cloud.weights.data(), cloud.count, cloud.dimension, x.data());
        const double found = cloud.sumAt(x.data());
        for (int d = 0; d < cloud.dimension; ++d)
            for (const float step : {-0.01F, 0.01F}) {
                std::array<float, 4> beside = x;
                beside[static_cast<std::size_t>(d)] += step;
                EXPECT_GE(cloud.sumAt(beside.data()), found - 1e-6);
            }
    }
}

TEST(GeometricMedian, douglasRachfordAgreesWithWeiszfeld) {
    for (int number = 0; number < 30; ++number) {
        const Cloud cloud(number, 16, 3);
        std::array<float, 3> a{}, b{};
        geometricMedian(cloud.points.data(), cloud.weights.data(), 16, 3, a.data());
        geometricMedianByDouglasRachford(cloud.points.data(), cloud.weights.data(), 16, 3, b.data());
        for (std::size_t d = 0; d < 3; ++d)
            EXPECT_NEAR(a[d], b[d], 1e-4) << "cloud " << number;
    }
}

TEST(GeometricMedian, ofAHeavyPointIsThatPoint) {
    const std::vector<float> points = {0, 0, 1, 0, 0, 1, 5, 5}, weights = {3, 1, 1, 0.9F};
    std::array<float, 2> x = {2, 2};
    geometricMedian(points.data(), weights.data(), 4, 2, x.data());
    EXPECT_NEAR(x[0], 0, 1e-4);
    EXPECT_NEAR(x[1], 0, 1e-4);
    std::array<float, 2> onPoint = {5, 5}; // a start on one of the points is left
    geometricMedian(points.data(), weights.data(), 4, 2, onPoint.data());
    EXPECT_NEAR(onPoint[0], 0, 1e-4);
}

TEST(GeometricMedian, ofEqualPointsIsWhereTheyAre) {
    const std::vector<float> points = {2, 3, 2, 3}, weights = {1, 1};
    std::array<float, 2> x = {2, 3};
    geometricMedian(points.data(), weights.data(), 2, 2, x.data());
    geometricMedianByDouglasRachford(points.data(), weights.data(), 2, 2, x.data());
    EXPECT_EQ(x[0], 2);
    EXPECT_EQ(x[1], 3);
}

} // namespace texloom::test
