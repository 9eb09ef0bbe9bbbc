#pragma once

#include "core/session/run/run.h"

namespace texloom::ui {

/// The size of a preview of an output: its shape, small.
Size quickSize(Size size);

/// The same run as a preview: the whole output at a preview's size. An image to start from gives its top
/// left.
RunInput quickOf(RunInput input);

} // namespace texloom::ui
