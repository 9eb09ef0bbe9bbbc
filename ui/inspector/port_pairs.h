#pragma once

#include "core/methods/port.h"

#include <optional>
#include <string_view>
#include <vector>

namespace texloom::ui {

/// Two ports whose pictures say what corresponds: A stands to the exemplar A′ as B does to the result B′.
struct AnalogyPorts {
    Port exemplars; ///< A: a picture of the exemplar's size
    Port output;    ///< B: a picture of the output's size
};

/// The first such pair among ports; none if there is none.
std::optional<AnalogyPorts> analogyAmong(const std::vector<Port>& ports);

/// The picture that a mask says something of: the one of the same extent that is declared nearest before it.
/// Null if there is none.
const Port* pictureBefore(const std::vector<Port>& ports, std::string_view mask);

} // namespace texloom::ui
