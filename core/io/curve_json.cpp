#include "core/io/curve_json.h"

#include "core/io/message_json.h"

#include <limits>

namespace texloom {

using Json = nlohmann::ordered_json;

Json toJson(const std::vector<Curve>& curves) {
    Json json = Json::array();
    for (const Curve& curve : curves)
        json.push_back({{"name", toJson(curve.name)}, {"values", curve.values}});
    return json;
}

std::vector<Curve> curvesFrom(const Json& json) {
    std::vector<Curve> curves;
    for (const Json& curve : json) {
        Curve& read = curves.emplace_back();
        read.name = messageFrom(curve.at("name"));
        for (const Json& value : curve.at("values"))
            read.values.push_back(numberFrom(value));
    }
    return curves;
}

double numberFrom(const Json& json) {
    return json.is_null() ? std::numeric_limits<double>::quiet_NaN() : json.get<double>();
}

} // namespace texloom
