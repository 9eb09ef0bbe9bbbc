#pragma once

#include "core/job/curve.h"

#include <nlohmann/json.hpp>

#include <vector>

namespace texloom {

/// Curves as [{"name": …, "values": […]}]. Values that are not finite become null.
nlohmann::ordered_json toJson(const std::vector<Curve>& curves);

/// The curves that toJson() wrote; null is read as not a number.
/// @throws nlohmann::json::exception where it is none.
std::vector<Curve> curvesFrom(const nlohmann::ordered_json& json);

/// A number as JSON holds it, where null stands for what is not finite. @throws nlohmann::json::exception
double numberFrom(const nlohmann::ordered_json& json);

} // namespace texloom
