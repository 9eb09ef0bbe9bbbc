#include "core/job/random.h"
#include "core/match/patch_set.h"
#include "tests/core/match/interleaved_image.h"
#include "tests/support/textures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace texloom::test {

namespace {

double distanceOf(const Interleaved& a, int x, int y, const Interleaved& b, int u, int v, int patch) {
    double sum = 0;
    for (int j = 0; j < patch; ++j)
        for (int i = 0; i < patch * a.pixel; ++i) {
            const double d = static_cast<double>(a.at(x, y + j)[i] - b.at(u, v + j)[i]);
            sum += d * d;
        }
    return sum;
}

const auto kNothing = [] {};
const auto kAll = [](const Source&) { return true; };

} // namespace

TEST(PatchSet, nearestIsThatOfExhaustiveSearch) {
    for (const int channels : {1, 3, 5})
        for (const int patch : {8, 16, 10}) {
            const Interleaved exemplar = interleaved(blobs({50, 44}, channels));
            const Interleaved query = interleaved(blobs({60, 40}, channels, 3));
            const PatchBasis basis(std::vector{&exemplar}, channels, patch, kNothing);
            PatchSet set({&exemplar}, basis, 2, kAll, kNothing);
            std::vector<float> penalties;
            for (int n = 0; n < set.count(); ++n)
                penalties.push_back(static_cast<float>(Random(3).uniform(n, 0)));
            for (const bool penalised : {false, true}) {
                set.setPenalties(penalised ? penalties : std::vector<float>());
                for (int y = 0; y + patch <= 40; y += 7)
                    for (int x = 0; x + patch <= 60; x += 5) {
                        double best = std::numeric_limits<double>::infinity();
                        for (int n = 0; n < set.count(); ++n) {
                            const Source& at = set.sources()[static_cast<std::size_t>(n)];
                            const double extra =
                                penalised ? static_cast<double>(penalties[static_cast<std::size_t>(n)]) : 0;
                            best = std::min(best, extra + std::sqrt(distanceOf(query, x, y, exemplar, at.x,
                                                                               at.y, patch)));
                        }
                        const PatchMatch found = set.nearest(query.at(x, y), query.stride(), {});
                        double extra = 0;
                        for (int n = 0; n < set.count() && penalised; ++n)
                            if (set.sources()[static_cast<std::size_t>(n)] == found.source)
                                extra = static_cast<double>(penalties[static_cast<std::size_t>(n)]);
                        ASSERT_NEAR(extra + std::sqrt(static_cast<double>(found.distance)), best,
                                    1e-4 * (1 + best));
                    }
            }
        }
}

TEST(PatchSet, hintChangesNothing) {
    const Interleaved exemplar = interleaved(blobs({50, 44}, 3)), query = interleaved(blobs({40, 40}, 3, 3));
    const PatchBasis basis(std::vector{&exemplar}, 3, 8, kNothing);
    const PatchSet set({&exemplar}, basis, 2, kAll, kNothing);
    for (int n = 0; n < 200; ++n) {
        const float* pixels = query.at(n % 32, n / 32 * 4);
        const PatchMatch alone = set.nearest(pixels, query.stride(), {});
        const auto hint =
            static_cast<std::size_t>(Random(1).below(static_cast<std::uint32_t>(set.count()), n, 0));
        EXPECT_EQ(set.nearest(pixels, query.stride(), {set.sources()[hint], 0}).source, alone.source);
        EXPECT_EQ(set.nearest(pixels, query.stride(), alone).source, alone.source);
    }
}

TEST(PatchSet, findsEveryPatchOfItsOwnAndOnlyThose) {
    const Interleaved exemplar = interleaved(noise({40, 40}, 3));
    const PatchBasis basis(std::vector{&exemplar}, 3, 8, kNothing);
    const PatchSet set(
        {&exemplar}, basis, 2, [](const Source& source) { return source.x >= 8; }, kNothing);
    EXPECT_EQ(set.count(), 13 * 17);
    for (const Source& source : set.sources()) {
        const PatchMatch found = set.nearest(exemplar.at(source.x, source.y), exemplar.stride(), {});
        EXPECT_EQ(found.source, source);
        EXPECT_EQ(found.distance, 0);
    }
}

} // namespace texloom::test
