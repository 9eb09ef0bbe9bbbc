#include "core/job/job.h"
#include "core/match/grid_match.h"
#include "tests/support/textures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace texloom::test {

namespace {

GridMatcher::Gather from(const ImageView& image) {
    return [image](int x, int y, Size extent, Interleaved& to) { to.load(image, x, y, extent); };
}

PatchField matched(const ImageView& canvas, const std::vector<PatchSource>& sources, int patch, int stride,
                   int rounds, int threads = 2, double uniformity = 0) {
    Job<PatchField> job({5, threads, false}, [&](JobContext& context) {
        context.stage(1, "matching");
        GridMatcher matcher(sources, {canvas.size(), patch, stride}, context);
        PatchField field(matcher.lattice().count());
        for (int y = 0; y < field.size().height; ++y)
            for (int x = 0; x < field.size().width; ++x)
                field.at(x, y).source = matcher.any(x, y);
        for (int round = 0; round < rounds; ++round) {
            matcher.improve(field, from(canvas), round, 1 << 16);
            matcher.discourage(field, uniformity);
        }
        return field;
    });
    return std::get<PatchField>(job.take());
}

double distanceAt(const ImageView& canvas, int x, int y, const ImageView& source, int u, int v, int patch) {
    double sum = 0;
    for (int c = 0; c < canvas.channels; ++c)
        for (int j = 0; j < patch; ++j)
            for (int i = 0; i < patch; ++i) {
                const double d = static_cast<double>(
                    canvas((x + i) % canvas.width, (y + j) % canvas.height, c) - source(u + i, v + j, c));
                sum += d * d;
            }
    return sum;
}

double exhaustiveMean(const ImageView& canvas, const ImageView& source, int patch, int stride) {
    double sum = 0;
    int count = 0;
    for (int y = 0; y < canvas.height; y += stride)
        for (int x = 0; x < canvas.width; x += stride, ++count) {
            double best = std::numeric_limits<double>::infinity();
            for (int v = 0; v + patch <= source.height; ++v)
                for (int u = 0; u + patch <= source.width; ++u)
                    best = std::min(best, distanceAt(canvas, x, y, source, u, v, patch));
            sum += best;
        }
    return sum / count;
}

} // namespace

TEST(GridMatch, comesNearTheNearestNeighboursAllRoundTheTorus) {
    const Image exemplar = blobs({40, 36}, 3), canvas = blobs({51, 46}, 3, 2);
    const double best = exhaustiveMean(canvas, exemplar, 7, 2);
    const double found = matched(canvas, {{exemplar, {}}}, 7, 2, 12).meanDistance();
    EXPECT_GE(found, best * (1 - 1e-5));
    EXPECT_LE(found, best * 1.12);
}

TEST(GridMatch, distancesAreThoseOfTheMatches) {
    for (const int channels : {1, 3, 6}) {
        const Image exemplar = blobs({30, 30}, channels), canvas = blobs({90, 70}, channels, 2);
        const PatchField field = matched(canvas, {{exemplar, {}}}, 8, 3, 2);
        EXPECT_EQ(field.size(), (Size{30, 24}));
        for (int y = 0; y < field.size().height; ++y)
            for (int x = 0; x < field.size().width; ++x) {
                const PatchMatch& match = field.at(x, y);
                ASSERT_NEAR(match.distance,
                            distanceAt(canvas, 3 * x, 3 * y, exemplar, match.source.x, match.source.y, 8),
                            1e-3);
            }
    }
}

TEST(GridMatch, threadsChangeNothing) {
    const Image exemplar = blobs({40, 44}, 3), canvas = blobs({260, 190}, 3, 2);
    const PatchField one = matched(canvas, {{exemplar, {}}}, 5, 2, 4, 1, 1.0);
    const PatchField many = matched(canvas, {{exemplar, {}}}, 5, 2, 4, 7, 1.0);
    for (int y = 0; y < one.size().height; ++y)
        for (int x = 0; x < one.size().width; ++x)
            ASSERT_EQ(one.at(x, y).source, many.at(x, y).source) << x << ", " << y;
}

TEST(GridMatch, findsOnlyWhatTheMaskAllows) {
    const Image exemplar = blobs({40, 40}, 1), canvas = blobs({50, 50}, 1, 2);
    Image mask = constant({40, 40}, 1, 1);
    for (int y = 0; y < 40; ++y)
        mask(20, y, 0) = 0;
    const PatchField field = matched(canvas, {{exemplar, mask.view().plane(0)}}, 6, 2, 3);
    for (int y = 0; y < field.size().height; ++y)
        for (int x = 0; x < field.size().width; ++x) {
            const int left = field.at(x, y).source.x;
            ASSERT_TRUE(left + 6 <= 20 || left > 20) << left;
        }
}

TEST(GridMatch, uniformityUsesMoreOfTheExemplar) {
    const Image exemplar = blobs({48, 48}, 3), canvas = constant({96, 96}, 3, 0.5F);
    const auto different = [](const PatchField& field) {
        std::vector<int> places;
        for (int y = 0; y < field.size().height; ++y)
            for (int x = 0; x < field.size().width; ++x)
                places.push_back(field.at(x, y).source.y * 64 + field.at(x, y).source.x);
        std::sort(places.begin(), places.end());
        return std::unique(places.begin(), places.end()) - places.begin();
    };
    const auto plain = different(matched(canvas, {{exemplar, {}}}, 7, 2, 8));
    EXPECT_GT(different(matched(canvas, {{exemplar, {}}}, 7, 2, 8, 2, 2.0)), 4 * plain);
}

} // namespace texloom::test
