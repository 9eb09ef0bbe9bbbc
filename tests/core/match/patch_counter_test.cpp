#include "core/job/random.h"
#include "core/match/patch_counter.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

namespace texloom::test {

TEST(PatchCounter, sharesAreThoseOfPixelsCountedOneByOne) {
    constexpr int kPatch = 5, kWanted = 60;
    const std::vector<Size> sizes = {{19, 14}, {11, 12}};
    std::vector<Source> patches;
    for (std::uint16_t e = 0; e < 2; ++e)
        for (int y = 0; y + kPatch <= sizes[e].height; y += 2)
            for (int x = 0; x + kPatch <= sizes[e].width; x += 2)
                patches.push_back({static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y), e});
    const int count = static_cast<int>(patches.size());
    PatchCounter counter(patches, sizes, kPatch, kWanted);
    std::vector<int> taken;
    for (int n = 0; n < 80; ++n) {
        const bool back = n % 4 == 3;
        if (!back)
            taken.push_back(static_cast<int>(Random(5).below(static_cast<std::uint32_t>(count), n, 0)));
        const int number = taken.back();
        std::set<int> told;
        std::vector<double> before;
        for (int i = 0; i < count; ++i)
            before.push_back(counter.share(i));
        counter.count(number, back ? -1 : 1, [&](int other) { told.insert(other); });
        for (int i = 0; i < count; ++i)
            EXPECT_EQ(counter.share(i) != before[static_cast<std::size_t>(i)], told.count(i) == 1);
        if (back)
            taken.pop_back();
    }
    const double even = kWanted * 25.0 / (19 * 14 + 11 * 12);
    for (int i = 0; i < count; ++i) {
        const Source& own = patches[static_cast<std::size_t>(i)];
        EXPECT_EQ(counter.numberOf(own), i);
        double uses = 0;
        for (const int number : taken) {
            const Source& other = patches[static_cast<std::size_t>(number)];
            for (int v = 0; v < kPatch; ++v)
                for (int u = 0; u < kPatch; ++u)
                    uses += other.exemplar == own.exemplar && own.x + u >= other.x &&
                            own.x + u < other.x + kPatch && own.y + v >= other.y &&
                            own.y + v < other.y + kPatch;
        }
        EXPECT_NEAR(counter.share(i), uses / 25 / even, 1e-12);
    }
    EXPECT_EQ(counter.numberOf({1, 0, 0}), -1);
}

} // namespace texloom::test
