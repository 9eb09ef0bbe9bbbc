#include "core/job/job.h"
#include "core/match/patch_match.h"
#include "tests/support/textures.h"
#include "tests/support/time_limit.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <limits>
#include <thread>

namespace texloom::test {
namespace {

/// A promise of the design.
constexpr std::chrono::milliseconds kMatchCancelLimit{100};

PatchField matched(const ImageView& query, std::vector<PatchSource> sources, const PatchMatchOptions& options,
                   int threads = 2, std::uint64_t seed = 5) {
    Job<PatchField> job({seed, threads, false}, [&](JobContext& context) {
        context.stage(1, "matching");
        return matchPatches(query, sources, options, context);
    });
    return std::get<PatchField>(job.take());
}

double wrappedDistance(const ImageView& a, int ax, int ay, const ImageView& b, int bx, int by, int patch) {
    double sum = 0;
    for (int c = 0; c < a.channels; ++c)
        for (int y = 0; y < patch; ++y)
            for (int x = 0; x < patch; ++x) {
                const double difference =
                    static_cast<double>(a((ax + x) % a.width, (ay + y) % a.height, c) - b(bx + x, by + y, c));
                sum += difference * difference;
            }
    return sum;
}

double exhaustiveMean(const ImageView& query, const ImageView& source, int patch) {
    double sum = 0;
    int count = 0;
    for (int y = 0; y + patch <= query.height; ++y)
        for (int x = 0; x + patch <= query.width; ++x, ++count) {
            double best = std::numeric_limits<double>::infinity();
            for (int v = 0; v + patch <= source.height; ++v)
                for (int u = 0; u + patch <= source.width; ++u)
                    best = std::min(best, wrappedDistance(query, x, y, source, u, v, patch));
            sum += best;
        }
    return sum / count;
}

/// What a synthesis would be: pieces of the exemplar at other places, a little changed.
Image rearranged(const Image& exemplar, Size size, int piece) {
    const Random random(9);
    const Image grain = noise(size, exemplar.channels(), 3);
    Image made(size, exemplar.channels());
    for (int c = 0; c < made.channels(); ++c)
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                const auto range = static_cast<std::uint32_t>(exemplar.width() - piece);
                const int u = static_cast<int>(random.below(range, x / piece, y / piece, 0)) + x % piece;
                const int v = static_cast<int>(random.below(range, x / piece, y / piece, 1)) + y % piece;
                made(x, y, c) = exemplar(u, v, c) + 0.05F * grain(x, y, c);
            }
    return made;
}

TEST(PatchMatch, fiveIterationsComeWithinThreePerCentOfExhaustiveSearch) {
    const Image exemplar = blobs({48, 48}, 3);
    for (const int patch : {5, 7}) {
        const Image query = rearranged(exemplar, {60, 60}, 20);
        const double found = matched(query, {{exemplar, {}}}, {patch, 5, 1, {}}).meanDistance();
        const double best = exhaustiveMean(query, exemplar, patch);
        EXPECT_GE(found, best * (1 - 1e-5));
        EXPECT_LE(found, best * 1.03) << "patch " << patch;
    }
}

TEST(PatchMatch, distancesAreThoseOfTheMatches) {
    for (const int channels : {1, 2, 3, 5}) {
        const Image exemplar = blobs({40, 31}, channels), query = blobs({90, 70}, channels, 4);
        const PatchField field = matched(query, {{exemplar, {}}}, {5, 2, 1, {true, false}});
        EXPECT_EQ(field.size(), (Size{90, 66}));
        for (int y = 0; y < field.size().height; ++y)
            for (int x = 0; x < field.size().width; ++x) {
                const PatchMatch& match = field.at(x, y);
                ASSERT_NEAR(match.distance,
                            wrappedDistance(query, x, y, exemplar, match.source.x, match.source.y, 5), 1e-4);
            }
    }
}

TEST(PatchMatch, threadsChangeNothing) {
    const Image exemplar = blobs({50, 60}, 3), query = blobs({150, 140}, 3, 2);
    for (const Wrap wrap : {Wrap{}, Wrap{true, true}}) {
        const PatchField one = matched(query, {{exemplar, {}}}, {5, 3, 1, wrap}, 1);
        for (const int threads : {2, 5}) {
            const PatchField other = matched(query, {{exemplar, {}}}, {5, 3, 1, wrap}, threads);
            for (int y = 0; y < one.size().height; ++y)
                for (int x = 0; x < one.size().width; ++x)
                    ASSERT_EQ(one.at(x, y).source, other.at(x, y).source);
        }
    }
}

TEST(PatchMatch, copiesAreFoundWhole) {
    const Image exemplar = blobs({64, 64}, 3);
    const Image query(exemplar.view().crop(7, 11, {48, 40}));
    const PatchField field = matched(query, {{exemplar, {}}}, {7, 5, 1, {}});
    EXPECT_EQ(field.meanDistance(), 0);
    EXPECT_EQ(field.at(3, 4).source, (Source{10, 15, 0}));
}

TEST(PatchMatch, forbiddenPatchesAreNotFound) {
    const Image exemplar = blobs({48, 48}, 1);
    Image mask = constant({48, 48}, 1, 1);
    for (int y = 10; y < 30; ++y)
        for (int x = 0; x < 20; ++x)
            mask(x, y, 0) = 0;
    const PatchField field = matched(exemplar, {{exemplar, mask.view().plane(0)}}, {5, 4, 1, {}});
    for (int y = 0; y < field.size().height; ++y)
        for (int x = 0; x < field.size().width; ++x) {
            const Source source = field.at(x, y).source;
            ASSERT_FALSE(source.x < 20 && source.y + 5 > 10 && source.y < 30) << source.x << "," << source.y;
        }
}

TEST(PatchMatch, everySourceIsSearched) {
    const Image first = blobs({40, 40}, 3, 1), second = blobs({60, 30}, 3, 2);
    const PatchField field = matched(second, {{first, {}}, {second, {}}}, {5, 5, 1, {}});
    EXPECT_NEAR(field.meanDistance(), 0, 1e-6);
    EXPECT_EQ(field.at(8, 9).source, (Source{8, 9, 1}));
}

TEST(PatchMatch, endsSoonAfterCancelling) {
    const Image exemplar = noise({128, 128}, 3), query = noise({512, 512}, 3, 2);
    const std::vector<PatchSource> sources = {{exemplar, {}}};
    const auto timeToCancel = [&]() -> std::chrono::nanoseconds {
        Job<PatchField> job({}, [&](JobContext& context) {
            context.stage(1, "matching");
            return matchPatches(query, sources, {7, 50, 1, {}}, context);
        });
        while (job.monitor().progress() < 0.01)
            std::this_thread::yield();
        const auto asked = std::chrono::steady_clock::now();
        job.cancel();
        EXPECT_TRUE(std::holds_alternative<Cancelled>(job.take()));
        return std::chrono::steady_clock::now() - asked;
    };
    const auto limit = limitNow(kMatchCancelLimit);
    if (!limit)
        GTEST_SKIP() << kTooBusy;
    EXPECT_LE(shortest(*limit, timeToCancel), *limit);
}

} // namespace
} // namespace texloom::test
