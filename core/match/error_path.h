#pragma once

#include <functional>
#include <vector>

namespace texloom {

/// The path of least error along a straight band (Efros & Freeman 2001): for each step along the band the
/// place across it where the new picture begins, which moves aside by 1 at most from one step to the next.
/// @param length of the band; @param width its places, at least 1.
/// @param errorsOf writes the squared differences of the pictures across the band at one step along it.
/// @param closes whether the band's end meets its beginning; the path then does, too: it is led through the
/// place that is best where the band is passed twice.
/// @param check called now and then; may throw.
std::vector<int> leastErrorPath(
    int length, int width, const std::function<void(int along, float* errors)>& errorsOf, bool closes,
    const std::function<void()>& check = [] {});

} // namespace texloom
