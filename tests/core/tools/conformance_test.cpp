#include "core/base/error.h"
#include "core/base/text.h"
#include "core/image/resample.h"
#include "core/io/edit_json.h"
#include "core/session/run/edited_exemplar.h"
#include "core/tools/edits.h"
#include "tests/core/refusal.h"
#include "tests/support/textures.h"

#include <algorithm>
#include <cmath>

namespace texloom::test {

namespace {

constexpr Size kSize{64, 52};

bool edits(const Tool& tool) {
    return !tool.joins();
}

/// A value of a parameter that suits an image of kSize, and is not the default where there is another.
Value suiting(const Param& param) {
    switch (param.type()) {
    case Param::Type::Area:
        return Wholes{3, 5, 40, 32};
    case Param::Type::Size:
        return Wholes{24, 20};
    case Param::Type::Points:
        return PlanePoints{{6, 5}, {58, 8}, {60, 48}, {4, 44}};
    case Param::Type::Toggle:
        return !std::get<bool>(param.defaultFor(0));
    case Param::Type::Choice:
        return param.choices().back().id;
    case Param::Type::Integer:
        return static_cast<int>((param.usualFrom() + 3 * param.usualTo()) / 4);
    case Param::Type::Real:
        break;
    }
    return (param.usualFrom() + 3 * param.usualTo()) / 4;
}

ExemplarEdit sampleOf(const Tool& tool) {
    ExemplarEdit edit;
    for (const Param& param : tool.params())
        edit[param.name()] = suiting(param);
    return resolved(edit);
}

/// A value beyond a parameter's limits, and what the refusal must name.
std::pair<Value, std::string> beyond(const Param& param) {
    switch (param.type()) {
    case Param::Type::Area:
        return {Wholes{0, 0, 0, 4}, "width"};
    case Param::Type::Size:
        return {Wholes{0, 4}, "width"};
    case Param::Type::Points:
        return {PlanePoints{{1, 2}}, std::to_string(param.pointCount())};
    case Param::Type::Toggle:
        return {3, "on or off"};
    case Param::Type::Choice:
        return {std::string("no-such"), param.choices().front().id};
    case Param::Type::Integer:
    case Param::Type::Real:
        break;
    }
    return {param.largest() + 1, numberText(param.largest())};
}

ExemplarFile fileOf(Image image, MapRole role = MapRole::Other) {
    ExemplarFile file;
    file.image = std::make_shared<const Image>(std::move(image));
    file.role = role;
    return file;
}

/// An exemplar with all that can belong to one: its companion has the same pixels, so that it must stay like
/// it.
RunExemplar wholeExemplar() {
    RunExemplar exemplar;
    exemplar.image = fileOf(blobs(kSize, 3));
    exemplar.image.space = "srgb";
    Image mask = blobs(kSize, 1, 7);
    for (int y = 0; y < kSize.height; ++y)
        for (int x = 0; x < kSize.width; ++x)
            mask(x, y, 0) = mask(x, y, 0) > 0.2F ? 1.0F : 0.0F;
    exemplar.mask = fileOf(std::move(mask));
    exemplar.companions = {fileOf(blobs(kSize, 3)), fileOf(blobs(kSize, 3, 5), MapRole::NormalGl)};
    exemplar.inputs["guide"] = {fileOf(blobs(kSize, 3))};
    return exemplar;
}

void expectAlike(const RunExemplar& a, const RunExemplar& b) {
    EXPECT_TRUE(samePixels(*a.image.image, *b.image.image));
    EXPECT_TRUE(samePixels(*a.mask->image, *b.mask->image));
    for (std::size_t i = 0; i < a.companions.size(); ++i)
        EXPECT_TRUE(samePixels(*a.companions[i].image, *b.companions[i].image));
    EXPECT_TRUE(samePixels(*a.inputs.at("guide").front().image(), *b.inputs.at("guide").front().image()));
}

/// Values with which a tool joins two pictures of kSize: those of each preset, or where there is none, others
/// than the defaults.
std::vector<Values> joinsOf(const Tool& tool) {
    Values values;
    for (const Param& param : tool.params())
        values[param.name()] = param.type() == Param::Type::Integer
                                   ? Value(static_cast<int>(param.largestFor(kSize.shorterSide()) / 2))
                                   : suiting(param);
    if (tool.info().handle == ToolHandle::Offset) {
        values["offset-x"] = 7;
        values["offset-y"] = -5;
    }
    std::vector<Values> all;
    for (const ToolPreset& preset : tool.info().presets) {
        all.push_back(values);
        for (const auto& [name, value] : preset.values)
            all.back()[name] = value;
    }
    return all.empty() ? std::vector<Values>{tool.resolved(values)} : all;
}

Image joined(const Tool& tool, const Values& values, int threads, std::function<bool()> stopped = {}) {
    JobMonitor monitor;
    JobContext context(
        {0, threads, false}, stopped ? std::move(stopped) : [] { return false; }, monitor);
    return tool.joined({blobs(kSize, 3, 1), blobs(kSize, 3, 2)}, values, context);
}

} // namespace

/// What every registered tool promises.
class ToolConformance : public ::testing::TestWithParam<std::string> {
protected:
    const Tool& tool() const { return findTool(GetParam()); }
};

TEST_P(ToolConformance, SaysWhatItIs) {
    EXPECT_FALSE(tool().info().title.empty());
    EXPECT_FALSE(tool().info().summary.empty());
    ASSERT_FALSE(tool().params().empty());
    for (const Param& param : tool().params()) {
        EXPECT_FALSE(param.title().empty()) << param.name();
        EXPECT_FALSE(param.help().empty()) << param.name();
        if (param.type() == Param::Type::Integer || param.type() == Param::Type::Real) {
            EXPECT_TRUE(param.hasRange()) << param.name();
        }
    }
}

TEST_P(ToolConformance, AnEditNamesItsToolAndNoOther) {
    if (!edits(tool()))
        GTEST_SKIP() << "skipped: it joins two pictures";
    EXPECT_EQ(tool().params().front().name(), tool().id());
    for (const Tool& other : tools())
        for (const Param& param : other.params())
            if (&other != &tool() && edits(other)) {
                EXPECT_NE(param.name(), tool().id()) << other.id();
            }
    EXPECT_EQ(&toolOf(sampleOf(tool())), &tool());
    for (const ToolPreset& preset : tool().info().presets)
        EXPECT_EQ(&toolOf(preset.values), &tool()) << preset.help;
}

TEST_P(ToolConformance, RefusesByNameAndLimit) {
    for (const Param& param : tool().params()) {
        const auto [value, limit] = beyond(param);
        EXPECT_THAT(([&, wrong = value] {
                        tool().resolved({{param.name(), wrong}});
                    }),
                    usageRefusal(param.name(), limit));
    }
    EXPECT_THAT([&] { tool().resolved({{"no-such", 1}}); }, usageRefusal(tool().id(), "no-such"));
}

TEST_P(ToolConformance, TheCommandLineSaysTheSame) {
    if (!edits(tool()))
        GTEST_SKIP() << "skipped: it joins two pictures";
    const ExemplarEdit edit = sampleOf(tool());
    std::string text = tool().id() + "=" + toText(edit.at(tool().id()));
    for (const auto& [name, value] : edit)
        if (name != tool().id())
            text += " " + name + "=" + toText(value);
    EXPECT_EQ(parseEdit(text), edit) << text;
}

TEST_P(ToolConformance, TheSizeForetoldIsTheSizeMade) {
    if (!edits(tool()))
        GTEST_SKIP() << "skipped: it joins two pictures";
    const ExemplarEdit edit = sampleOf(tool());
    Image image = blobs(kSize, 3);
    if (tool().warps())
        image = resampled(image, warpOf({edit}, kSize));
    else
        tool().recolor(image, tool().resolved(edit), nullptr);
    EXPECT_EQ(image.size(), sizeAfter(edit, kSize));
    for (int c = 0; c < 3; ++c)
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                ASSERT_TRUE(std::isfinite(image(x, y, c)));
}

TEST_P(ToolConformance, WhatBelongsToTheExemplarComesAlong) {
    if (!edits(tool()))
        GTEST_SKIP() << "skipped: it joins two pictures";
    const RunExemplar source = wholeExemplar();
    const RunExemplar made = edited(source, {sampleOf(tool())});
    EXPECT_FALSE(samePixels(*made.image.image, *source.image.image));
    if (tool().warps()) {
        EXPECT_TRUE(samePixels(*made.companions[0].image, *made.image.image));
        EXPECT_TRUE(samePixels(*made.inputs.at("guide").front().image(), *made.image.image));
        EXPECT_EQ(made.mask->image->size(), made.image.image->size());
        EXPECT_EQ(made.companions[1].image->size(), made.image.image->size());
        EXPECT_FALSE(samePixels(*made.mask->image, *source.mask->image));
    } else {
        EXPECT_EQ(made.companions[0].image, source.companions[0].image);
        EXPECT_EQ(made.companions[1].image, source.companions[1].image);
        EXPECT_EQ(made.mask->image, source.mask->image);
    }
}

TEST_P(ToolConformance, AMaskHidesWhateverComesOfWhatItHid) {
    if (!tool().warps())
        GTEST_SKIP() << "skipped: it moves no pixels";
    RunExemplar source = wholeExemplar();
    // A picture that shows where the mask hides it: wherever any of that is in a pixel, it must be hidden.
    source.image = fileOf(*source.mask->image);
    const RunExemplar made = edited(source, {sampleOf(tool())});
    for (int y = 0; y < made.image.image->height(); ++y)
        for (int x = 0; x < made.image.image->width(); ++x)
            if ((*made.mask->image)(x, y, 0) != 0) {
                ASSERT_NEAR((*made.image.image)(x, y, 0), 1, 1e-5) << x << ", " << y;
            }
}

TEST_P(ToolConformance, UndoneItIsAsItWas) {
    if (!edits(tool()))
        GTEST_SKIP() << "skipped: it joins two pictures";
    const RunExemplar source = wholeExemplar();
    const RunExemplar undone = edited(edited(source, {sampleOf(tool())}), {});
    EXPECT_EQ(undone.image.image, source.image.image);
    EXPECT_EQ(undone.mask->image, source.mask->image);
    EXPECT_EQ(undone.companions[0].image, source.companions[0].image);
    EXPECT_EQ(undone.inputs.at("guide").front().file.image, source.inputs.at("guide").front().file.image);
    EXPECT_TRUE(undone.edits.empty());
}

TEST_P(ToolConformance, MadeAgainItIsTheSameToTheBit) {
    if (tool().joins()) {
        for (const Values& values : joinsOf(tool()))
            EXPECT_TRUE(samePixels(joined(tool(), values, 1), joined(tool(), values, 3)));
        return;
    }
    const RunExemplar source = wholeExemplar();
    const ExemplarEdits edits = {sampleOf(tool())};
    const RunExemplar made = edited(source, edits);
    expectAlike(made, edited(source, edits));
    expectAlike(made, edited(made, edits)); // of the original, not of what was made of it
}

TEST_P(ToolConformance, ARecipeHoldsIt) {
    if (!edits(tool()))
        GTEST_SKIP() << "skipped: it joins two pictures";
    const ExemplarEdits edits = {sampleOf(tool())};
    const JsonField::Json json = parseJson("recipe", toJson(edits).dump());
    EXPECT_EQ(resolved(editsFrom(JsonField("recipe", json))), edits) << json;
}

TEST_P(ToolConformance, AJoinTakesPicturesThatSuitAndRefusesTheOthers) {
    if (!tool().joins())
        GTEST_SKIP() << "skipped: it edits one picture";
    const Values values = joinsOf(tool()).front();
    const Image made = joined(tool(), values, 2);
    EXPECT_EQ(made.channels(), 3);
    EXPECT_FALSE(samePixels(made, blobs(kSize, 3, 1)));
    EXPECT_THAT(
        [&] {
            tool().checkJoin({blobs(kSize, 3), blobs(kSize, 1)}, values);
        },
        usageRefusal("3", "1"));
    if (tool().joinsSameSize()) {
        EXPECT_THAT(
            [&] {
                tool().checkJoin({blobs(kSize, 3), blobs({30, 52}, 3)}, values);
            },
            usageRefusal("64 × 52", "30 × 52"));
    }
    if (tool().info().region) {
        const Image mask({30, 52}, 1);
        EXPECT_THAT(
            [&] {
                tool().checkJoin({blobs(kSize, 3), blobs(kSize, 3), &mask}, values);
            },
            usageRefusal("30 × 52", "64 × 52"));
    }
}

TEST_P(ToolConformance, AJoinCanBeStopped) {
    if (!tool().joins())
        GTEST_SKIP() << "skipped: it edits one picture";
    for (const Values& values : joinsOf(tool())) {
        int asked = 0;
        EXPECT_THROW(joined(tool(), values, 1, [&asked] { return ++asked > 2; }), Cancelled);
    }
}

TEST_P(ToolConformance, AWarpKnowsItsDerivativesAndItsWayBack) {
    if (!tool().warps())
        GTEST_SKIP() << "skipped: it moves no pixels";
    const Warp warp = warpOf({sampleOf(tool())}, kSize);
    const Size size = warp.size();
    for (const PlanePoint at : {PlanePoint{0.3 * size.width, 0.4 * size.height},
                                {0.8 * size.width, 0.2 * size.height},
                                {0.5, size.height - 0.5}}) {
        constexpr double kStep = 1e-4;
        const Eigen::Matrix2d derivative = warp.jacobian(at);
        const PlanePoint right = warp.toSource({at.x + kStep, at.y}),
                         left = warp.toSource({at.x - kStep, at.y});
        const PlanePoint low = warp.toSource({at.x, at.y + kStep}),
                         high = warp.toSource({at.x, at.y - kStep});
        EXPECT_NEAR(derivative(0, 0), (right.x - left.x) / (2 * kStep), 0.02);
        EXPECT_NEAR(derivative(1, 0), (right.y - left.y) / (2 * kStep), 0.02);
        EXPECT_NEAR(derivative(0, 1), (low.x - high.x) / (2 * kStep), 0.02);
        EXPECT_NEAR(derivative(1, 1), (low.y - high.y) / (2 * kStep), 0.02);
        const PlanePoint back = warp.fromSource(warp.toSource(at), {0.5 * size.width, 0.5 * size.height});
        EXPECT_NEAR(back.x, at.x, 0.01);
        EXPECT_NEAR(back.y, at.y, 0.01);
    }
}

TEST_P(ToolConformance, CanBeStopped) {
    struct Stop {};
    if (!edits(tool()))
        GTEST_SKIP() << "skipped: joins are jobs";
    const ExemplarEdit edit = sampleOf(tool());
    int calls = 0;
    const ToolCheck check = [&calls] {
        if (++calls == 3)
            throw Stop{};
    };
    Image image = blobs(kSize, 3);
    if (tool().warps()) {
        EXPECT_THROW(resampled(image, warpOf({edit}, kSize), check), Stop);
    } else {
        EXPECT_THROW(tool().recolor(image, tool().resolved(edit), nullptr, check), Stop);
    }
}

TEST_P(ToolConformance, PresetsCanBeMade) {
    for (const ToolPreset& preset : tool().info().presets) {
        EXPECT_FALSE(preset.title.empty());
        EXPECT_FALSE(preset.help.empty());
        EXPECT_NO_THROW(tool().resolved(preset.values)) << preset.help;
        if (edits(tool())) {
            EXPECT_FALSE(sizeAfter(preset.values, kSize).empty()) << preset.help;
        }
    }
}

std::vector<std::string> idsOfTools() {
    std::vector<std::string> ids;
    for (const Tool& tool : tools())
        ids.push_back(tool.id());
    return ids;
}

INSTANTIATE_TEST_SUITE_P(Tools, ToolConformance, ::testing::ValuesIn(idsOfTools()), [](const auto& test) {
    std::string name = test.param;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

} // namespace texloom::test
