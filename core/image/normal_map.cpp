#include "core/image/normal_map.h"

#include "core/image/resample.h"

#include <Eigen/LU>

#include <cmath>

namespace texloom {

namespace {

/// How vectors are stored.
struct Code {
    float scale, offset;

    explicit Code(const ImageView& normals) {
        const bool raw = valueRange(normals.channelRange(0, 3)).smallest < 0;
        scale = raw ? 1.0F : 0.5F;
        offset = raw ? 0.0F : 0.5F;
    }
    float read(float stored) const { return (stored - offset) / scale; }
    float write(float value) const { return value * scale + offset; }
};

/// The rotation, or rotation and reflection, nearest to a linear map.
Eigen::Matrix2d nearestTurn(const Eigen::Matrix2d& map) {
    Eigen::Matrix2d mirror = Eigen::Matrix2d::Identity();
    mirror(1, 1) = map.determinant() < 0 ? -1 : 1;
    const Eigen::Matrix2d straight = map * mirror;
    const double angle = std::atan2(straight(1, 0) - straight(0, 1), straight(0, 0) + straight(1, 1));
    Eigen::Matrix2d turn;
    turn << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
    return turn * mirror;
}

void turn(Image& normals, const Code& code, MapRole role,
          const std::function<Eigen::Matrix2d(int x, int y)>& jacobian, const std::function<void()>& check) {
    const float up = role == MapRole::NormalDx ? 1.0F : -1.0F; // the image's y points down
    for (int y = 0; y < normals.height(); ++y) {
        check();
        for (int x = 0; x < normals.width(); ++x) {
            const Eigen::Matrix2d map = nearestTurn(jacobian(x, y).inverse());
            const Eigen::Vector2d vector(code.read(normals(x, y, 0)), up * code.read(normals(x, y, 1)));
            const Eigen::Vector2d turned = map * vector;
            normals(x, y, 0) = code.write(static_cast<float>(turned.x()));
            normals(x, y, 1) = code.write(up * static_cast<float>(turned.y()));
        }
    }
}

void normalise(Image& normals, const Code& code) {
    for (int y = 0; y < normals.height(); ++y)
        for (int x = 0; x < normals.width(); ++x) {
            Eigen::Vector3f vector(code.read(normals(x, y, 0)), code.read(normals(x, y, 1)),
                                   code.read(normals(x, y, 2)));
            const float length = vector.norm();
            vector = length > 0 ? Eigen::Vector3f(vector / length) : Eigen::Vector3f(0, 0, 1);
            for (int c = 0; c < 3; ++c)
                normals(x, y, c) = code.write(vector[c]);
        }
}

} // namespace

Image placedNormals(const ImageView& normals, MapRole role, const Warp& warp,
                    const std::function<void()>& check) {
    Image placed = resampled(normals, warp, check);
    turn(
        placed, Code(normals), role,
        [&](int x, int y) {
            return warp.jacobian({x + 0.5, y + 0.5});
        },
        check);
    if (!warp.exact())
        renormalize(placed);
    return placed;
}

void turnNormals(Image& normals, const ImageView& stored, MapRole role,
                 const std::function<Eigen::Matrix2d(int x, int y)>& jacobian,
                 const std::function<void()>& check) {
    if (normals.channels() < 3)
        return;
    const Code code(stored);
    turn(normals, code, role, jacobian, check);
    normalise(normals, code);
}

void renormalize(Image& normals) {
    if (normals.channels() < 3)
        return;
    normalise(normals, Code(normals));
}

void flipGreen(Image& normals) {
    if (normals.channels() < 3)
        return;
    const Code code(normals);
    for (int y = 0; y < normals.height(); ++y)
        for (int x = 0; x < normals.width(); ++x)
            normals(x, y, 1) = code.write(-code.read(normals(x, y, 1)));
}

} // namespace texloom
