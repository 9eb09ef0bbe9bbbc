// The example of CONTRIBUTING.md.

#include "core/base/error.h"
#include "core/methods/method.h"
#include "tests/support/method_run.h"
#include "tests/support/textures.h"

#include <gtest/gtest.h>

namespace texloom {
namespace mirror_tile {
extern const Method self;
}

namespace test {
namespace {

Synthesis made(const Request& request, const Values& settings = {}) {
    return resultOf(named("mirror-tile", mirror_tile::self), request, settings);
}

Request requestFor(Size size, Wrap wrap) {
    return requestOf(blobs({20, 17}, 3), size, wrap);
}

TEST(MirrorTile, showsTheExemplarAndThenItsMirrorImage) {
    const Request request = requestFor({40, 34}, {});
    const Image& exemplar = *request.exemplars.front().image;
    const Synthesis result = made(request);
    EXPECT_TRUE(samePixels(result.image.view().crop(0, 0, {20, 17}), exemplar));
    for (int x = 0; x < 20; ++x)
        EXPECT_EQ(result.image(20 + x, 33, 1), exemplar(19 - x, 0, 1));
    EXPECT_TRUE(samePixels(result.map.apply(exemplar), result.image));
}

TEST(MirrorTile, endsAsItBeginsWhereItWraps) {
    const Image image = made(requestFor({51, 33}, {true, true})).image;
    for (int y = 0; y < 33; ++y)
        EXPECT_EQ(image(0, y, 0), image(50, y, 0));
    for (int x = 0; x < 51; ++x)
        EXPECT_EQ(image(x, 0, 2), image(x, 32, 2));
}

TEST(MirrorTile, beginsAtTheShift) {
    const Request request = requestFor({10, 10}, {});
    EXPECT_EQ(made(request, {{"shift", 5}}).map.at(0, 0), (Source{5, 0, 0}));
    EXPECT_THROW(made(request, {{"shift", -1}}), UsageError);
}

} // namespace
} // namespace test
} // namespace texloom
