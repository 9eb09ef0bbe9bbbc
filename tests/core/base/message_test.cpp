#include "core/base/error.h"
#include "core/base/text.h"
#include "tests/support/says.h"

#include <gmock/gmock.h>

#include <map>
#include <new>

namespace texloom::test {
namespace {

/// A language of a few words.
std::string german(const std::string& pattern) {
    static const std::map<std::string, std::string> words = {
        {"{} is {:.1f} px wide; it is {} that is needed.", "{2} ist nötig, {0} ist {1} px breit."},
        {"a mask", "eine Maske"},
        {"{} and {}", "{} und {}"},
        {"{}: {}", "{}: {}"},
        {"Only {}.", "Nur {} und {}."}};
    const auto found = words.find(pattern);
    return found == words.end() ? pattern : found->second;
}

TEST(Message, PutsItsValuesIntoThePattern) {
    const Message made =
        message("{} is {:.1f} px wide; it is {} that is needed.", "bark", 2.25, Message(TR("a mask")));
    EXPECT_EQ(made.text(), "bark is 2.2 px wide; it is a mask that is needed.");
    EXPECT_EQ(fmt::format("{}", made), made.text());
    EXPECT_EQ(made.pattern(), "{} is {:.1f} px wide; it is {} that is needed.");
}

TEST(Message, IsTranslatedWithItsValuesInAnyOrder) {
    const Message made =
        message("{} is {:.1f} px wide; it is {} that is needed.", "bark", 2.25, Message(TR("a mask")));
    EXPECT_EQ(made.text(german), "eine Maske ist nötig, bark ist 2.2 px breit.");
}

TEST(Message, LeavesVerbatimValuesAlone) {
    EXPECT_EQ(message("Only {}.", "a mask").values().front().text(german), "a mask");
    EXPECT_EQ(Message::verbatim("a mask").text(german), "a mask");
    EXPECT_EQ(Message("a mask").text(german), "eine Maske");
}

TEST(Message, KeepsBracesOfValuesAndOfTextsWithoutValues) {
    EXPECT_EQ(message("There is no file {}.", "{1}{}").text(), "There is no file {1}{}.");
    EXPECT_EQ(Message::verbatim("a{}b{").text(), "a{}b{");
    EXPECT_EQ(Message(std::string("An old note of {} px.")).text(), "An old note of {} px.");
}

TEST(Message, ShowsThePlaceForWhichATranslationHasNoValue) {
    EXPECT_EQ(message("Only {}.", 1).text(german), "Nur 1 und {}.");
}

TEST(Message, NestsMessages) {
    const Message inner = message("Only {}.", listOf({"a", "b", "c"}));
    const Message outer = message("{}: {}", "file.json", inner);
    EXPECT_EQ(outer.text(), "file.json: Only a, b and c.");
    EXPECT_EQ(outer.text(german), "file.json: Nur a, b und c und {}.");
}

TEST(Message, ListsWords) {
    EXPECT_EQ(listOf({}).text(), "");
    EXPECT_EQ(listOf({"a"}).text(german), "a");
    EXPECT_EQ(listOf({"a", "b"}).text(german), "a und b");
    EXPECT_EQ(listOf({"a", "b", "c"}).text(), "a, b and c");
}

TEST(Error, KeepsItsMessageBesideTheSentence) {
    try {
        failUsage("{} is {:.1f} px wide; it is {} that is needed.", std::string("bark"), 2.0,
                  Message(TR("a mask")));
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "bark is 2.0 px wide; it is a mask that is needed.");
        EXPECT_EQ(error.message().text(german), "eine Maske ist nötig, bark ist 2.0 px breit.");
        EXPECT_NE(dynamic_cast<const UsageError*>(&error), nullptr);
        EXPECT_EQ(messageOf(error), error.message());
    }
}

TEST(Error, OtherExceptionsHaveAMessageToo) {
    EXPECT_THAT(messageOf(std::bad_alloc()), says("not enough memory"));
    EXPECT_EQ(messageOf(std::runtime_error("odd")), Message::verbatim("odd"));
}

} // namespace
} // namespace texloom::test
