#include "core/io/edit_json.h"

namespace texloom {

using Json = JsonField::Json;

namespace {

constexpr std::size_t kMostEdits = 256;

int wholeAt(const JsonField& field, std::size_t index) {
    return field.at(index).whole();
}

struct ToJson {
    Json operator()(const CropEdit& edit) const {
        return {{"crop", {edit.area.x, edit.area.y, edit.area.size.width, edit.area.size.height}}};
    }
    Json operator()(const RotateEdit& edit) const { return {{"rotate", edit.degrees}}; }
    Json operator()(const FlipEdit& edit) const {
        return {{"flip", edit.axis == FlipEdit::Axis::Horizontal ? "horizontal" : "vertical"}};
    }
    Json operator()(const RectifyEdit& edit) const {
        Json json = {{"rectify", Json::array()}};
        for (const PlanePoint& corner : edit.corners)
            json["rectify"].push_back(Json::array({corner.x, corner.y}));
        if (!edit.size.empty())
            json["size"] = {edit.size.width, edit.size.height};
        return json;
    }
    Json operator()(const FlattenEdit& edit) const {
        const bool smooth = edit.model == FlattenEdit::Model::Smooth;
        Json json = {{"flatten", smooth ? "smooth" : "polynomial"}};
        if (smooth)
            json["width"] = edit.width;
        else
            json["order"] = edit.order;
        json["strength"] = edit.strength;
        return json;
    }
};

CropEdit cropFrom(const JsonField& field) {
    const JsonField area = field.at("crop");
    area.needArray(4, 4);
    return {{wholeAt(area, 0), wholeAt(area, 1), {wholeAt(area, 2), wholeAt(area, 3)}}};
}

FlipEdit flipFrom(const JsonField& field) {
    const std::string axis = field.at("flip").text();
    if (axis != "horizontal" && axis != "vertical")
        field.at("flip").wrong(TR(R"("horizontal" or "vertical")"));
    return {axis == "horizontal" ? FlipEdit::Axis::Horizontal : FlipEdit::Axis::Vertical};
}

RectifyEdit rectifyFrom(const JsonField& field) {
    RectifyEdit edit;
    const JsonField corners = field.at("rectify");
    corners.needArray(4, 4);
    for (std::size_t i = 0; i < 4; ++i) {
        corners.at(i).needArray(2, 2);
        edit.corners[i] = {corners.at(i).at(std::size_t{0}).number(),
                           corners.at(i).at(std::size_t{1}).number()};
    }
    if (field.has("size")) {
        const JsonField size = field.at("size");
        size.needArray(2, 2);
        edit.size = {wholeAt(size, 0), wholeAt(size, 1)};
    }
    return edit;
}

FlattenEdit flattenFrom(const JsonField& field) {
    FlattenEdit edit;
    const std::string model = field.at("flatten").text();
    if (model != "smooth" && model != "polynomial")
        field.at("flatten").wrong(TR(R"("smooth" or "polynomial")"));
    edit.model = model == "smooth" ? FlattenEdit::Model::Smooth : FlattenEdit::Model::Polynomial;
    if (field.has("width"))
        edit.width = field.at("width").number();
    if (field.has("order"))
        edit.order = field.at("order").whole();
    if (field.has("strength"))
        edit.strength = field.at("strength").number();
    return edit;
}

ExemplarEdit editFrom(const JsonField& field) {
    field.needObject();
    if (field.has("crop")) {
        field.only({"crop"});
        return cropFrom(field);
    }
    if (field.has("rotate")) {
        field.only({"rotate"});
        return RotateEdit{field.at("rotate").number()};
    }
    if (field.has("flip")) {
        field.only({"flip"});
        return flipFrom(field);
    }
    if (field.has("rectify")) {
        field.only({"rectify", "size"});
        return rectifyFrom(field);
    }
    if (!field.has("flatten"))
        field.wrong(TR("one of crop, rotate, flip, rectify and flatten"));
    field.only({"flatten", "width", "order", "strength"});
    return flattenFrom(field);
}

} // namespace

Json toJson(const ExemplarEdits& edits) {
    Json json = Json::array();
    for (const ExemplarEdit& edit : edits)
        json.push_back(std::visit(ToJson{}, edit));
    return json;
}

ExemplarEdits editsFrom(const JsonField& field) {
    field.needArray(0, kMostEdits);
    ExemplarEdits edits;
    for (std::size_t i = 0; i < field.size(); ++i)
        edits.push_back(editFrom(field.at(i)));
    return edits;
}

} // namespace texloom
