#include "core/io/message_json.h"

namespace texloom {

using Json = nlohmann::ordered_json;

namespace {

Json patternJson(const Message& message);

Json valueJson(const Message& value) {
    return value.isVerbatim() ? Json(value.pattern()) : patternJson(value);
}

Json patternJson(const Message& message) {
    Json values = Json::array();
    for (const Message& value : message.values())
        values.push_back(valueJson(value));
    return {{"pattern", message.pattern()}, {"values", std::move(values)}};
}

Message patternFrom(const Json& json) {
    std::vector<Message> values;
    for (const Json& value : json.at("values"))
        values.push_back(value.is_string() ? Message::verbatim(value.get<std::string>())
                                           : patternFrom(value));
    return Message(json.at("pattern").get<std::string>(), std::move(values));
}

} // namespace

Json toJson(const Message& message) {
    return message.values().empty() ? Json(message.pattern()) : patternJson(message);
}

Json toJson(const std::vector<Message>& messages) {
    Json json = Json::array();
    for (const Message& message : messages)
        json.push_back(toJson(message));
    return json;
}

Message messageFrom(const Json& json) {
    return json.is_string() ? Message(json.get<std::string>()) : patternFrom(json);
}

std::vector<Message> messagesFrom(const Json& json) {
    std::vector<Message> messages;
    for (const Json& message : json)
        messages.push_back(messageFrom(message));
    return messages;
}

} // namespace texloom
