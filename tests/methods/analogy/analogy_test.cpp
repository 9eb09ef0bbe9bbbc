#include "core/job/job.h"
#include "core/methods/analogy/settings.h"
#include "core/methods/method.h"
#include "tests/support/method_run.h"
#include "tests/support/textures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace texloom::test::analogy_tests {
namespace {

using analogy::Settings;

std::shared_ptr<const Image> shared(Image image) {
    return std::make_shared<const Image>(std::move(image));
}

Synthesis made(const Request& request, const CausalOptions& options) {
    Job<Synthesis> job({request.seed, 2, false},
                       [&](JobContext& context) { return CausalSynthesis(request, options, context).run(); });
    return std::get<Synthesis>(job.take());
}

/// Dark texture to the left and bright to the right, with labels that say so.
struct Halves {
    Image picture = blobs({64, 64}, 1), labels = constant({64, 64}, 1, 0);
    Halves() {
        for (int y = 0; y < 64; ++y)
            for (int x = 32; x < 64; ++x) {
                picture(x, y, 0) += 5;
                labels(x, y, 0) = 1;
            }
    }
};

TEST(Analogy, resultFollowsTheLabels) {
    const Halves halves;
    const Request request = requestOf(halves.picture, {60, 80}, {}, 0);
    Image labels = constant(request.size, 1, 0);
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 60; ++x)
            labels(x, y, 0) = 1;
    CausalOptions options = Settings{}.options();
    CausalGuides& guides = options.guides.emplace();
    guides.exemplars = {&halves.labels};
    guides.output = &labels;
    guides.weight = 20;
    const Image image = made(request, options).image;
    int right = 0;
    for (int y = 0; y < 80; ++y)
        for (int x = 0; x < 60; ++x)
            right += (image(x, y, 0) > 4) == (labels(x, y, 0) > 0);
    EXPECT_GT(right, 60 * 80 * 95 / 100);
}

/// Beyond a border that does not wrap, labels go on as they are, not as on the other side.
TEST(Analogy, theFirstRowsFollowTheirOwnLabels) {
    const Halves halves;
    Image labels = constant({60, 80}, 1, 0);
    for (int y = 0; y < 60; ++y)
        for (int x = 0; x < 60; ++x)
            labels(x, y, 0) = 1;
    Request request = requestOf(halves.picture, labels.size(), {}, 0);
    request.inputs.set("output-guide", shared(std::move(labels)));
    request.exemplars.front().inputs.set("guide", shared(halves.labels));
    for (std::uint64_t seed = 1; seed < 4; ++seed) {
        request.seed = seed;
        const Image image = resultOf(findMethod("analogy"), request, {{"guide-weight", 20}}).image;
        int wrong = 0;
        for (int y = 0; y < 3; ++y)
            for (int x = 0; x < 60; ++x)
                wrong += image(x, y, 0) < 4;
        EXPECT_EQ(wrong, 0) << "seed " << seed;
    }
}

TEST(Analogy, withoutCoherenceAndFalloffItIsWeiLevoys) {
    const Request request = requestOf(blobs({48, 40}, 3), {60, 50}, {}, 0);
    CausalOptions options = Settings{}.options();
    options.coherence = 0;
    options.falloff = false;
    const Values same{{"neighbourhood", 5}, {"levels", 4}, {"parent", 3}, {"leaf", 8}, {"passes", 1}};
    EXPECT_EQ(made(request, options).map, resultOf(findMethod("wei-levoy"), request, same).map);
}

TEST(Analogy, labelsThatAreEqualEverywhereChangeNothing) {
    for (const bool exact : {true, false})
        for (const Wrap wrap : {Wrap{}, Wrap{true, true}}) {
            const Request request = requestOf(blobs({48, 40}, 3), {60, 50}, wrap, 0);
            CausalOptions plain = Settings{}.options();
            plain.exact = exact;
            const Image exemplarLabels = constant({48, 40}, 1, 0.5F), labels = constant({60, 50}, 1, 0.5F);
            CausalOptions guided = plain;
            CausalGuides& guides = guided.guides.emplace();
            guides.exemplars = {&exemplarLabels};
            guides.output = &labels;
            guides.weight = 5;
            EXPECT_EQ(made(request, plain).map, made(request, guided).map) << exact;
        }
}

/// Ashikhmin's rule: of the continuations of the neighbours' copies the one whose causal neighbourhood is
/// nearest. The first two pixels made of a row, which begins 3 px further right than the one above, are left
/// out, since their left neighbours changed later.
TEST(Analogy, boundlessCoherenceIsAshikhmins) {
    const Image exemplar = blobs({40, 36}, 1);
    const Request request = requestOf(exemplar, {50, 44}, {}, 0);
    CausalOptions options = Settings{}.options();
    options.side = 5;
    options.levels = 1;
    options.falloff = false;
    options.exact = true;
    options.coherence = 1e30;
    const Synthesis result = made(request, options);
    const auto distance = [&](int x, int y, int u, int v) {
        double sum = 0;
        for (const PixelRun& run : causalRuns(5))
            for (int dx = run.dx; dx < run.dx + run.count; ++dx)
                sum += std::pow(static_cast<double>(result.image(x + dx, y + run.dy, 0)) -
                                    static_cast<double>(exemplar(u + dx, v + run.dy, 0)),
                                2);
        return sum;
    };
    std::vector<Continuation> found;
    int continuing = 0;
    for (int y = 2; y < 44; ++y)
        for (int x = 2; x < 48; ++x) {
            if ((x + 3 * (50 - y)) % 50 < 2)
                continue;
            double least = std::numeric_limits<double>::infinity();
            coherentCandidates(result.map, causalRuns(5), x, y, {}, found);
            for (const Continuation& one : found)
                if (one.x >= 2 && one.x < 38 && one.y >= 2 && one.y < 36)
                    least = std::min(least, distance(x, y, one.x, one.y));
            const Source source = result.map.at(x, y);
            if (std::isinf(least))
                continue;
            ++continuing;
            EXPECT_LE(distance(x, y, source.x, source.y), least * (1 + 1e-5) + 1e-9) << x << ", " << y;
            EXPECT_TRUE(std::any_of(found.begin(), found.end(),
                                    [&](const Continuation& one) { return one.source() == source; }))
                << x << ", " << y;
        }
    EXPECT_GT(continuing, 42 * 46 / 2);
}

double continued(const PositionMap& map) {
    int count = 0;
    for (int y = 0; y < map.height(); ++y)
        for (int x = 1; x < map.width(); ++x)
            count += map.at(x, y).x == map.at(x - 1, y).x + 1 && map.at(x, y).y == map.at(x - 1, y).y;
    return count / static_cast<double>(map.size().area());
}

TEST(Analogy, coherenceCopiesLargerPieces) {
    const Request request = requestOf(blobs({64, 64}, 3), {96, 96}, {}, 0);
    CausalOptions none = Settings{}.options(), much = none;
    none.coherence = 0;
    much.coherence = 50;
    EXPECT_GT(continued(made(request, much).map), continued(made(request, none).map) + 0.1);
}

TEST(Analogy, picturesThatDoNotGoTogetherAreRefused) {
    const Method& method = findMethod("analogy");
    const Halves halves;
    Request request = requestOf(halves.picture, {60, 80}, {}, 0);
    EXPECT_EQ(refusalOf(method, request), "was taken");
    request.inputs.set("output-guide", shared(constant({60, 80}, 3, 0)));
    EXPECT_THAT(refusalOf(method, request), testing::HasSubstr("picture A"));
    request.exemplars.front().inputs.set("guide", shared(halves.labels));
    EXPECT_THAT(refusalOf(method, request), testing::AllOf(testing::HasSubstr("1"), testing::HasSubstr("3")));
    request.inputs.set("output-guide", shared(constant({60, 80}, 1, 0)));
    EXPECT_EQ(refusalOf(method, request), "was taken");
    request.inputs.set("output-guide", shared(constant({60, 80}, 1, 0.5F)));
    EXPECT_THAT(refusalOf(method, request),
                testing::AllOf(testing::HasSubstr("(0.5)"), testing::HasSubstr("(0) and (1)")));
    request.inputs.clear("output-guide");
    EXPECT_THAT(refusalOf(method, request), testing::HasSubstr("picture B"));
}

} // namespace
} // namespace texloom::test::analogy_tests
