#include "core/io/message_json.h"

#include <gtest/gtest.h>

namespace texloom {
namespace {

using OrderedJson = nlohmann::ordered_json;

Message back(const Message& message) {
    return messageFrom(OrderedJson::parse(toJson(message).dump()));
}

TEST(MessageJson, ComesBackWithPatternsAndValues) {
    const Message plain(TR("Patch size"));
    const Message nested = message("{} is {:.1f} px wide, {}.", Message(TR("Image quilting")), 2.25,
                                   message("{} and {}", "{}", Message("odd\n\"text\"")));
    EXPECT_EQ(back(plain), plain);
    EXPECT_EQ(toJson(plain), OrderedJson("Patch size"));
    EXPECT_EQ(back(nested), nested);
    EXPECT_EQ(messagesFrom(toJson(std::vector<Message>{plain, nested})),
              (std::vector<Message>{plain, nested}));
}

TEST(MessageJson, ReadsTheSentencesOfEarlierVersions) {
    EXPECT_EQ(messageFrom("bark {} was not straightened.").text(), "bark {} was not straightened.");
}

TEST(MessageJson, RefusesWhatIsNoMessage) {
    for (const char* text :
         {"7", "null", "[]", "{}", R"({"pattern": "a"})", R"({"pattern": 1, "values": []})",
          R"({"pattern": "a", "values": [1]})", R"({"pattern": "a", "values": ["b", {}]})"})
        EXPECT_THROW(messageFrom(OrderedJson::parse(text)), OrderedJson::exception) << text;
}

} // namespace
} // namespace texloom
