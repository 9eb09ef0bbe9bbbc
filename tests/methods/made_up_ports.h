#pragma once

#include "core/methods/method.h"

namespace texloom::test {

/// Something made up for every port that the method cannot do without: pictures that tile, as inputs of
/// outputs that wrap must; models as another method makes them of the same exemplar. Of a method that learns
/// from no exemplar, those of the request serve for that alone, and are taken away.
void fillPorts(const MethodInfo& info, Request& request);

} // namespace texloom::test
