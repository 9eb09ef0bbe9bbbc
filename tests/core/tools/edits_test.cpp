#include "core/image/normal_map.h"
#include "core/image/resample.h"
#include "core/tools/edits.h"
#include "tests/core/refusal.h"
#include "tests/core/tools/sample_edits.h"
#include "tests/support/textures.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace texloom::test {

namespace {

Image made(const Image& image, const ExemplarEdits& edits) {
    return resampled(image, warpOf(edits, image.size()));
}

void recolor(Image& image, const ExemplarEdit& edit, const Image* mask = nullptr) {
    const Tool& tool = toolOf(edit);
    tool.recolor(image, tool.resolved(edit), mask);
}

/// A smooth periodic pattern, defined between pixels, too.
double pattern(PlanePoint at) {
    return 0.5 + 0.25 * std::sin(at.x * 0.4) + 0.25 * std::cos(at.y * 0.3);
}

/// The pattern as a camera sees it that looks at it through `view`: from the picture's points to the
/// pattern's.
template <class View> Image seen(Size size, const View& view) {
    Image image(size, 1);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            image(x, y, 0) = static_cast<float>(pattern(view({x + 0.5, y + 0.5})));
    return image;
}

double largestDifference(const Image& a, const Image& b, int margin = 0) {
    double largest = 0;
    for (int y = margin; y < a.height() - margin; ++y)
        for (int x = margin; x < a.width() - margin; ++x)
            largest = std::max<double>(largest, std::abs(a(x, y, 0) - b(x, y, 0)));
    return largest;
}

/// Normals of the height field sin(kx x) + sin(ky y), green up.
Image waves(Size size, double kx, double ky, double strength) {
    Image normals(size, 3);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const double dx = strength * kx * std::cos(kx * (x + 0.5));
            const double dy = strength * ky * std::cos(ky * (y + 0.5));
            const double length = std::sqrt(dx * dx + dy * dy + 1);
            normals(x, y, 0) = static_cast<float>(0.5 - 0.5 * dx / length);
            normals(x, y, 1) = static_cast<float>(0.5 + 0.5 * dy / length);
            normals(x, y, 2) = static_cast<float>(0.5 + 0.5 / length);
        }
    return normals;
}

double meanOf(const Image& image, const Region& part) {
    double sum = 0;
    for (int y = part.y; y < part.bottom(); ++y)
        for (int x = part.x; x < part.right(); ++x)
            sum += image(x, y, 0);
    return sum / static_cast<double>(part.size.area());
}

const ExemplarEdit kMirror = flip("horizontal");

} // namespace

TEST(ExemplarEdit, CropsAndQuarterTurnsMovePixelsBitForBit) {
    const Image image = blobs({13, 9}, 3);
    const Image cropped = made(image, {crop(2, 3, 7, 5)});
    EXPECT_TRUE(samePixels(cropped, image.view().crop(2, 3, {7, 5})));
    const Image turned = made(image, {turn(90)});
    ASSERT_EQ(turned.size(), (Size{9, 13}));
    for (int y = 0; y < 9; ++y)
        for (int x = 0; x < 13; ++x) // the top row becomes the right column
            ASSERT_EQ(turned(8 - y, x, 1), image(x, y, 1));
    EXPECT_TRUE(samePixels(made(image, {turn(90), turn(-90)}), image));
    EXPECT_TRUE(samePixels(made(image, {turn(180), kMirror, flip("vertical")}), image));
    EXPECT_EQ(made(image, {kMirror})(0, 4, 2), image(12, 4, 2));
}

TEST(ExemplarEdit, AnyAngleKeepsTheLargestUprightRectangleInside) {
    for (const Size size : {Size{200, 100}, Size{100, 100}, Size{60, 230}})
        for (const double degrees : {0.0, 3.0, 30.0, 45.0, 61.0, 119.0, -10.0, 200.0}) {
            const Warp placement = warpOf({turn(degrees)}, size);
            const Size after = placement.size();
            double reach = -1e9; // how far the farthest corner lies outside
            for (const PlanePoint corner : {PlanePoint{0, 0},
                                            {double(after.width), 0},
                                            {0, double(after.height)},
                                            {double(after.width), double(after.height)}}) {
                const PlanePoint at = placement.toSource(corner);
                reach = std::max({reach, -at.x, -at.y, at.x - size.width, at.y - size.height});
            }
            EXPECT_LE(reach, 1e-6) << degrees;
            EXPECT_GT(reach, -2) << degrees << ": a larger one fits";
        }
}

TEST(ExemplarEdit, TurnsClockwise) {
    const Size size{120, 90};
    const Image image = seen(size, [](PlanePoint p) { return p; });
    const Image turned = made(image, {turn(20)});
    const double angle = 20 * std::numbers::pi / 180;
    const Image expected = seen(turned.size(), [&](PlanePoint p) {
        const double x = p.x - 0.5 * turned.width(), y = p.y - 0.5 * turned.height();
        return PlanePoint{60 + x * std::cos(angle) + y * std::sin(angle),
                          45 - x * std::sin(angle) + y * std::cos(angle)};
    });
    EXPECT_LT(largestDifference(turned, expected, 2), 0.003);
}

TEST(ExemplarEdit, RectifiesAWarpedPatternBack) {
    // The camera: a projective map from the picture of 160 × 130 px to the plane of 100 × 80 units.
    const PlanePoints corners = {{31, 22}, {128, 10}, {150, 121}, {12, 104}};
    const Warp camera = warpOf({rectify(corners, {100, 80})}, {160, 130});
    const Image photograph = seen({160, 130}, [&](PlanePoint p) { return camera.fromSource(p, p); });
    const Image back = resampled(photograph, camera);
    const Image plane = seen({100, 80}, [](PlanePoint p) { return p; });
    EXPECT_LT(largestDifference(back, plane, 1), 0.01);
    EXPECT_GT(largestDifference(resampled(photograph, Placement({100, 80})), plane), 0.5);
}

TEST(ExemplarEdit, RectifiesToTheLongerOfOppositeSides) {
    const ExemplarEdit edit = rectify({{10, 10}, {50, 10}, {70, 90}, {10, 90}});
    EXPECT_EQ(sizeAfter(edit, {100, 100}), (Size{60, 82}));
}

TEST(ExemplarEdit, ShrinkingAveragesInsteadOfSkipping) {
    Image stripes(Size{64, 64}, 1);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            stripes(x, y, 0) = x % 2 == 0 ? 1.0F : 0.0F;
    const ExemplarEdit all = rectify({{0, 0}, {64, 0}, {64, 64}, {0, 64}}, {16, 16});
    const Image small = made(stripes, {all});
    for (int x = 2; x < 14; ++x)
        EXPECT_NEAR(small(x, 8, 0), 0.5, 0.1);
}

TEST(ExemplarEdit, EditsInOneGoAreThoseOneAfterTheOther) {
    const Image image = seen({90, 70}, [](PlanePoint p) { return p; });
    const ExemplarEdits edits = {crop(5, 4, 80, 60), turn(7), kMirror, turn(90)};
    Image stepwise = image;
    for (const ExemplarEdit& edit : edits)
        stepwise = made(stepwise, {edit});
    const Image atOnce = made(image, edits);
    ASSERT_EQ(atOnce.size(), stepwise.size());
    EXPECT_LT(largestDifference(atOnce, stepwise, 2), 0.005);
}

TEST(ExemplarEdit, MaskHidesWhateverTouchesTheHidden) {
    Image mask = constant({40, 40}, 1, 1);
    mask(20, 20, 0) = 0;
    const Warp exact = warpOf({crop(10, 10, 20, 20)}, mask.size());
    EXPECT_EQ(meanOf(resampledMask(mask, exact), {0, 0, {20, 20}}), 399.0 / 400);
    const Image turned = resampledMask(mask, warpOf({turn(30)}, mask.size()));
    const double hidden =
        (1 - meanOf(turned, {0, 0, turned.size()})) * static_cast<double>(turned.size().area());
    EXPECT_GE(hidden, 9);
    EXPECT_LE(hidden, 25);
}

TEST(ExemplarEdit, RefusesWhatCannotBeMade) {
    const Size size{100, 80};
    const auto making = [size](const ExemplarEdit& edit) { return [=] { sizeAfter(edit, size); }; };
    EXPECT_THAT(making(crop(50, 0, 51, 10)), usageRefusal("51 × 10", "100 × 80"));
    EXPECT_THAT(making(turn(1000)), usageRefusal("1000", "360"));
    EXPECT_THAT(making(turn(std::numeric_limits<double>::quiet_NaN())), usageRefusal("Angle"));
    EXPECT_THAT(making(rectify({{0, 0}, {101, 0}, {90, 70}, {0, 70}})), usageRefusal("Corner 2"));
    EXPECT_THAT(making(rectify({{0, 0}, {0, 70}, {90, 70}, {90, 0}})), usageRefusal("clockwise"));
    EXPECT_THAT(making(rectify({{0, 0}, {90, 0}, {5, 5}, {0, 70}})), usageRefusal("dent"));
    EXPECT_THAT(making(flatten("smooth", 1, {{"width", 0.0}})), usageRefusal("0.02 to 1"));
    EXPECT_THAT(making(flatten("polynomial", 1, {{"order", 5}})), usageRefusal("1 to 4"));
    EXPECT_THAT(making(flatten("smooth", 1.5)), usageRefusal("1.5", "0 to 1"));
}

TEST(NormalMap, TurnsAndMirrorsWithTheSurface) {
    const Size size{64, 48};
    const Image normals = waves(size, 0.2, 0.3, 2);
    for (const MapRole role : {MapRole::NormalGl, MapRole::NormalDx}) {
        Image stored = normals, swapped = waves({48, 64}, 0.3, 0.2, 2), mirrored = normals;
        // A quarter turn clockwise: x runs along what was -y, y along what was x.
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 48; ++x)
                for (int c = 0; c < 3; ++c) {
                    const float green = normals(y, 47 - x, 1), red = normals(y, 47 - x, 0);
                    swapped(x, y, c) = c == 0 ? green : c == 1 ? 1 - red : normals(y, 47 - x, 2);
                }
        for (int y = 0; y < 48; ++y)
            for (int x = 0; x < 64; ++x)
                for (int c = 0; c < 3; ++c)
                    mirrored(x, y, c) = c == 0 ? 1 - normals(63 - x, y, 0) : normals(63 - x, y, c);
        for (Image* image : {&stored, &swapped, &mirrored})
            if (role == MapRole::NormalDx)
                flipGreen(*image);
        const Image turned = placedNormals(stored, role, warpOf({turn(90)}, size));
        const Image flipped = placedNormals(stored, role, warpOf({kMirror}, size));
        for (int c = 0; c < 3; ++c) {
            EXPECT_LT(largestDifference(Image(turned.view().channelRange(c, 1)),
                                        Image(swapped.view().channelRange(c, 1))),
                      1e-6);
            EXPECT_LT(largestDifference(Image(flipped.view().channelRange(c, 1)),
                                        Image(mirrored.view().channelRange(c, 1))),
                      1e-6);
        }
    }
}

TEST(NormalMap, StaysOneLongAndTellsSlopesApart) {
    const Image normals = waves({80, 80}, 0.15, 0, 3); // slopes along x alone
    const Image turned = placedNormals(normals, MapRole::NormalGl, warpOf({turn(30)}, {80, 80}));
    for (int y = 0; y < turned.height(); ++y)
        for (int x = 0; x < turned.width(); ++x) {
            const double nx = 2 * turned(x, y, 0) - 1, ny = 2 * turned(x, y, 1) - 1,
                         nz = 2 * turned(x, y, 2) - 1;
            ASSERT_NEAR(nx * nx + ny * ny + nz * nz, 1, 1e-5);
            // Green is up: the slope that ran along x now runs 30° down to the right.
            ASSERT_NEAR(ny, -std::tan(std::numbers::pi / 6) * nx, 1e-4);
        }
}

TEST(Flatten, TakesARampOutAndKeepsTheMean) {
    const Image texture = blobs({160, 120}, 3);
    Image lit = texture;
    for (int y = 0; y < 120; ++y)
        for (int x = 0; x < 160; ++x)
            for (int c = 0; c < 3; ++c)
                lit(x, y, c) *= static_cast<float>(std::exp(x / 80.0 - y / 120.0));
    const Region left{0, 0, {40, 120}}, right{120, 0, {40, 120}};
    const auto unevenness = [&](const Image& image) {
        return std::log(meanOf(image, right) / meanOf(image, left));
    };
    const double own = unevenness(texture);
    ASSERT_GT(unevenness(lit) - own, 1.4);
    for (const char* model : {"smooth", "polynomial"}) {
        Image flat = lit;
        recolor(flat, flatten(model, 1, {{"width", 0.4}}));
        EXPECT_LT(std::abs(unevenness(flat) - own), 0.15);
        EXPECT_NEAR(meanOf(flat, {0, 0, flat.size()}), meanOf(lit, {0, 0, lit.size()}),
                    0.1 * meanOf(lit, {0, 0, lit.size()}));
        Image half = lit, none = lit;
        recolor(half, flatten(model, 0.5, {{"width", 0.4}}));
        EXPECT_NEAR(unevenness(half), 0.5 * (unevenness(lit) + unevenness(flat)), 0.15);
        recolor(none, flatten(model, 0, {{"width", 0.4}}));
        EXPECT_TRUE(samePixels(none, lit));
    }
}

TEST(Flatten, DoesNotLookAtWhatTheMaskHides) {
    Image image = constant({60, 60}, 1, 0.5F), mask = constant({60, 60}, 1, 1);
    for (int y = 0; y < 60; ++y)
        for (int x = 40; x < 60; ++x) {
            image(x, y, 0) = 5;
            mask(x, y, 0) = 0;
        }
    Image with = image, without = image;
    recolor(with, flatten("smooth"), &mask);
    recolor(without, flatten("smooth"));
    EXPECT_NEAR(with(5, 30, 0) / with(35, 30, 0), 1, 1e-3);
    EXPECT_GT(std::abs(without(5, 30, 0) / without(35, 30, 0) - 1), 0.05);
}

TEST(Flatten, LeavesBlackAndHueAlone) {
    Image black = constant({20, 20}, 3, 0);
    recolor(black, flatten("smooth"));
    EXPECT_TRUE(samePixels(black, constant({20, 20}, 3, 0)));
    Image lit = blobs({40, 40}, 4);
    const Image before = lit;
    recolor(lit, flatten("polynomial", 1, {{"order", 3}}));
    for (int x = 0; x < 40; ++x) {
        EXPECT_NEAR(lit(x, 7, 0) * before(x, 7, 1), lit(x, 7, 1) * before(x, 7, 0), 1e-5);
        EXPECT_EQ(lit(x, 7, 3), before(x, 7, 3)); // alpha
    }
}

} // namespace texloom::test
