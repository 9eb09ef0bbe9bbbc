#include "core/job/job.h"
#include "core/math/grid_poisson.h"
#include "tests/support/textures.h"

#include <gtest/gtest.h>

#include <cmath>

namespace texloom::test {
namespace {

/// Δf with nothing flowing over borders that do not wrap.
Image laplacian(const Image& f, Wrap wrap) {
    const Size size = f.size();
    Image sum(size, 1);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            for (const auto& [dx, dy] : {std::pair(1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
                int u = x + dx, v = y + dy;
                if (wrap.x)
                    u = (u + size.width) % size.width;
                if (wrap.y)
                    v = (v + size.height) % size.height;
                if (u >= 0 && v >= 0 && u < size.width && v < size.height)
                    sum(x, y, 0) += f(u, v, 0) - f(x, y, 0);
            }
    return sum;
}

TEST(GridPoisson, givesBackWhatTheLaplacianIsOf) {
    for (const Wrap wrap : {Wrap{}, Wrap{true, false}, Wrap{false, true}, Wrap{true, true}})
        for (const Size size : {Size{48, 36}, Size{31, 57}, Size{1, 20}, Size{200, 3}, Size{512, 300}}) {
            const Image f = blobs(size, 1);
            Image g = laplacian(f, wrap);
            Job<int> job({0, 2, false}, [&](JobContext& context) {
                GridPoisson(size, wrap).solve(g.plane(0), context);
                return 0;
            });
            ASSERT_TRUE(std::holds_alternative<int>(job.take()));
            const double mean = channelMeans(f).front();
            double worst = 0;
            for (int y = 0; y < size.height; ++y)
                for (int x = 0; x < size.width; ++x)
                    worst = std::max(worst, std::abs(static_cast<double>(g(x, y, 0) - f(x, y, 0)) + mean));
            // Long waves have the rounding of g some thousand times over.
            EXPECT_LT(worst, 4e-5) << size.width << " × " << size.height;
            EXPECT_NEAR(channelMeans(g).front(), 0, 1e-6);
        }
}

TEST(GridPoisson, screenedDiesAwayOverItsReach) {
    // Along a line, Δf − f / r² = δ' has f = ∓ e^(−|x| / r) / 2 but for terms in 1 / r.
    const Size size{400, 3};
    Image g(size, 1);
    for (int y = 0; y < 3; ++y) {
        g(199, y, 0) = -1;
        g(200, y, 0) = 1;
    }
    const Image divergence(g);
    const double reach = 25;
    Job<int> job({0, 2, false}, [&](JobContext& context) {
        GridPoisson(size, {}, reach).solve(g.plane(0), context);
        return 0;
    });
    job.take();
    for (const int away : {0, 10, 25, 50, 100}) {
        EXPECT_NEAR(g(200 + away, 1, 0), -0.5 * std::exp(-(away + 0.5) / reach), 1e-3);
        EXPECT_NEAR(g(199 - away, 1, 0), 0.5 * std::exp(-(away + 0.5) / reach), 1e-3);
    }
    const Image again = laplacian(g, {});
    for (int x = 0; x < size.width; ++x)
        ASSERT_NEAR(again(x, 1, 0) - static_cast<double>(g(x, 1, 0)) / (reach * reach), divergence(x, 1, 0),
                    1e-5);
}

TEST(GridPoisson, leavesOutTheMeanThatNothingHas) {
    const Size size{20, 17};
    Image g = noise(size, 1);
    const double mean = channelMeans(g).front();
    const Image wanted(g);
    Job<int> job({0, 1, false}, [&](JobContext& context) {
        GridPoisson(size, {}).solve(g.plane(0), context);
        return 0;
    });
    job.take();
    const Image again = laplacian(g, {});
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            ASSERT_NEAR(again(x, y, 0), static_cast<double>(wanted(x, y, 0)) - mean, 1e-5);
}

} // namespace
} // namespace texloom::test
