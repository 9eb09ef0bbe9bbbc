#include "core/image/warp.h"

#include <Eigen/LU>

#include <limits>

namespace texloom {

namespace {

/// The composition of two warps, at least one of them a field.
class Chain : public WarpField {
public:
    Chain(Warp first, Warp next) : m_first(std::move(first)), m_next(std::move(next)) {}

    PlanePoint toSource(PlanePoint point) const override { return m_first.toSource(m_next.toSource(point)); }
    Eigen::Matrix2d jacobian(PlanePoint point) const override {
        return m_first.jacobian(m_next.toSource(point)) * m_next.jacobian(point);
    }

private:
    Warp m_first, m_next;
};

Eigen::Vector2d vector(PlanePoint point) {
    return {point.x, point.y};
}

} // namespace

Eigen::Matrix2d WarpField::jacobian(PlanePoint point) const {
    Eigen::Matrix2d derivative;
    derivative.col(0) =
        vector(toSource({point.x + 0.5, point.y})) - vector(toSource({point.x - 0.5, point.y}));
    derivative.col(1) =
        vector(toSource({point.x, point.y + 0.5})) - vector(toSource({point.x, point.y - 0.5}));
    return derivative;
}

PlanePoint Warp::toSource(PlanePoint point) const {
    if (const auto* placement = std::get_if<Placement>(&m_map))
        return placement->toSource(point);
    return std::get<Field>(m_map)->toSource(point);
}

PlanePoint Warp::fromSource(PlanePoint point, PlanePoint near) const {
    if (const auto* placement = std::get_if<Placement>(&m_map))
        return placement->fromSource(point);
    constexpr int kMostSteps = 40;
    constexpr double kNear = 1e-3;
    Eigen::Vector2d at = vector(near);
    for (int step = 0; step < kMostSteps; ++step) {
        const Eigen::Vector2d away = vector(point) - vector(toSource({at.x(), at.y()}));
        if (away.norm() < kNear)
            return {at.x(), at.y()};
        const Eigen::Matrix2d derivative = jacobian({at.x(), at.y()});
        if (derivative.determinant() == 0)
            break;
        at += derivative.inverse() * away;
    }
    return {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
}

Eigen::Matrix2d Warp::jacobian(PlanePoint point) const {
    if (const auto* placement = std::get_if<Placement>(&m_map))
        return placement->jacobian(point);
    return std::get<Field>(m_map)->jacobian(point);
}

bool Warp::exact() const {
    const auto* placement = std::get_if<Placement>(&m_map);
    return placement != nullptr && placement->exact();
}

Warp Warp::after(const Warp& next) const {
    const auto* first = std::get_if<Placement>(&m_map);
    const auto* second = std::get_if<Placement>(&next.m_map);
    if (first != nullptr && second != nullptr)
        return first->after(*second);
    return {next.m_size, std::make_shared<const Chain>(*this, next)};
}

} // namespace texloom
