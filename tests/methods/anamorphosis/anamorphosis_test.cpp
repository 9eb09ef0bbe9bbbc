#include "core/image/stmap.h"
#include "core/methods/method.h"
#include "core/session/run/run.h"
#include "tests/support/method_run.h"
#include "tests/support/textures.h"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace texloom::test::anamorphosis_tests {
namespace {

const char* const kKinds[] = {"affine", "parabola", "sinusoid", "turbulence"};

Synthesis made(const Request& request, const Values& settings) {
    return resultOf(findMethod("anamorphosis"), request, settings);
}

Values with(const char* kind, double amplitude) {
    return {{"kind", std::string(kind)}, {"amplitude", amplitude}, {"scale", 12.0}};
}

TEST(AnamorphosisMethod, withoutAmplitudeIsTheIdentityBitForBit) {
    const Image exemplar = noise({61, 43}, 3);
    for (const char* kind : kKinds)
        for (const char* interpolation : {"cubic", "linear", "nearest"})
            for (const char* axis : {"x", "y"}) {
                Values settings = with(kind, 0);
                settings["interpolation"] = std::string(interpolation);
                settings["axis"] = std::string(axis);
                EXPECT_TRUE(samePixels(made(requestOf(exemplar, {61, 43}), settings).image, exemplar));
                settings["border"] = std::string("repeat");
                EXPECT_TRUE(
                    samePixels(made(requestOf(exemplar, {61, 43}, {true, true}), settings).image, exemplar));
            }
}

TEST(AnamorphosisMethod, itsMapGivesTheImage) {
    const Image exemplar = blobs({80, 64}, 2);
    for (const char* kind : kKinds)
        for (const Wrap wrap : {Wrap{}, Wrap{true, true}}) {
            const Synthesis result = made(requestOf(exemplar, {150, 110}, wrap), with(kind, 0.7));
            const ImageView view = exemplar;
            const Image again = appliedStMap(*result.outputs.image(kStMapPort), {&view, 1});
            double squares = 0;
            for (int c = 0; c < 2; ++c)
                for (int y = 0; y < 110; ++y)
                    for (int x = 0; x < 150; ++x) {
                        const double apart = static_cast<double>(again(x, y, c) - result.image(x, y, c));
                        squares += apart * apart;
                    }
            // Samples within pixels lie where differences say, and not the map itself.
            EXPECT_LT(std::sqrt(squares / (150 * 110 * 2)), 2e-3) << kind;
        }
}

TEST(AnamorphosisMethod, aStraightSlopeComesOutAsTheMapSays) {
    // What is x in the exemplar is the map's x in the result: cubics reproduce straight lines.
    Image exemplar({100, 20}, 1);
    for (int y = 0; y < 20; ++y)
        for (int x = 0; x < 100; ++x)
            exemplar(x, y, 0) = static_cast<float>((x + 0.5) / 100);
    for (const char* kind : kKinds) {
        const Synthesis result = made(requestOf(exemplar, {100, 20}), with(kind, 0.6));
        const Image& map = *result.outputs.image(kStMapPort);
        for (int y = 0; y < 20; ++y)
            for (int x = 0; x < 100; ++x)
                if (map(x, y, 0) > 0.04F && map(x, y, 0) < 0.96F) {
                    ASSERT_NEAR(result.image(x, y, 0), map(x, y, 0), 1e-3) << kind;
                }
    }
}

TEST(AnamorphosisMethod, anImageToStartFromIsWhatIsDeformed) {
    const Image initial = blobs({90, 70}, 1, 5);
    Request request = requestOf(noise({40, 40}, 1), {90, 70}, {true, false});
    request.inputs.set(kInitialPort, std::make_shared<const Image>(initial));
    EXPECT_TRUE(samePixels(made(request, with("sinusoid", 0)).image, initial));
    EXPECT_FALSE(samePixels(made(request, with("sinusoid", 0.5)).image, initial));
}

TEST(AnamorphosisMethod, saysWhatItLoweredTheAmplitudeTo) {
    const Synthesis result = made(requestOf(noise({64, 64}, 1), {64, 64}), with("turbulence", 0.95));
    ASSERT_EQ(result.notes.size(), 1U);
    EXPECT_THAT(result.notes.front().text(), testing::HasSubstr("0.95"));
    EXPECT_LT(result.figures.front().value, 0.95);
    EXPECT_GT(result.figures.back().value, 0.1);
    EXPECT_TRUE(made(requestOf(noise({64, 64}, 1), {64, 64}), with("parabola", 0.95)).notes.empty());
}

TEST(AnamorphosisMethod, drawsTheCurveOfItsMapAsFigure530) {
    for (const char* axis : {"x", "y"})
        for (const char* kind : {"affine", "parabola", "sinusoid"}) {
            Values settings = with(kind, 0.7);
            settings["axis"] = std::string(axis);
            const Synthesis result = made(requestOf(blobs({100, 80}, 3), {100, 80}), settings);
            const Image& curve = *result.outputs.image("curve");
            const int side = curve.width(), length = axis == std::string("x") ? 100 : 80;
            const Image& stmap = *result.outputs.image(kStMapPort);
            int apart = 0;
            for (int at = 4; at + 4 < length; ++at) {
                // The pixel comes from this place, of the whole; the picture has it upwards.
                const auto from =
                    static_cast<double>(axis == std::string("x") ? stmap(at, 40, 0) : 1 - stmap(50, at, 1));
                const int x = static_cast<int>((at + 0.5) / length * side);
                const int y = static_cast<int>((1 - from) * side);
                float darkest = 1;
                for (int dy = -2; dy <= 2; ++dy)
                    darkest = std::min(darkest, curve(x, std::clamp(y + dy, 0, side - 1), 1));
                ASSERT_LT(darkest, 0.2F) << kind << ' ' << axis << ' ' << at;
                // Elsewhere in the column it is white, or as grey as the diagonal.
                for (int v = 0; v < side; ++v)
                    if (std::abs(v - y) > 12) {
                        ASSERT_GT(curve(x, v, 0), 0.5F) << kind << ' ' << axis << ' ' << at;
                    }
                apart += std::abs(y - (side - 1 - x)) > 8 ? 1 : 0;
            }
            EXPECT_GT(apart, 10) << kind; // so that it is not the diagonal
        }
    // Of turbulence, where nothing moves, the edges of squares stay straight.
    const Request request = requestOf(blobs({160, 80}, 1), {160, 80});
    const Synthesis still = made(request, with("turbulence", 0)),
                    moved = made(request, with("turbulence", 0.5));
    const Image& squares = *still.outputs.image("curve");
    EXPECT_EQ(squares.size(), (Size{160, 80}));
    EXPECT_LT(squares(40, 45, 0), 0.6F);
    EXPECT_EQ(squares(45, 45, 0), 1);
    EXPECT_FALSE(samePixels(squares, *moved.outputs.image("curve")));
}

TEST(AnamorphosisMethod, normalsOfCompanionMapsAreTurnedWithTheSurface) {
    // All vectors lean to the right; each must lean as the rotation in the inverse Jacobian has it.
    const Size size{90, 80};
    Image normals(size, 3);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            normals(x, y, 0) = 0.5F + 0.5F * 0.6F;
            normals(x, y, 1) = 0.5F;
            normals(x, y, 2) = 0.5F + 0.5F * 0.8F;
        }
    RunInput input;
    input.steps.front() = {"anamorphosis", with("turbulence", 0.9)};
    RunExemplar& exemplar = input.exemplars.emplace_back();
    exemplar.image.path = "made up";
    exemplar.image.image = std::make_shared<const Image>(blobs(size, 3));
    exemplar.companions.push_back(exemplar.image);
    exemplar.companions.front().image = std::make_shared<const Image>(normals);
    exemplar.companions.front().role = MapRole::NormalGl;
    input.size = size;
    input.seed = 5;
    const auto job = startRun(planRun(input), false);
    const auto result = std::get<Result>(job->take());
    const Image& stmap = *result.synthesis.outputs.image(kStMapPort);
    double largest = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const Eigen::Matrix2d inverse = stMapJacobian(stmap, size, x, y).inverse();
            const Eigen::JacobiSVD<Eigen::Matrix2d> svd(inverse, Eigen::ComputeFullU | Eigen::ComputeFullV);
            const Eigen::Vector2d leans = svd.matrixU() * svd.matrixV().transpose() * Eigen::Vector2d(0.6, 0);
            const Image& made = result.companions.front();
            ASSERT_NEAR(made(x, y, 0), 0.5 + 0.5 * leans.x(), 1e-4);
            ASSERT_NEAR(made(x, y, 1), 0.5 - 0.5 * leans.y(), 1e-4); // green points up, rows go down
            ASSERT_NEAR(made(x, y, 2), 0.9, 1e-4);
            largest = std::max(largest, std::abs(leans.y()));
        }
    EXPECT_GT(largest, 0.05);
}

TEST(StMap, jacobianHoldsWhereTheExemplarIsMirroredOrRepeated) {
    // A shear and a stretch, whose places are folded into an exemplar of 32 × 32 px.
    const Size exemplar{32, 32};
    for (const bool mirrors : {true, false}) {
        Image map({120, 90}, 4);
        const auto folded = [mirrors](double at) {
            const double period = mirrors ? 64 : 32, place = at - period * std::floor(at / period);
            return mirrors && place > 32 ? 64 - place : place;
        };
        for (int y = 0; y < 90; ++y)
            for (int x = 0; x < 120; ++x) {
                map(x, y, 0) = static_cast<float>(folded(1.3 * x + 0.4 * y) / 32);
                map(x, y, 1) = static_cast<float>(1 - folded(0.8 * y) / 32);
                map(x, y, 3) = 1;
            }
        for (int y = 1; y < 89; ++y)
            for (int x = 1; x < 119; ++x) {
                constexpr double kTurns = 1e-3; // where it turns round there are two answers
                if (std::min(32 - folded(1.3 * x + 0.4 * y), 32 - folded(0.8 * y)) < kTurns ||
                    std::min(folded(1.3 * x + 0.4 * y), folded(0.8 * y)) < kTurns)
                    continue;
                const Eigen::Matrix2d jacobian = stMapJacobian(map, exemplar, x, y);
                const double across = mirrors && std::fmod(1.3 * x + 0.4 * y, 64) > 32 ? -1 : 1;
                const double down = mirrors && std::fmod(0.8 * y, 64) > 32 ? -1 : 1;
                ASSERT_NEAR(jacobian(0, 0), 1.3 * across, 1e-3);
                ASSERT_NEAR(jacobian(0, 1), 0.4 * across, 1e-3);
                ASSERT_NEAR(jacobian(1, 1), 0.8 * down, 1e-3);
                ASSERT_NEAR(jacobian(1, 0), 0, 1e-3);
            }
    }
}

} // namespace
} // namespace texloom::test::anamorphosis_tests
