#include "core/match/patch_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <set>

namespace texloom::test {
namespace {

/// Number of steps that a wavefront with as many threads as it likes needs.
int longestChain(const PatchGrid& grid) {
    std::vector<int> depth(static_cast<std::size_t>(grid.count()), 1);
    for (int i = 0; i < grid.count(); ++i)
        for (const int earlier : grid.before(i))
            depth[static_cast<std::size_t>(i)] =
                std::max(depth[static_cast<std::size_t>(i)], depth[static_cast<std::size_t>(earlier)] + 1);
    return *std::max_element(depth.begin(), depth.end());
}

/// Whether two cells share a pixel on a canvas of this size.
bool touch(const PatchCell& a, const PatchCell& b, int patch, Size canvas) {
    const auto meet = [patch](int p, int q, int length) {
        const int distance = std::abs(p - q);
        return std::min(distance, length - distance) < patch;
    };
    return meet(a.x, b.x, canvas.width) && meet(a.y, b.y, canvas.height);
}

/// Everything that must be done before a cell, directly or not.
std::vector<std::set<int>> ancestors(const PatchGrid& grid) {
    std::vector<std::set<int>> all(static_cast<std::size_t>(grid.count()));
    for (int i = 0; i < grid.count(); ++i)
        for (const int earlier : grid.before(i)) {
            const auto& further = all[static_cast<std::size_t>(earlier)];
            all[static_cast<std::size_t>(i)].insert(earlier);
            all[static_cast<std::size_t>(i)].insert(further.begin(), further.end());
        }
    return all;
}

TEST(PatchGrid, wavefrontTakesTheSourcesNumberOfSteps) {
    for (const Size patches : {Size{1, 1}, Size{5, 1}, Size{1, 5}, Size{7, 4}, Size{3, 9}}) {
        const PatchAxis horizontal(10 + 7 * (patches.width - 1), 10, 3, false);
        const PatchAxis vertical(10 + 7 * (patches.height - 1), 10, 3, false);
        const PatchGrid grid(horizontal, vertical);
        ASSERT_EQ(grid.count(), patches.area());
        if (patches.width > 1) {
            EXPECT_EQ(longestChain(grid), 2 * (patches.height - 1) + patches.width);
        }
    }
}

TEST(PatchGrid, cellsThatTouchAreAlwaysOrdered) {
    for (const Wrap wrap : {Wrap{}, Wrap{true, false}, Wrap{false, true}, Wrap{true, true}})
        for (const int overlap : {1, 3, 5})
            for (const int width : {10, 14, 21, 37, 58})
                for (const int height : {10, 19, 44}) {
                    const PatchAxis horizontal(width, 10, overlap, wrap.x),
                        vertical(height, 10, overlap, wrap.y);
                    const PatchGrid grid(horizontal, vertical);
                    const Size canvas{wrap.x ? width : 100000, wrap.y ? height : 100000};
                    const auto before = ancestors(grid);
                    for (int i = 0; i < grid.count(); ++i)
                        for (int j = 0; j < i; ++j)
                            if (touch(grid.cell(i), grid.cell(j), 10, canvas)) {
                                EXPECT_TRUE(before[static_cast<std::size_t>(i)].contains(j))
                                    << width << "x" << height << " overlap " << overlap << ": " << j
                                    << " and " << i;
                            }
                }
}

TEST(PatchGrid, patchesCoverTheOutputAndOverlapByAtMostHalf) {
    for (const bool wraps : {false, true})
        for (int length = 10; length < 90; ++length)
            for (const int overlap : {1, 2, 5}) {
                const PatchAxis axis(length, 10, overlap, wraps);
                for (int i = wraps ? 0 : 1; i < axis.count(); ++i) {
                    EXPECT_GE(axis.overlapBefore(i), 0) << length;
                    EXPECT_LE(axis.overlapBefore(i), 5) << length;
                }
                EXPECT_GE(axis.start(axis.count() - 1) + 10, length);
                EXPECT_EQ(axis.canvas(), wraps ? length : axis.start(axis.count() - 1) + 10);
            }
}

TEST(PatchGrid, overlapsNameExactlyTheKnownPixels) {
    const Size canvas{37, 29};
    const int patch = 10;
    const PatchGrid grid(PatchAxis(canvas.width, patch, 3, true), PatchAxis(canvas.height, patch, 3, true));
    std::vector<bool> known(static_cast<std::size_t>(canvas.area()), false);
    for (const PatchCell& cell : grid.cells()) {
        for (int y = 0; y < patch; ++y)
            for (int x = 0; x < patch; ++x) {
                const int at = (cell.y + y) % canvas.height * canvas.width + (cell.x + x) % canvas.width;
                EXPECT_EQ(cell.overlap.contains(x, y, patch), known[static_cast<std::size_t>(at)])
                    << "pixel " << x << "," << y << " of cell " << cell.column << "," << cell.row;
            }
        for (int y = 0; y < patch; ++y)
            for (int x = 0; x < patch; ++x)
                known[static_cast<std::size_t>((cell.y + y) % canvas.height * canvas.width +
                                               (cell.x + x) % canvas.width)] = true;
    }
    EXPECT_TRUE(std::all_of(known.begin(), known.end(), [](bool pixel) { return pixel; }));
}

/// Cells between two, the shorter way round where the axis wraps.
int apart(int a, int b, int count, bool wraps) {
    const int straight = std::abs(a - b);
    return wraps ? std::min(straight, count - straight) : straight;
}

TEST(PatchGrid, nearbyCellsAreDoneBeforeAndWithinReach) {
    for (const Wrap wrap : {Wrap{}, Wrap{true, false}, Wrap{false, true}, Wrap{true, true}})
        for (const Size size : {Size{10, 44}, Size{37, 58}, Size{95, 71}}) {
            const PatchAxis horizontal(size.width, 10, 3, wrap.x), vertical(size.height, 10, 3, wrap.y);
            const PatchGrid grid(horizontal, vertical);
            const auto before = ancestors(grid);
            for (int i = 0; i < grid.count(); ++i) {
                const PatchCell& cell = grid.cell(i);
                std::set<int> expected;
                for (const int j : before[static_cast<std::size_t>(i)])
                    if (apart(cell.column, grid.cell(j).column, horizontal.count(), wrap.x) <= 2 &&
                        apart(cell.row, grid.cell(j).row, vertical.count(), wrap.y) <= 2)
                        expected.insert(j);
                const std::vector<int> found = grid.nearby(i, 2);
                EXPECT_EQ(std::set<int>(found.begin(), found.end()), expected) << i;
                EXPECT_EQ(found.size(), expected.size()) << i;
            }
        }
}

} // namespace
} // namespace texloom::test
