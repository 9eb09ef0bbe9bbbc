#include "core/io/edit_json.h"

namespace texloom {

using Json = JsonField::Json;

namespace {

constexpr std::size_t kMostEdits = 256;
constexpr std::size_t kMostNumbers = 256; ///< in one list

PlanePoints pointsFrom(const JsonField& field) {
    PlanePoints points;
    for (std::size_t i = 0; i < field.size(); ++i) {
        const JsonField point = field.at(i);
        point.needArray(2, 2);
        points.push_back({point.at(std::size_t{0}).number(), point.at(std::size_t{1}).number()});
    }
    return points;
}

/// A list of whole numbers, or of points, or what a method's parameter may be.
Value settingFrom(const JsonField& field) {
    if (!field.json().is_array())
        return field.value();
    field.needArray(1, kMostNumbers);
    if (field.at(std::size_t{0}).json().is_array())
        return pointsFrom(field);
    Wholes wholes;
    for (std::size_t i = 0; i < field.size(); ++i)
        wholes.push_back(field.at(i).whole());
    return wholes;
}

ExemplarEdit editFrom(const JsonField& field) {
    field.needObject();
    ExemplarEdit edit;
    for (const auto& [name, value] : field.json().items())
        edit[name] = settingFrom(field.at(name));
    return edit;
}

} // namespace

Json toJson(const ExemplarEdits& edits) {
    Json json = Json::array();
    for (const ExemplarEdit& edit : edits)
        json.push_back(toJson(edit));
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
