#include "core/io/image_decode.h"
#include "core/io/message_json.h"

#include <nlohmann/json.hpp>

namespace texloom {

using Json = nlohmann::ordered_json;

namespace {

Json colorJson(const FileColor& color) {
    return {{"curve", static_cast<int>(color.curve)},
            {"power", color.power},
            {"table", color.table},
            {"toRec709", color.toRec709},
            {"name", texloom::toJson(color.name)}};
}

FileColor colorFrom(const Json& json) {
    FileColor color;
    color.curve = static_cast<FileColor::Curve>(json.at("curve").get<int>());
    json.at("power").get_to(color.power);
    json.at("table").get_to(color.table);
    json.at("toRec709").get_to(color.toRec709);
    color.name = messageFrom(json.at("name"));
    return color;
}

} // namespace

std::string DecodedHeader::toJson() const {
    Json json = {{"size", {info.size.width, info.size.height}},
                 {"channels", info.channels},
                 {"format", info.format},
                 {"depth", info.depth},
                 {"space", info.space},
                 {"iccProfile", info.iccProfile},
                 {"recipe", info.recipe},
                 {"name", info.name},
                 {"channelNames", info.channelNames},
                 {"associatedAlpha", info.associatedAlpha},
                 {"compression", info.compression},
                 {"layer", info.layer},
                 {"layers", info.layers},
                 {"notes", texloom::toJson(info.notes)},
                 {"texts", info.texts},
                 {"stored", {stored.width, stored.height}},
                 {"orientation", orientation},
                 {"steps", steps},
                 {"samples", samples}};
    if (info.color)
        json["color"] = colorJson(*info.color);
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

DecodedHeader DecodedHeader::fromJson(const std::string& text) {
    const Json json = Json::parse(text);
    const auto sizeAt = [&json](const char* key) {
        return Size{json.at(key).at(0).get<int>(), json.at(key).at(1).get<int>()};
    };
    DecodedHeader header;
    ImageFileInfo& info = header.info;
    info.size = sizeAt("size");
    json.at("channels").get_to(info.channels);
    json.at("format").get_to(info.format);
    json.at("depth").get_to(info.depth);
    json.at("space").get_to(info.space);
    if (json.contains("color"))
        info.color = colorFrom(json.at("color"));
    json.at("iccProfile").get_to(info.iccProfile);
    json.at("recipe").get_to(info.recipe);
    json.at("name").get_to(info.name);
    json.at("channelNames").get_to(info.channelNames);
    json.at("associatedAlpha").get_to(info.associatedAlpha);
    json.at("compression").get_to(info.compression);
    json.at("layer").get_to(info.layer);
    json.at("layers").get_to(info.layers);
    info.notes = messagesFrom(json.at("notes"));
    json.at("texts").get_to(info.texts);
    header.stored = sizeAt("stored");
    json.at("orientation").get_to(header.orientation);
    json.at("steps").get_to(header.steps);
    json.at("samples").get_to(header.samples);
    return header;
}

} // namespace texloom
