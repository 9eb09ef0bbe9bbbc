// What every method promises that fills holes: Efros–Leung, PatchMatch and quilting.
#include "core/methods/fill_request.h"
#include "tests/support/method_run.h"
#include "tests/support/textures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace texloom::test::fill_tests {
namespace {

std::shared_ptr<const Image> kept(Image image) {
    return std::make_shared<const Image>(std::move(image));
}

/// Where the hole is made: columns 40 to 69 and rows 36 to 59.
bool inHole(int x, int y) {
    return x >= 40 && x < 70 && y >= 36 && y < 60;
}

Image knownAround(Size size) {
    Image known = constant(size, 1, 1);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            known(x, y, 0) = inHole(x, y) ? 0 : 1;
    return known;
}

/// The picture with 77 where the hole is.
Image pierced(Image picture) {
    for (int c = 0; c < picture.channels(); ++c)
        for (int y = 0; y < picture.height(); ++y)
            for (int x = 0; x < picture.width(); ++x)
                if (inHole(x, y))
                    picture(x, y, c) = 77;
    return picture;
}

/// The picture is its own exemplar.
Request requestFor(const Image& picture) {
    Request request = requestOf(picture, picture.size(), {}, 7);
    request.inputs.set(kInitialPort, request.exemplars.front().image);
    request.inputs.set(kKnownPort, kept(knownAround(picture.size())));
    return request;
}

class Fill : public testing::TestWithParam<std::string> {
protected:
    /// Small windows and patches, since the pictures are small.
    Values settings(Values more = {}) const {
        more[GetParam() == "efros-leung" ? "window" : "patch"] = GetParam() == "patchmatch" ? 5 : 9;
        more.try_emplace("tone", false); // copies only
        return more;
    }
    Synthesis filled(const Request& request, const Values& more = {}, int threads = 2) const {
        return resultOf(findMethod(GetParam()), request, settings(more), {.threads = threads});
    }
    std::string refusal(const Request& request, const Values& more = {}) const {
        return refusalOf(findMethod(GetParam()), request, settings(more));
    }
};

TEST_P(Fill, whatIsKnownStaysAndTheRestIsCopied) {
    const Image picture = pierced(blobs({110, 100}, 3));
    const Synthesis result = filled(requestFor(picture));
    EXPECT_EQ(result.mapKind, MapKind::Exact);
    EXPECT_TRUE(samePixels(result.map.apply(picture.view()), result.image));
    for (int y = 0; y < 100; ++y)
        for (int x = 0; x < 110; ++x) {
            const Source& source = result.map.at(x, y);
            if (inHole(x, y)) {
                ASSERT_FALSE(inHole(source.x, source.y)) << x << ", " << y;
            } else {
                ASSERT_EQ(source, (Source{static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y), 0}));
            }
        }
}

TEST_P(Fill, holeInAPeriodIsFilledWithoutATrace) {
    const Image whole = periodic({110, 100}, {8, 8}, 2);
    Values exactly;
    if (GetParam() != "quilting")
        exactly["scales"] = 1;
    if (GetParam() != "patchmatch")
        exactly["tolerance"] = 0.0;
    if (GetParam() == "efros-leung")
        exactly["search"] = std::string("exact"); // the other may miss the window that fits
    EXPECT_TRUE(samePixels(filled(requestFor(pierced(whole)), exactly).image, whole));
}

TEST_P(Fill, sourcesLieWithinTheContextAndTheRadius) {
    const Request request = requestFor(pierced(blobs({110, 100}, 3)));
    const Synthesis near = filled(request, {{"context", 20}});
    const Synthesis around = filled(request, {{"radius", 36}, {"context", 0}});
    int far = 0;
    for (int y = 36; y < 60; ++y)
        for (int x = 40; x < 70; ++x) {
            const Source &one = near.map.at(x, y), &other = around.map.at(x, y);
            ASSERT_TRUE(one.x >= 20 && one.x < 90 && one.y >= 16 && one.y < 80);
            far += std::abs(other.x - x) > 36 || std::abs(other.y - y) > 36;
        }
    // The search by principal components may find nothing near.
    EXPECT_LE(far, GetParam() == "efros-leung" ? 70 : 0);
}

TEST_P(Fill, sameBitsForAnyNumberOfThreads) {
    for (const Wrap wrap : {Wrap{}, Wrap{true, true}}) {
        Request request = requestFor(pierced(blobs({110, 100}, 3)));
        request.wrap = wrap;
        const Synthesis one = filled(request, {}, 1), many = filled(request, {}, 4);
        EXPECT_TRUE(samePixels(one.image, many.image));
        EXPECT_EQ(one.map, many.map);
    }
}

TEST_P(Fill, aPictureIsExtended) {
    // The picture lies in the middle of a larger one, whose rest is to be made from it.
    const Image picture = blobs({60, 50}, 3);
    Image larger = constant({100, 90}, 3, 0), known = constant({100, 90}, 1, 0);
    for (int y = 0; y < 50; ++y)
        for (int x = 0; x < 60; ++x) {
            known(x + 20, y + 20, 0) = 1;
            for (int c = 0; c < 3; ++c)
                larger(x + 20, y + 20, c) = picture(x, y, c);
        }
    Request request = requestFor(picture);
    request.size = larger.size();
    request.inputs.set(kInitialPort, kept(larger));
    request.inputs.set(kKnownPort, kept(known));
    const Synthesis result = filled(request);
    for (int y = 0; y < 90; ++y)
        for (int x = 0; x < 100; ++x) {
            const Source& source = result.map.at(x, y);
            for (int c = 0; c < 3; ++c) {
                const float wanted = known(x, y, 0) != 0 ? larger(x, y, c) : picture(source.x, source.y, c);
                ASSERT_EQ(result.image(x, y, c), wanted) << x << ", " << y;
            }
        }
}

TEST_P(Fill, aSecondExemplarCanBeTheSource) {
    const Image picture = pierced(blobs({110, 100}, 1));
    Request request = requestFor(picture);
    request.exemplars.front().image = kept(blobs({80, 70}, 1, 5));
    const Synthesis result = filled(request);
    EXPECT_EQ(result.mapKind, MapKind::Dominant);
    for (int y = 0; y < 100; ++y)
        for (int x = 0; x < 110; ++x) {
            if (!inHole(x, y)) {
                ASSERT_EQ(result.image(x, y, 0), picture(x, y, 0));
            } else {
                const Source& source = result.map.at(x, y);
                ASSERT_EQ(result.image(x, y, 0), (*request.exemplars.front().image)(source.x, source.y, 0));
            }
        }
}

TEST_P(Fill, refusalsSayWhatToDo) {
    const Image picture = pierced(blobs({110, 100}, 3));
    Request all = requestFor(picture);
    all.inputs.set(kKnownPort, kept(constant(picture.size(), 1, 1)));
    EXPECT_THAT(refusal(all), testing::HasSubstr("nothing to make"));
    Request most = requestFor(picture);
    Image little = constant(picture.size(), 1, 0);
    for (int y = 0; y < 100; ++y)
        for (int x = 0; x < 40; ++x)
            little(x, y, 0) = 1;
    most.inputs.set(kKnownPort, kept(little));
    EXPECT_THAT(refusal(most), testing::HasSubstr("7000 px is larger than the 4000 px"));
    Request lonely = requestFor(picture);
    lonely.inputs.clear(kInitialPort);
    EXPECT_THAT(refusal(lonely), testing::HasSubstr("no image to start from"));
    Request hidden = requestFor(picture);
    hidden.exemplars.front().inputs.set(kMaskPort, kept(constant(picture.size(), 1, 0)));
    EXPECT_THAT(refusal(hidden), testing::HasSubstr("mask"));
    if (GetParam() == "efros-leung")
        return; // grows from a seed
    Request nothing = requestFor(picture);
    nothing.inputs.set(kKnownPort, kept(constant(picture.size(), 1, 0)));
    EXPECT_THAT(refusal(nothing), testing::HasSubstr("Nothing"));
    if (GetParam() == "quilting") {
        EXPECT_THAT(refusal(requestFor(picture), {{"stitch", std::string("feather")}}),
                    testing::HasSubstr("smooth-cut"));
    }
}

INSTANTIATE_TEST_SUITE_P(Methods, Fill, testing::Values("efros-leung", "patchmatch", "quilting"),
                         [](const auto& one) {
                             std::string name = one.param;
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

TEST(FilledWindow, isWhatMasksAndHoleNeed) {
    const Image picture = pierced(blobs({110, 100}, 1));
    const Request request = requestFor(picture);
    const Request hidden = withoutHole(request, 12, 5);
    const FillWindow window(hidden, 5);
    EXPECT_EQ(window.part(), (Region{28, 24, {54, 48}}));
    EXPECT_EQ(window.request().size, (Size{54, 48}));
    EXPECT_TRUE(samePixels(*window.request().exemplars.front().image, picture.view().crop(28, 24, {54, 48})));
    // All of an axis that wraps where the hole's surroundings reach its end.
    Request wrapping = requestFor(picture);
    wrapping.wrap = {true, true};
    const Request far = withoutHole(wrapping, 38, 5);
    const FillWindow larger(far, 5);
    EXPECT_EQ(larger.part(), (Region{2, 0, {106, 100}}));
    EXPECT_EQ(larger.request().wrap, (Wrap{false, true}));
}

TEST(FilledWindow, toneChangesNothingThatIsKnown) {
    const Image picture = pierced(blobs({110, 100}, 3));
    const Request request = requestFor(picture);
    for (const char* method : {"patchmatch", "efros-leung", "quilting"}) {
        const Synthesis result = resultOf(findMethod(method), request, {});
        EXPECT_EQ(result.mapKind, MapKind::Dominant);
        for (int c = 0; c < 3; ++c)
            for (int y = 0; y < 100; ++y)
                for (int x = 0; x < 110; ++x)
                    if (!inHole(x, y)) {
                        ASSERT_EQ(result.image(x, y, c), picture(x, y, c)) << method;
                    }
    }
}

TEST(QuiltedHole, poissonTakesItsLevelFromWhatIsAround) {
    // The source is the picture, 5 brighter.
    const Image whole = periodic({110, 100}, {8, 8}, 1);
    Image brighter = whole;
    for (int y = 0; y < 100; ++y)
        for (int x = 0; x < 110; ++x)
            brighter(x, y, 0) += 0.2F;
    Request request = requestFor(pierced(whole));
    request.exemplars.front().image = kept(brighter);
    const auto step = [&](const char* stitch) {
        const Synthesis result =
            resultOf(findMethod("quilting"), request,
                     {{"patch", 12}, {"tolerance", 0.0}, {"stitch", std::string(stitch)}, {"tone", false}});
        double most = 0;
        for (int y = 0; y < 100; ++y)
            for (int x = 0; x < 110; ++x)
                most = std::max(most, std::abs(static_cast<double>(result.image(x, y, 0) - whole(x, y, 0))));
        return most;
    };
    EXPECT_GT(step("cut"), 0.1);
    EXPECT_LT(step("poisson"), 1e-3);
}

} // namespace
} // namespace texloom::test::fill_tests
