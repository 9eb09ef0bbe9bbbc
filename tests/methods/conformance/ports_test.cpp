// What a method takes and gives is what its ports and parameters say.

#include "core/base/error.h"
#include "core/io/model_file.h"
#include "tests/methods/conformance/fixture.h"
#include "tests/support/textures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace texloom::test {
namespace {

using testing::HasSubstr;

TEST_P(Conformance, givesWhatItSays) {
    const Synthesis& result = usualResult(method());
    EXPECT_EQ(result.mapKind == MapKind::Exact || result.mapKind == MapKind::Dominant,
              method().info().copiesPixels());
    for (const Port& port : method().info().gives) {
        const std::vector<Asset>& given = result.outputs.at(port.id);
        const bool own = port.id != kImagePort && port.id != kMapPort; // those two have members of their own
        EXPECT_GE(static_cast<int>(given.size()), own ? port.least : 0) << port.id;
        EXPECT_LE(static_cast<int>(given.size()), port.most) << port.id;
        for (const Asset& asset : given)
            EXPECT_TRUE(isOf(port.kind, asset)) << port.id;
    }
    for (const auto& [id, given] : result.outputs.byPort())
        EXPECT_NE(method().info().output(id), nullptr) << id << " is not declared";
}

TEST_P(Conformance, modelsAreOfTheKindThatTheirPortSays) {
    const Synthesis& result = usualResult(method());
    for (const Port& port : method().info().gives)
        if (port.kind == AssetKind::Model) {
            ASSERT_NE(result.outputs.first<Model>(port.id), nullptr) << port.id;
            EXPECT_EQ(result.outputs.first<Model>(port.id)->kind, port.id);
        }
    for (const Port& port : method().info().takes) {
        if (port.kind != AssetKind::Model)
            continue;
        Request request = requestFor({50, 61}, 3, {97, 80});
        auto other = std::make_shared<Model>();
        other->kind = "another";
        request.inputs.set(port.id, std::shared_ptr<const Model>(other));
        try {
            runWith(method(), request, 1);
            ADD_FAILURE() << "a model of another kind was taken";
        } catch (const UsageError& error) {
            EXPECT_THAT(error.what(), HasSubstr(port.id));
            EXPECT_THAT(error.what(), HasSubstr("another"));
        }
    }
}

TEST_P(Conformance, whatHasNoPortIsRefusedByName) {
    Request request = requestFor({50, 61}, 3, {97, 80});
    request.inputs.set("nonesuch", shared(constant({97, 80}, 3, 0.5F)));
    try {
        runWith(method(), request, 1);
        ADD_FAILURE() << "an input of no port was taken";
    } catch (const UsageError& error) {
        EXPECT_THAT(error.what(), HasSubstr("nonesuch"));
    }
}

TEST_P(Conformance, exactMapGivesTheResult) {
    const Request request = requestFor({50, 61}, 4, {133, 97});
    const Synthesis result = runWith(method(), request, 2);
    EXPECT_EQ(result.image.size(), request.size);
    if (learns(method().info())) {
        EXPECT_EQ(result.image.channels(), request.channels());
    }
    if (result.mapKind == MapKind::None)
        return;
    ASSERT_EQ(result.map.size(), request.size);
    if (result.mapKind == MapKind::Exact) {
        EXPECT_TRUE(samePixels(result.map.apply(request.exemplars.front().image->view()), result.image));
    }
}

TEST_P(Conformance, initialImageOfAnotherSizeIsRefused) {
    Request request = requestFor({64, 64}, 3, {80, 80});
    request.inputs.set(kInitialPort, shared(constant({80, 79}, 3, 0.5F)));
    EXPECT_THROW(runWith(method(), request, 1), UsageError);
}

TEST_P(Conformance, valuesOutOfRangeAreRefusedByNameAndLimit) {
    for (const Param& param : method().params()) {
        if (!param.hasRange())
            continue;
        for (const double value : {param.smallest() - 1, param.largest() + 1})
            try {
                method().resolved({{param.name(), value}}, {64, 64});
                ADD_FAILURE() << param.name() << " = " << value << " was taken";
            } catch (const UsageError& error) {
                EXPECT_THAT(error.what(), HasSubstr(param.name() + " = "));
                EXPECT_THAT(error.what(), HasSubstr(param.limits().text()));
            }
    }
}

TEST_P(Conformance, everyParameterIsExplained) {
    for (const Param& param : method().params()) {
        EXPECT_FALSE(param.title().empty()) << param.name();
        EXPECT_GT(param.help().size(), 20U) << param.name();
        EXPECT_NO_THROW(param.checked(param.defaultFor(0))) << param.name();
        for (const int side : {1, 7, 64, 1000, 60000})
            EXPECT_NO_THROW(param.checked(param.defaultFor(side)))
                << param.name() << " for " << side << " px";
    }
    EXPECT_FALSE(method().info().summary.empty());
    EXPECT_FALSE(method().info().citation.empty());
}

} // namespace
} // namespace texloom::test
