#include "core/base/error.h"
#include "core/math/lbfgs.h"

#include <gtest/gtest.h>

#include <cmath>

namespace texloom::test {
namespace {

/// Rosenbrock's valley in pairs of variables: least, 0, where all are 1.
double rosenbrock(std::span<const float> x, std::span<float> gradient) {
    double value = 0;
    for (std::size_t i = 0; i + 1 < x.size(); i += 2) {
        const auto a = static_cast<double>(x[i]), b = static_cast<double>(x[i + 1]);
        value += 100 * (b - a * a) * (b - a * a) + (1 - a) * (1 - a);
        gradient[i] = static_cast<float>(-400 * a * (b - a * a) - 2 * (1 - a));
        gradient[i + 1] = static_cast<float>(200 * (b - a * a));
    }
    return value;
}

TEST(Lbfgs, findsTheEndOfAValley) {
    Lbfgs minimiser({-1.2F, 1.0F, 0.5F, -2.0F}, 10);
    int iterations = 0;
    double before = 1e9;
    while (minimiser.step(rosenbrock) && ++iterations < 200) {
        EXPECT_LE(minimiser.value(), before);
        before = minimiser.value();
    }
    EXPECT_LT(iterations, 120);
    for (const float x : minimiser.x())
        EXPECT_NEAR(x, 1, 2e-3);
}

TEST(Lbfgs, needsFewStepsForAQuadratic) {
    const auto quadratic = [](std::span<const float> x, std::span<float> gradient) {
        double value = 0;
        for (std::size_t i = 0; i < x.size(); ++i) {
            const double scale = 1 + static_cast<double>(i);
            value += 0.5 * scale * static_cast<double>(x[i]) * static_cast<double>(x[i]);
            gradient[i] = static_cast<float>(scale * static_cast<double>(x[i]));
        }
        return value;
    };
    Lbfgs minimiser(std::vector<float>(20, 1.0F), 20);
    for (int i = 0; i < 40; ++i)
        minimiser.step(quadratic);
    EXPECT_LT(minimiser.value(), 1e-8);
}

TEST(Lbfgs, endsWhereTheDerivativeIsZero) {
    Lbfgs minimiser({1, 1}, 5);
    EXPECT_FALSE(minimiser.step(rosenbrock));
}

TEST(Lbfgs, goesOnWithTheSameBits) {
    Lbfgs whole({-1.2F, 1.0F, 0.5F, -2.0F}, 3), broken({0, 0, 0, 0}, 3);
    for (int i = 0; i < 7; ++i)
        whole.step(rosenbrock);
    broken.takeUp(whole.state());
    for (int i = 0; i < 7; ++i) {
        whole.step(rosenbrock);
        broken.step(rosenbrock);
    }
    EXPECT_EQ(whole.x(), broken.x());
    EXPECT_EQ(whole.value(), broken.value());
    EXPECT_THROW(broken.takeUp(whole.state().substr(0, 60)), Error);
    EXPECT_THROW(Lbfgs({1, 2}, 3).takeUp(whole.state()), Error);
}

TEST(Lbfgs, refusesWhatIsNoNumber) {
    const auto cliff = [](std::span<const float> x, std::span<float> gradient) {
        gradient[0] = -1;
        return x[0] > 0.5F ? std::nan("") : -static_cast<double>(x[0]);
    };
    Lbfgs minimiser({0}, 3);
    for (int i = 0; i < 5 && minimiser.step(cliff); ++i)
        EXPECT_TRUE(std::isfinite(minimiser.value()));
    EXPECT_LE(minimiser.x()[0], 0.5F);
}

TEST(Adam, findsTheLeastAndGoesOnWithTheSameBits) {
    Adam whole({3, -2}), broken({0, 0});
    const auto step = [](Adam& adam) {
        const std::vector<float> gradient{2 * adam.x()[0], 20 * adam.x()[1]};
        adam.step(gradient, 0.05);
    };
    step(whole);
    EXPECT_NEAR(whole.x()[0], 2.95, 1e-5) << "the first step is as long as the rate";
    for (int i = 0; i < 50; ++i)
        step(whole);
    broken.takeUp(whole.state());
    for (int i = 0; i < 400; ++i) {
        step(whole);
        step(broken);
    }
    EXPECT_EQ(whole.x(), broken.x());
    EXPECT_NEAR(whole.x()[0], 0, 1e-2);
    EXPECT_NEAR(whole.x()[1], 0, 1e-2);
}

} // namespace
} // namespace texloom::test
