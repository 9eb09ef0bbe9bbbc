#pragma once

#include "core/base/message.h"
#include "core/image/image.h"

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace texloom {

/// The colours of a file whose tags (a profile, a gamma, chromaticities) say that they are in none of the
/// named spaces: a curve that gives light, and a matrix that takes it to linear Rec.709.
struct FileColor {
    enum class Curve {
        Linear,
        Srgb,
        Power, ///< light = value ^ power
        Table  ///< light at equal steps of the value from 0 to 1, with straight lines between
    };
    using Matrix = std::array<double, 9>; ///< by rows

    Curve curve = Curve::Linear;
    double power = 1;
    std::vector<float> table = {};
    Matrix toRec709 = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    Message name; ///< "the profile Display P3", "gamma 1.8": what sentences call it

    /// The id of the named space that this is, as near as makes no difference (2 in 1,000); empty if it is
    /// none.
    std::string space() const;
};

/// xy of red, green, blue and white.
using Chromaticities = std::array<double, 8>;
inline constexpr Chromaticities kRec709 = {0.64, 0.33, 0.30, 0.60, 0.15, 0.06, 0.3127, 0.3290};

/// Light by these primaries as linear Rec.709, the white adapted by Bradford's method.
/// @return the identity where they span no colours.
FileColor::Matrix toRec709(const Chromaticities& primaries);

/// The same from the XYZ of red, green and blue relative to D50 white, as ICC profiles have them, by columns.
FileColor::Matrix toRec709FromD50(const FileColor::Matrix& colorants);

namespace color {

/// Converts in place from a file's own colours to the working space.
/// @param check called every few rows; what it throws leaves the image half converted.
void toWorking(Image& image, const FileColor& from, const std::function<void()>& check = {});
/// Converts in place from the working space to a file's own colours.
void fromWorking(Image& image, const FileColor& to, const std::function<void()>& check = {});

} // namespace color
} // namespace texloom
