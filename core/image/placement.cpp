#include "core/image/placement.h"

#include <Eigen/LU>

#include <cmath>

namespace texloom {

namespace {

PlanePoint applied(const Eigen::Matrix3d& map, PlanePoint point) {
    const Eigen::Vector3d at = map * Eigen::Vector3d(point.x, point.y, 1);
    return {at.x() / at.z(), at.y() / at.z()};
}

} // namespace

PlanePoint Placement::toSource(PlanePoint point) const {
    return applied(m_toSource, point);
}

PlanePoint Placement::fromSource(PlanePoint point) const {
    return applied(m_toSource.inverse(), point);
}

Eigen::Matrix2d Placement::jacobian(PlanePoint point) const {
    const Eigen::Vector3d at = m_toSource * Eigen::Vector3d(point.x, point.y, 1);
    Eigen::Matrix2d derivative;
    for (int column = 0; column < 2; ++column)
        for (int row = 0; row < 2; ++row)
            derivative(row, column) =
                (m_toSource(row, column) * at.z() - at[row] * m_toSource(2, column)) / (at.z() * at.z());
    return derivative;
}

bool Placement::exact() const {
    const auto whole = [](double value) { return value == std::round(value); };
    const Eigen::Matrix2d turn = m_toSource.topLeftCorner<2, 2>();
    const PlanePoint first = toSource({0.5, 0.5});
    return m_toSource(2, 0) == 0 && m_toSource(2, 1) == 0 && m_toSource(2, 2) == 1 &&
           turn.cwiseAbs().colwise().sum() == Eigen::RowVector2d::Ones() &&
           turn.array().unaryExpr(whole).all() && whole(first.x - 0.5) && whole(first.y - 0.5);
}

Eigen::Matrix3d shifted(double x, double y) {
    Eigen::Matrix3d map = Eigen::Matrix3d::Identity();
    map(0, 2) = x;
    map(1, 2) = y;
    return map;
}

} // namespace texloom
