#include "core/analysis/estimated_map.h"
#include "core/analysis/map_pictures.h"
#include "core/job/job.h"
#include "tests/support/textures.h"

#include <gtest/gtest.h>

namespace texloom::test {
namespace {

PositionMap mapOf(const Image& result, const std::vector<PatchSource>& exemplars, Wrap wrap = {}) {
    Job<PositionMap> job({1, 2, false}, [&](JobContext& context) {
        context.stage(1, "map");
        return estimatedMap(result, exemplars, wrap, context);
    });
    return std::get<PositionMap>(job.take());
}

TEST(EstimatedMap, ofTheExemplarIsTheIdentity) {
    const Image exemplar = blobs({70, 64}, 3);
    EXPECT_EQ(mapOf(exemplar, {{exemplar, {}}}), PositionMap::identity(exemplar.size()));
}

TEST(EstimatedMap, findsWhereACopyCameFrom) {
    const Image exemplar = blobs({90, 80}, 3);
    const Image part(exemplar.view().crop(13, 21, {50, 40}));
    const PositionMap map = mapOf(part, {{exemplar, {}}});
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 50; ++x)
            ASSERT_EQ(map.at(x, y),
                      (Source{static_cast<std::uint16_t>(x + 13), static_cast<std::uint16_t>(y + 21), 0}));
    EXPECT_EQ(innovation(map), 0);
}

TEST(EstimatedMap, looksRoundTheBorderOfAWrappedResult) {
    const Image exemplar = blobs({60, 60}, 3);
    Image turned({30, 30}, 3);
    for (int c = 0; c < 3; ++c)
        for (int y = 0; y < 30; ++y)
            for (int x = 0; x < 30; ++x)
                turned((x + 12) % 30, (y + 7) % 30, c) = exemplar(x + 9, y + 8, c);
    const PositionMap map = mapOf(turned, {{exemplar, {}}}, {true, true});
    for (int y = 4; y < 26; ++y)
        for (int x = 4; x < 26; ++x)
            ASSERT_EQ(map.at((x + 12) % 30, (y + 7) % 30),
                      (Source{static_cast<std::uint16_t>(x + 9), static_cast<std::uint16_t>(y + 8), 0}));
}

TEST(EstimatedMap, imagesSmallerThanThePatchGetOne) {
    const Image exemplar = blobs({3, 20}, 1);
    for (const Size size : {Size{1, 1}, Size{2, 40}, Size{30, 1}})
        EXPECT_EQ(mapOf(blobs(size, 1), {{exemplar, {}}}).size(), size);
}

} // namespace
} // namespace texloom::test
