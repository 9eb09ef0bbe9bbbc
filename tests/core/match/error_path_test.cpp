#include "core/job/random.h"
#include "core/match/error_path.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

namespace texloom::test {
namespace {

struct Band {
    int length, width;
    std::vector<float> errors;

    Band(int l, int w, std::uint64_t seed) : length(l), width(w) {
        const Random random(seed);
        for (int i = 0; i < l * w; ++i)
            errors.push_back(static_cast<float>(random.uniform(i, 0)));
    }
    float at(int along, int across) const { return errors[static_cast<std::size_t>(along * width + across)]; }
    double costOf(const std::vector<int>& path) const {
        double sum = 0;
        for (int i = 0; i < length; ++i)
            sum += static_cast<double>(at(i, path[static_cast<std::size_t>(i)]));
        return sum;
    }
    std::vector<int> path(bool closes) const {
        return leastErrorPath(
            length, width,
            [&](int along, float* row) {
                for (int i = 0; i < width; ++i)
                    row[i] = at(along, i);
            },
            closes);
    }
    /// The least cost of all paths, by trying them.
    double best(bool closes) const {
        double least = std::numeric_limits<double>::max();
        std::vector<int> path(static_cast<std::size_t>(length));
        const std::function<void(int, double)> go = [&](int along, double sum) {
            if (along == length) {
                if (!closes || std::abs(path.back() - path.front()) <= 1)
                    least = std::min(least, sum);
                return;
            }
            for (int i = 0; i < width; ++i) {
                if (along > 0 && std::abs(i - path[static_cast<std::size_t>(along) - 1]) > 1)
                    continue;
                path[static_cast<std::size_t>(along)] = i;
                go(along + 1, sum + static_cast<double>(at(along, i)));
            }
        };
        go(0, 0);
        return least;
    }
};

TEST(ErrorPath, isTheBestOfAllPaths) {
    for (std::uint64_t seed = 1; seed < 20; ++seed) {
        const Band band(7, 4, seed);
        EXPECT_NEAR(band.costOf(band.path(false)), band.best(false), 1e-5);
    }
}

TEST(ErrorPath, closesWhereTheBandDoes) {
    for (std::uint64_t seed = 1; seed < 20; ++seed) {
        const Band band(8, 4, seed);
        const std::vector<int> path = band.path(true);
        for (std::size_t i = 0; i < path.size(); ++i)
            EXPECT_LE(std::abs(path[i] - path[(i + 1) % path.size()]), 1);
        // It is led through one good place, which need not be the best of all.
        EXPECT_LE(band.costOf(path), 1.5 * band.best(true));
    }
}

TEST(ErrorPath, ofOnePlaceIsStraight) {
    const Band band(5, 1, 3);
    EXPECT_EQ(band.path(false), std::vector<int>(5, 0));
    EXPECT_EQ(band.path(true), std::vector<int>(5, 0));
}

} // namespace
} // namespace texloom::test
