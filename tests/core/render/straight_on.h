#pragma once

#include "core/render/look.h"

namespace texloom::test {

/// From the front, before nothing.
inline Look straightOn() {
    Look look;
    look.camera.turn = look.camera.rise = 0;
    look.backdrop = Backdrop::Nothing;
    return look;
}

} // namespace texloom::test
