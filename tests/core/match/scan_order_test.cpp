#include "core/match/scan_order.h"

#include <gtest/gtest.h>

#include <atomic>
#include <vector>

namespace texloom::test {
namespace {

/// When each pixel was visited; 0: never.
std::vector<int> visits(Size size, int reach, Wrap wrap, const ScanOrder::Rows& rows, int threads,
                        ScanOrder::Order order) {
    JobMonitor monitor;
    JobContext context(
        {1, threads, false}, [] { return false; }, monitor);
    context.stage(1, "testing");
    std::vector<int> when(static_cast<std::size_t>(size.area()), 0);
    std::atomic<int> clock = 0;
    std::atomic<int> twice = 0;
    ScanOrder(size, reach, wrap, rows)
        .run(
            context,
            [&](int y, int x, int count) {
                for (int i = 0; i < count; ++i) {
                    int& one = when[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) +
                                    static_cast<std::size_t>(x + i)];
                    twice += one != 0;
                    one = ++clock;
                }
            },
            [](double) {}, order);
    EXPECT_EQ(twice, 0);
    EXPECT_EQ(clock, rows.count * size.width);
    return when;
}

/// Whether pixels that see each other are visited one after the other as in raster order.
void expectRasterOrder(Size size, int reach, Wrap wrap, const ScanOrder::Rows& rows) {
    const std::vector<int> raster = visits(size, reach, wrap, rows, 1, ScanOrder::Order::Raster);
    const std::vector<int> wave = visits(size, reach, wrap, rows, 4, ScanOrder::Order::Wavefront);
    const auto turned = [](int at, int length) { return (at % length + length) % length; };
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            for (int dy = -reach; dy <= reach; ++dy)
                for (int dx = -reach; dx <= reach; ++dx) {
                    if ((!wrap.x && (x + dx < 0 || x + dx >= size.width)) ||
                        (!wrap.y && (y + dy < 0 || y + dy >= size.height)))
                        continue;
                    const auto at = static_cast<std::size_t>(y * size.width + x);
                    const auto near = static_cast<std::size_t>(turned(y + dy, size.height) * size.width +
                                                               turned(x + dx, size.width));
                    ASSERT_EQ(raster[at] < raster[near], wave[at] < wave[near])
                        << x << "," << y << " and " << dx << "," << dy << " in " << size.width << " × "
                        << size.height;
                }
}

TEST(ScanOrder, pixelsThatSeeEachOtherFollowAsInRasterOrder) {
    for (const Wrap wrap : {Wrap{}, Wrap{true, false}, Wrap{false, true}, Wrap{true, true}})
        for (const int reach : {1, 4})
            for (const Size size :
                 {Size{70, 50}, Size{200, 37}, Size{9, 30}, Size{1, 7}, Size{40, 3}, Size{3, 3}})
                expectRasterOrder(size, reach, wrap, {0, size.height});
}

TEST(ScanOrder, someRowsAreScannedRoundTheBorder) {
    const std::vector<int> when = visits({60, 40}, 3, {true, true}, {34, 12}, 3, ScanOrder::Order::Wavefront);
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 60; ++x)
            EXPECT_EQ(when[static_cast<std::size_t>(y * 60 + x)] > 0, y >= 34 || y < 6);
    expectRasterOrder({60, 40}, 3, {true, true}, {34, 12});
}

} // namespace
} // namespace texloom::test
