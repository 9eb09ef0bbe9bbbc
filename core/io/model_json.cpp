#include "core/io/model_json.h"

#include <nlohmann/json.hpp>

namespace texloom {

namespace {

using ModelJson = nlohmann::ordered_json;

/// The values from `at` on, nested by the axes from `axis` on.
template <class T>
ModelJson nested(const std::vector<T>& values, const ModelArray::Shape& shape, std::size_t axis,
                 std::size_t& at) {
    if (axis == shape.size())
        return values[at++];
    ModelJson list = ModelJson::array();
    for (std::int64_t i = 0; i < shape[axis]; ++i)
        list.push_back(nested(values, shape, axis + 1, at));
    return list;
}

} // namespace

std::string jsonOf(const Model& model) {
    ModelJson json = {{"kind", model.kind}, {"notes", model.notes}, {"arrays", ModelJson::object()}};
    for (const auto& [name, array] : model.arrays)
        json["arrays"][name] = std::visit(
            [&shape = array.shape](const auto& values) {
                std::size_t at = 0;
                return nested(values, shape, 0, at);
            },
            array.values);
    return json.dump(1) + "\n";
}

} // namespace texloom
