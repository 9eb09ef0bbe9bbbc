#pragma once

#include "core/tools/tool.h"

#include <string>

namespace texloom {

/// Adds a tool from outside core/tools/, as the tests' own are. A static object of this kind does it beside
/// the tool's declaration: tools() is first asked for later.
class ToolRegistration {
public:
    ToolRegistration(const std::string& id, const Tool& tool);
};

} // namespace texloom
