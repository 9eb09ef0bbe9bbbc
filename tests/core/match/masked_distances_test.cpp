#include "core/match/masked_distances.h"
#include "tests/support/textures.h"

#include <gtest/gtest.h>

#include <cmath>

namespace texloom::test {
namespace {

TEST(MaskedDistances, areWhatTheDefinitionSays) {
    const Image exemplar = blobs({37, 29}, 3), known = noise({9, 9}, 3, 4), draws = noise({9, 9}, 1, 8);
    Image counts({9, 9}, 1), mask = constant({37, 29}, 1, 1);
    for (int y = 0; y < 9; ++y)
        for (int x = 0; x < 9; ++x)
            counts(x, y, 0) = draws(x, y, 0) < 0.4F ? 1 : 0;
    mask(20, 12, 0) = 0;
    const MaskedDistances distances({exemplar.view(), mask.view().plane(0)}, 9, [] {});
    std::vector<float> found;
    distances.compute(known, counts.view().plane(0), found, [] {});
    const Size count = distances.positions();
    ASSERT_EQ(found.size(), static_cast<std::size_t>(count.area()));
    std::int64_t allowed = 0;
    std::size_t at = 0;
    for (int v = 0; v < count.height; ++v)
        for (int u = 0; u < count.width; ++u, ++at) {
            if (u <= 20 && u + 9 > 20 && v <= 12 && v + 9 > 12) {
                EXPECT_TRUE(std::isinf(found[at])) << u << ", " << v;
                continue;
            }
            ++allowed;
            double sum = 0;
            for (int c = 0; c < 3; ++c)
                for (int y = 0; y < 9; ++y)
                    for (int x = 0; x < 9; ++x)
                        if (counts(x, y, 0) != 0)
                            sum +=
                                std::pow(static_cast<double>(known(x, y, c) - exemplar(u + x, v + y, c)), 2);
            EXPECT_NEAR(static_cast<double>(found[at]), sum, 1e-3) << u << ", " << v;
        }
    EXPECT_EQ(distances.allowed(), allowed);
}

} // namespace
} // namespace texloom::test
