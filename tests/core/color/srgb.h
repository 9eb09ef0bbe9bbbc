#pragma once

#include <cmath>

namespace texloom::test {

/// Linear light as sRGB encodes it (IEC 61966-2-1).
inline double encoded(double light) {
    return light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
}

} // namespace texloom::test
