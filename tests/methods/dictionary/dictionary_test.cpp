#include "core/base/error.h"
#include "core/io/model_file.h"
#include "core/methods/dictionary_model.h"
#include "tests/support/method_run.h"
#include "tests/support/textures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>
#include <set>

namespace texloom::test::dictionary_tests {
namespace {

using testing::HasSubstr;

Request requestFor(Image exemplar) {
    return requestOf(std::move(exemplar), {120, 90});
}

Synthesis learn(const Request& request, const Values& settings) {
    return resultOf(findMethod("dictionary"), request, settings);
}

const Values kBrief = {{"atoms", 40}, {"learning-iterations", 3}};

TextureDictionaries dictionariesOf(const Synthesis& result) {
    return TextureDictionaries::from(*result.outputs.first<Model>(kDictionaryPort));
}

TEST(DictionaryMethod, givesADictionaryForEachScale) {
    const TextureDictionaries learnt = dictionariesOf(learn(requestFor(blobs({100, 96}, 3)), kBrief));
    EXPECT_EQ(learnt.patch, 12);
    EXPECT_EQ(learnt.channels(), 3);
    ASSERT_EQ(learnt.scales.size(), 3U);
    for (const Dictionary& scale : learnt.scales) {
        EXPECT_EQ(scale.count(), 40);
        EXPECT_EQ(scale.length(), 3 * 12 * 12);
        EXPECT_LE(std::accumulate(scale.uses.begin(), scale.uses.end(), std::int64_t{0}), 4 * scale.signals);
        for (Eigen::Index n = 0; n < 40; ++n)
            EXPECT_NEAR(scale.atoms.col(n).norm(), 1, 1e-4);
    }
}

TEST(DictionaryMethod, handsItsModelOnButNotThePictureOfIt) {
    const MethodInfo& sparse = findMethod("sparse").info();
    const std::vector<PortLink> links = linksBetween(findMethod("dictionary").info(), sparse);
    ASSERT_EQ(links.size(), 1U);
    EXPECT_EQ(links.front().to, kDictionaryPort);
    const std::vector<PortLink> others = linksBetween(findMethod("quilting").info(), sparse);
    ASSERT_EQ(others.size(), 1U);
    EXPECT_EQ(others.front().to, kInitialPort);
}

TEST(DictionaryMethod, comesBackFromAFileAsItWas) {
    const Synthesis result = learn(requestFor(blobs({64, 64}, 2)), kBrief);
    const auto model = result.outputs.first<Model>(kDictionaryPort);
    const TextureDictionaries before = TextureDictionaries::from(*model);
    const TextureDictionaries after = TextureDictionaries::from(modelFromBytes(model->bytes(), "a file"));
    EXPECT_EQ(*after.model(), *model);
    EXPECT_EQ(after.scales.front().atoms, before.scales.front().atoms);
}

TEST(DictionaryMethod, modelsThatDoNotFitTogetherAreRefused) {
    const auto model = learn(requestFor(blobs({64, 64}, 1)), kBrief).outputs.first<Model>(kDictionaryPort);
    Model torn = *model;
    torn.arrays.erase("scale-0/uses");
    EXPECT_THROW(TextureDictionaries::from(torn), Error);
    torn = *model;
    torn.arrays["scale-0/atoms"].shape = {39, 144};
    EXPECT_THROW(TextureDictionaries::from(torn), Error);
    torn = *model;
    std::get<std::vector<std::int64_t>>(torn.arrays["scale-0/uses"].values).front() = -1;
    EXPECT_THROW(TextureDictionaries::from(torn), Error);
    torn = *model;
    std::get<std::vector<std::int64_t>>(torn.arrays["layout"].values).front() = 1 << 20;
    EXPECT_THROW(TextureDictionaries::from(torn), Error);
}

TEST(DictionaryMethod, saysThatThereAreFewerPatchesThanAtoms) {
    const Synthesis result = learn(requestFor(blobs({16, 15}, 1)), kBrief);
    EXPECT_EQ(dictionariesOf(result).scales.front().count(), 20);
    ASSERT_FALSE(result.notes.empty());
    EXPECT_THAT(result.notes.front().text(), HasSubstr("20 atoms instead of 40"));
}

TEST(DictionaryMethod, learnsFromWhatTheMaskLeaves) {
    Image exemplar = constant({60, 50}, 1, 0.5F);
    const Image left = blobs({30, 50}, 1);
    for (int y = 0; y < 50; ++y)
        for (int x = 0; x < 30; ++x)
            exemplar(x, y, 0) = left(x, y, 0);
    for (int y = 0; y < 50; ++y)
        for (int x = 30; x < 60; ++x)
            exemplar(x, y, 0) = (x + y) % 2 == 0 ? 100.0F : -100.0F;
    Image mask = constant({60, 50}, 1, 1);
    for (int y = 0; y < 50; ++y)
        for (int x = 30; x < 60; ++x)
            mask(x, y, 0) = 0;
    Values settings = kBrief;
    settings["scales"] = 1;
    Request masked = requestFor(exemplar), cropped = requestFor(left);
    masked.exemplars.front().inputs.set(kMaskPort, std::make_shared<const Image>(std::move(mask)));
    EXPECT_EQ(dictionariesOf(learn(masked, settings)).scales.front().atoms,
              dictionariesOf(learn(cropped, settings)).scales.front().atoms);
}

TEST(DictionaryMethod, wantsAPatchWithRoomForItsAtoms) {
    EXPECT_THAT(
        refusalOf(findMethod("dictionary"), requestFor(blobs({40, 40}, 1)), {{"patch", 4}, {"sparsity", 17}}),
        HasSubstr("16"));
}

TEST(DictionaryMethod, atomsStartFromTheMeanIfAsked) {
    Image far = blobs({40, 40}, 1);
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 40; ++x)
            far(x, y, 0) += 1000;
    Values settings = kBrief;
    settings["centred"] = true;
    const TextureDictionaries centred = dictionariesOf(learn(requestFor(std::move(far)), settings));
    EXPECT_NEAR(centred.origin.front(), 1000.5, 0.4);
    EXPECT_EQ(dictionariesOf(learn(requestFor(blobs({40, 40}, 1)), kBrief)).origin.front(), 0);
}

} // namespace
} // namespace texloom::test::dictionary_tests
