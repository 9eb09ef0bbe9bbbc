#include "core/job/curve.h"

#include <algorithm>

namespace texloom {

void addTo(std::vector<Curve>& curves, const Message& name, double value) {
    const auto found = std::find_if(curves.begin(), curves.end(),
                                    [&name](const Curve& curve) { return curve.name == name; });
    if (found != curves.end())
        found->values.push_back(value);
    else
        curves.push_back({name, {value}});
}

} // namespace texloom
