#include "core/math/poisson.h"
#include "tests/support/textures.h"

#include <gtest/gtest.h>

#include <cmath>

namespace texloom::test {
namespace {

double laplacian(const ImageView& f, int x, int y, int c) {
    double sum = 0;
    for (const auto& [dx, dy] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}})
        if (x + dx >= 0 && y + dy >= 0 && x + dx < f.width && y + dy < f.height)
            sum += static_cast<double>(f(x + dx, y + dy, c)) - static_cast<double>(f(x, y, c));
    return sum;
}

/// The values of one channel at the unknown pixels, by rows.
std::vector<float> valuesAt(const std::vector<std::uint8_t>& unknown, const PlaneView& plane) {
    std::vector<float> values;
    for (int y = 0; y < plane.height; ++y)
        for (int x = 0; x < plane.width; ++x)
            if (unknown[static_cast<std::size_t>(y * plane.width + x)] != 0)
                values.push_back(plane(x, y));
    return values;
}

TEST(Poisson, regionHasTheDivergenceInsideAndIsUntouchedOutside) {
    const Image divergence = noise({40, 30}, 1), before = noise({40, 30}, 1, 2);
    std::vector<std::uint8_t> unknown;
    for (int y = 0; y < 30; ++y)
        for (int x = 0; x < 40; ++x) // a disk, and a strip along the border
            unknown.push_back((x - 20) * (x - 20) + (y - 15) * (y - 15) < 100 || x < 3 ? 1 : 0);
    Image values = before;
    PoissonRegion(unknown, {40, 30}).solve(valuesAt(unknown, divergence.view().plane(0)), values.plane(0));
    for (int y = 0; y < 30; ++y)
        for (int x = 0; x < 40; ++x)
            if (unknown[static_cast<std::size_t>(y * 40 + x)] != 0) {
                EXPECT_NEAR(laplacian(values, x, y, 0), divergence(x, y, 0), 1e-5) << x << "," << y;
            } else {
                EXPECT_EQ(values(x, y, 0), before(x, y, 0));
            }
}

TEST(Poisson, largeRegionIsSolvedByIterationAsByFactors) {
    const Size size{150, 130};
    const Image divergence = noise(size, 2), before = noise(size, 2, 2);
    std::vector<std::uint8_t> unknown;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) // a ring, a strip along the border, and single pixels
            unknown.push_back(std::abs(std::hypot(x - 80, y - 60) - 40) < 15 || x < 9 ||
                              (x + 7 * y) % 31 == 0);
    Image direct = before, iterated = before;
    double last = 0;
    std::vector<float> wanted;
    for (int c = 0; c < 2; ++c) {
        const std::vector<float> one = valuesAt(unknown, divergence.view().plane(c));
        wanted.insert(wanted.end(), one.begin(), one.end());
    }
    solvePoisson(unknown, wanted, iterated, [&](double share) {
        EXPECT_GE(share, last);
        last = share;
    });
    EXPECT_GT(last, 0.9);
    const PoissonRegion region(unknown, size);
    for (int c = 0; c < 2; ++c) {
        region.solve(valuesAt(unknown, divergence.view().plane(c)), direct.plane(c));
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
                ASSERT_NEAR(iterated(x, y, c), direct(x, y, c), 2e-4) << x << "," << y;
    }
}

TEST(Poisson, theNumberOfStepsHardlyGrowsWithTheRegion) {
    // A band that touches given pixels above and below, and the image's border left and right.
    const auto stepsFor = [](int side) {
        const Image before = blobs({side, side}, 1);
        std::vector<std::uint8_t> unknown;
        for (int y = 0; y < side; ++y)
            unknown.insert(unknown.end(), static_cast<std::size_t>(side), y > 0 && y < side - 1 ? 1 : 0);
        const std::vector<float> divergence = valuesAt(unknown, noise({side, side}, 1).view().plane(0));
        Image values = before;
        int steps = 0;
        double last = -1;
        solvePoisson(unknown, divergence, values, [&](double share) {
            steps += share > last ? 1 : 0;
            last = std::max(last, share);
        });
        double largest = 0, residual = 0;
        std::size_t i = 0;
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                largest = std::max(largest, std::abs(static_cast<double>(values(x, y, 0))));
                if (unknown[static_cast<std::size_t>(y * side + x)] != 0)
                    residual = std::max(residual, std::abs(laplacian(values, x, y, 0) -
                                                           static_cast<double>(divergence[i++])));
                else
                    EXPECT_EQ(values(x, y, 0), before(x, y, 0));
            }
        EXPECT_LT(residual, 1e-6 * largest) << side;
        return steps;
    };
    EXPECT_LT(stepsFor(48), 20);
    EXPECT_LT(stepsFor(384), 28);
}

TEST(Poisson, regionGivesAnImageBackFromItsOwnLaplacian) {
    const Image image = blobs({33, 27}, 1);
    Image divergence({33, 27}, 1), values = image;
    std::vector<std::uint8_t> unknown(33 * 27, 1);
    unknown[0] = 0;
    for (int y = 0; y < 27; ++y)
        for (int x = 0; x < 33; ++x) {
            divergence(x, y, 0) = static_cast<float>(laplacian(image, x, y, 0));
            if (x + y > 0)
                values(x, y, 0) = 0;
        }
    PoissonRegion(unknown, {33, 27}).solve(valuesAt(unknown, divergence.view().plane(0)), values.plane(0));
    for (int y = 0; y < 27; ++y)
        for (int x = 0; x < 33; ++x)
            EXPECT_NEAR(values(x, y, 0), image(x, y, 0), 1e-4);
}

TEST(Poisson, cosinesSolveWholeImages) {
    const Image image = blobs({70, 45}, 2);
    Image divergence(image.size(), 2);
    for (int c = 0; c < 2; ++c)
        for (int y = 0; y < 45; ++y)
            for (int x = 0; x < 70; ++x)
                divergence(x, y, c) = static_cast<float>(laplacian(image, x, y, c));
    const Image found = solvePoisson(divergence, channelMeans(image));
    for (int c = 0; c < 2; ++c)
        for (int y = 0; y < 45; ++y)
            for (int x = 0; x < 70; ++x) {
                EXPECT_NEAR(found(x, y, c), image(x, y, c), 1e-5);
                EXPECT_NEAR(laplacian(found, x, y, c), divergence(x, y, c), 1e-5);
            }
}

} // namespace
} // namespace texloom::test
