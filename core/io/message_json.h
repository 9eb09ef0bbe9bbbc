#pragma once

#include "core/base/message.h"

#include <nlohmann/json.hpp>

#include <vector>

namespace texloom {

/// A message as text where it has no values, and otherwise as {"pattern": "…", "values": […]}, so that it can
/// be translated whenever it is shown. A value is text where it is verbatim.
nlohmann::ordered_json toJson(const Message& message);
nlohmann::ordered_json toJson(const std::vector<Message>& messages);

/// The message that toJson() wrote, or an English sentence as earlier versions did.
/// @throws nlohmann::json::exception where it is none.
Message messageFrom(const nlohmann::ordered_json& json);
std::vector<Message> messagesFrom(const nlohmann::ordered_json& json);

} // namespace texloom
