#include "core/color/file_color.h"

#include <Eigen/Dense>

#include <cmath>

namespace texloom {

namespace {

using Matrix3 = Eigen::Matrix3d;
using Rows = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

constexpr double kNear = 2e-3;

Eigen::Vector3d xyzOf(double x, double y) {
    return {x / y, 1, (1 - x - y) / y};
}

const Eigen::Vector3d& whiteD50() {
    static const Eigen::Vector3d white(0.9642, 1, 0.8249);
    return white;
}

/// Light by primaries to XYZ relative to their own white.
Matrix3 toXyz(const Chromaticities& p) {
    Matrix3 primaries;
    primaries << xyzOf(p[0], p[1]), xyzOf(p[2], p[3]), xyzOf(p[4], p[5]);
    const Eigen::Vector3d amounts = primaries.inverse() * xyzOf(p[6], p[7]);
    return primaries * amounts.asDiagonal();
}

/// Bradford's adaptation from one white to another.
Matrix3 adaptation(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    Matrix3 cones;
    cones << 0.8951, 0.2664, -0.1614, -0.7502, 1.7135, 0.0367, 0.0389, -0.0685, 1.0296;
    const Eigen::Vector3d ratio = (cones * to).cwiseQuotient(cones * from);
    return cones.inverse() * ratio.asDiagonal() * cones;
}

FileColor::Matrix rows(const Matrix3& matrix) {
    FileColor::Matrix result{};
    Eigen::Map<Rows>(result.data()) = matrix;
    for (const double entry : result)
        if (!std::isfinite(entry))
            return FileColor().toRec709;
    return result;
}

bool isNear(const FileColor::Matrix& a, const FileColor::Matrix& b) {
    for (std::size_t i = 0; i < a.size(); ++i)
        if (std::abs(a[i] - b[i]) > kNear)
            return false;
    return true;
}

double srgbLight(double value) {
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

bool isSrgbCurve(const FileColor& color) {
    if (color.curve != FileColor::Curve::Table)
        return color.curve == FileColor::Curve::Srgb;
    const auto last = static_cast<double>(color.table.size() - 1);
    for (std::size_t i = 0; i < color.table.size(); ++i)
        if (std::abs(static_cast<double>(color.table[i]) - srgbLight(static_cast<double>(i) / last)) > kNear)
            return false;
    return true;
}

} // namespace

FileColor::Matrix toRec709(const Chromaticities& primaries) {
    const Matrix3 adapted =
        adaptation(xyzOf(primaries[6], primaries[7]), xyzOf(kRec709[6], kRec709[7])) * toXyz(primaries);
    return rows(toXyz(kRec709).inverse() * adapted);
}

FileColor::Matrix toRec709FromD50(const FileColor::Matrix& colorants) {
    const Matrix3 rec709 = adaptation(xyzOf(kRec709[6], kRec709[7]), whiteD50()) * toXyz(kRec709);
    return rows(rec709.inverse() * Matrix3(Eigen::Map<const Rows>(colorants.data())));
}

std::string FileColor::space() const {
    constexpr Chromaticities kAcesCg = {0.713, 0.293, 0.165, 0.830, 0.128, 0.044, 0.32168, 0.33767};
    if (isNear(toRec709, Matrix{1, 0, 0, 0, 1, 0, 0, 0, 1})) {
        if (isSrgbCurve(*this))
            return "srgb";
        return curve == Curve::Linear ? "linear" : "";
    }
    return curve == Curve::Linear && isNear(toRec709, texloom::toRec709(kAcesCg)) ? "acescg" : "";
}

} // namespace texloom
