#include "core/image/selection.h"
#include "core/image/selection_edits.h"
#include "tests/support/textures.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace texloom::test {
namespace {

/// A soft selection with holes, apart from the picture's edges and on them.
Image softSelection(Size size) {
    Image made = blobs(size, 1);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            float& value = made(x, y, 0);
            value = value < 0.45F || (x > 12 && x < 20 && y < 16) ? 0.0F : value > 0.6F ? 1.0F : value;
        }
    return made;
}

/// The largest or smallest value up to `radius` away, pixel by pixel.
float extreme(const Image& selection, int x, int y, int radius, bool largest) {
    float best = selection(x, y, 0);
    for (int v = std::max(0, y - radius); v <= std::min(selection.height() - 1, y + radius); ++v)
        for (int u = std::max(0, x - radius); u <= std::min(selection.width() - 1, x + radius); ++u)
            if ((u - x) * (u - x) + (v - y) * (v - y) <= radius * radius)
                best = largest ? std::max(best, selection(u, v, 0)) : std::min(best, selection(u, v, 0));
    return best;
}

/// Times that a polygon goes around a point: the sum of the angles under which its sides are seen.
int windingOf(const PlanePoints& corners, double x, double y) {
    double turned = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const PlanePoint &from = corners[i], &to = corners[(i + 1) % corners.size()];
        const double ax = from.x - x, ay = from.y - y, bx = to.x - x, by = to.y - y;
        turned += std::atan2(ax * by - ay * bx, ax * bx + ay * by);
    }
    return static_cast<int>(std::lround(turned / (2 * std::numbers::pi)));
}

void expectPolygon(const PlanePoints& corners, Size size) {
    const Image shape = selections::polygon(size, corners);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            ASSERT_EQ(shape(x, y, 0) == 1, windingOf(corners, x + 0.5, y + 0.5) != 0) << x << ", " << y;
}

} // namespace

TEST(Selection, polygonHoldsTheMiddlesThatItGoesAround) {
    expectPolygon({{3.2, 2.1}, {25.7, 8.3}, {17.9, 27.6}}, {30, 30});
    // A five-pointed star: its middle is gone around twice.
    expectPolygon({{15.1, 1.3}, {23.4, 27.2}, {1.3, 11.1}, {29.2, 11.4}, {6.3, 27.7}}, {31, 29});
    // Over the picture's edges, and a curl that goes around nothing twice the other way.
    expectPolygon({{-8.3, -3.4}, {40.2, 5.1}, {12.3, 44.4}, {30.7, -12.6}}, {28, 26});
}

TEST(Selection, rectangleOfWholePixelsIsExact) {
    const Image shape = selections::polygon({10, 8}, {{2, 3}, {7, 3}, {7, 5}, {2, 5}});
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 10; ++x)
            EXPECT_EQ(shape(x, y, 0), x >= 2 && x < 7 && y >= 3 && y < 5 ? 1 : 0);
    EXPECT_EQ(valueRange(selections::polygon({10, 8}, {{2, 3}, {7, 3}})).largest, 0)
        << "a line has no inside";
}

TEST(Selection, growsAndShrinksByADisc) {
    for (const Size size : {Size{41, 37}, Size{7, 60}, Size{1, 1}}) {
        const Image selection = softSelection(size);
        for (const int radius : {0, 1, 2, 5, 23}) {
            const Image grown = selections::grown(selection, radius);
            const Image shrunk = selections::shrunk(selection, radius);
            for (int y = 0; y < size.height; ++y)
                for (int x = 0; x < size.width; ++x) {
                    ASSERT_EQ(grown(x, y, 0), extreme(selection, x, y, radius, true))
                        << radius << " at " << x << ", " << y;
                    ASSERT_NEAR(shrunk(x, y, 0), extreme(selection, x, y, radius, false), 1e-6)
                        << radius << " at " << x << ", " << y;
                }
        }
    }
}

TEST(Selection, whatTouchesThePicturesEdgeDoesNotShrinkFromThere) {
    Image selection({20, 20}, 1);
    for (int y = 0; y < 20; ++y)
        std::fill_n(selection.plane(0).row(y), 10, 1.0F);
    const Image shrunk = selections::shrunk(selection, 3);
    for (int x = 0; x < 20; ++x)
        EXPECT_EQ(shrunk(x, 10, 0), x < 7 ? 1 : 0);
    EXPECT_TRUE(samePixels(selections::shrunk(constant({9, 9}, 1, 1), 4), constant({9, 9}, 1, 1)));
}

TEST(Selection, featherFallsWithTheDistanceAndKeepsWhatWasSelected) {
    const Image selection = softSelection({40, 36});
    constexpr int kPixels = 6;
    const Image soft = selections::feathered(selection, kPixels);
    for (int y = 0; y < 36; ++y)
        for (int x = 0; x < 40; ++x) {
            double nearest = kPixels + 1;
            for (int v = 0; v < 36; ++v)
                for (int u = 0; u < 40; ++u)
                    if (selection(u, v, 0) == 1)
                        nearest = std::min(nearest, std::hypot(u - x, v - y));
            const double ramp = 1 - nearest / (kPixels + 1);
            ASSERT_NEAR(soft(x, y, 0), std::max(ramp, static_cast<double>(selection(x, y, 0))), 1e-6);
        }
    EXPECT_TRUE(samePixels(selections::feathered(Image({8, 8}, 1), 5), Image({8, 8}, 1)));
}

TEST(Selection, shapesAreAddedTakenAwayAndInverted) {
    const Image selection = softSelection({24, 20});
    const Image shape = selections::polygon({24, 20}, {{4, 4}, {18, 4}, {18, 15}, {4, 15}});
    const Image more = selections::combined(selection, shape, true);
    const Image less = selections::combined(selection, shape, false);
    const Image other = selections::inverted(selection);
    for (int y = 0; y < 20; ++y)
        for (int x = 0; x < 24; ++x) {
            EXPECT_EQ(more(x, y, 0), shape(x, y, 0) == 1 ? 1 : selection(x, y, 0));
            EXPECT_EQ(less(x, y, 0), shape(x, y, 0) == 1 ? 0 : selection(x, y, 0));
            EXPECT_EQ(other(x, y, 0), 1 - selection(x, y, 0));
        }
}

TEST(Selection, longWorkCanBeCalledOff) {
    const Image selection = softSelection({30, 30});
    const auto stop = [] { throw std::runtime_error("enough"); };
    EXPECT_THROW(selections::grown(selection, 3, stop), std::runtime_error);
    EXPECT_THROW(selections::shrunk(selection, 3, stop), std::runtime_error);
    EXPECT_THROW(selections::feathered(selection, 3, stop), std::runtime_error);
}

TEST(SelectionEdits, stepsAreUndoneAndRedoneBitForBit) {
    const Image first({30, 22}, 1);
    const Image second = selections::polygon({30, 22}, {{3, 3}, {12, 5}, {9, 18}});
    const Image third = selections::feathered(second, 4);
    SelectionEdits edits(first);
    EXPECT_FALSE(edits.canUndo() || edits.canRedo());
    edits.set(second);
    edits.set(second);
    edits.set(third);
    edits.undo();
    EXPECT_TRUE(samePixels(edits.selection(), second));
    edits.undo();
    EXPECT_TRUE(samePixels(edits.selection(), first));
    EXPECT_FALSE(edits.canUndo()) << "what changed nothing was no step";
    edits.undo();
    edits.redo();
    edits.redo();
    EXPECT_TRUE(samePixels(edits.selection(), third));
    EXPECT_FALSE(edits.canRedo());
    edits.undo();
    edits.set(first);
    EXPECT_FALSE(edits.canRedo()) << "another step took the place of those undone";
    edits.undo();
    EXPECT_TRUE(samePixels(edits.selection(), second));
}

TEST(SelectionEdits, theOldestStepsAreForgottenWhereManyPixelsChanged) {
    constexpr int kSteps = 3;
    const Size size{20, 10};
    SelectionEdits edits(Image(size, 1), kSteps * size.area());
    for (int i = 1; i <= kSteps + 2; ++i)
        edits.set(constant(size, 1, static_cast<float>(i)));
    for (int i = 0; i < kSteps; ++i) {
        ASSERT_TRUE(edits.canUndo());
        edits.undo();
    }
    EXPECT_FALSE(edits.canUndo());
    EXPECT_EQ(edits.selection()(0, 0, 0), 2);
}

} // namespace texloom::test
