#include "core/methods/anamorphosis/picture.h"

#include <algorithm>
#include <cmath>

namespace texloom::anamorphosis {

namespace {

constexpr float kWhite = 1, kGrey = 0.6F, kBlack = 0;

/// Draws over what is there, as much as a line of this half width covers a pixel at this distance.
void draw(float& pixel, double distance, double halfWidth, float value) {
    const double cover = std::clamp(halfWidth + 0.5 - distance, 0.0, 1.0);
    pixel += static_cast<float>(cover) * (value - pixel);
}

/// The map from the bottom left to the top right.
float curveAt(const Anamorphosis& warp, double length, int x, int y) {
    const double side = kPictureSide, across = (x + 0.5) / side * length;
    const auto heightAt = [&](double at) { return warp.along(at) / length * side; };
    const double up = side - (y + 0.5), here = heightAt(across);
    const double slope = (heightAt(across + length / side) - here);
    float value = kWhite;
    draw(value, std::abs(up - (x + 0.5)) / std::sqrt(2), 0.5, kGrey);
    draw(value, std::abs(up - here) / std::hypot(1, slope), 1, kBlack);
    return value;
}

/// The edges of squares, sixteen along the plane's longer side.
float gridAt(const Anamorphosis& warp, Size plane, double step, int x, int y) {
    const PlanePoint at{(x + 0.5) * step, (y + 0.5) * step};
    const PlanePoint from = warp.toSource(at);
    const Eigen::Matrix2d derivative = warp.jacobian(at);
    const double square = plane.longerSide() / 16.0;
    const auto distance = [&](double place, int axis) {
        const double off = std::abs(place - square * std::round(place / square));
        return off / (derivative.row(axis).norm() * step);
    };
    float value = kWhite;
    draw(value, std::min(distance(from.x, 0), distance(from.y, 1)), 0.5, kBlack);
    return value;
}

} // namespace

Image pictureOf(const Anamorphosis& warp, Size plane, int channels) {
    const bool grid = warp.turbulent();
    const double step = std::max(1.0, static_cast<double>(plane.longerSide()) / kPictureSide);
    Size size{kPictureSide, kPictureSide};
    if (grid)
        size = {std::max(1, static_cast<int>(plane.width / step)),
                std::max(1, static_cast<int>(plane.height / step))};
    Image picture(size, channels);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const float value = grid ? gridAt(warp, plane, step, x, y)
                                     : curveAt(warp, warp.alongY() ? plane.height : plane.width, x, y);
            for (int c = 0; c < channels; ++c)
                picture(x, y, c) = value;
        }
    return picture;
}

} // namespace texloom::anamorphosis
