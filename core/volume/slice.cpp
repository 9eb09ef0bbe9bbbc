#include "core/volume/slice.h"

#include "core/base/error.h"
#include "core/base/text.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace texloom {

namespace {

using Eigen::Vector3d;

/// Pixels on a side of the tiles that an oblique slice is made in. The box around a tile at 45° has about
/// half as many voxels as the tile's cube.
constexpr int kTile = 32;
/// Points this near to a voxel are on it.
constexpr double kRounding = 1e-6;
/// Rows of a slice along the axes that are asked for at once.
constexpr int kBand = 64;

void checkPlane(const Plane& plane, Size size) {
    if (size.empty())
        failUsage("A slice of {} × {} px has no pixels.", size.width, size.height);
    for (const Vector3d* step : {&plane.right, &plane.down})
        if (const double length = step->norm(); !(length > 0 && length <= Plane::kLongestStep))
            failUsage("A slice goes {} voxels from pixel to pixel; it must be more than 0 and up to {}.",
                      numberText(length), numberText(Plane::kLongestStep));
    for (const double x : {0, size.width - 1})
        for (const double y : {0, size.height - 1})
            if (const Vector3d corner = plane.at(x, y);
                !corner.allFinite() || corner.cwiseAbs().maxCoeff() > static_cast<double>(Box::kFarthest))
                failUsage("The slice lies too far out; coordinates go from −{} to {}.",
                          grouped(Box::kFarthest), grouped(Box::kFarthest));
}

/// Whether all pixels lie on voxels, one step along an axis from their neighbours.
bool alongAxes(const Plane& plane) {
    const auto unit = [](const Vector3d& step) {
        return step.cwiseAbs().sum() == 1 && step.cwiseAbs().maxCoeff() == 1;
    };
    return unit(plane.right) && unit(plane.down) && plane.right.dot(plane.down) == 0 &&
           plane.origin == plane.origin.array().round().matrix();
}

/// Turned planes meet whole coordinates only to within rounding, and the voxel behind would then take part.
Vector3d pointAt(const Plane& plane, double x, double y) {
    Vector3d point = plane.at(x, y);
    for (double& coordinate : point)
        if (const double whole = std::round(coordinate); std::abs(coordinate - whole) < kRounding)
            coordinate = whole;
    return point;
}

/// The smallest box with all voxels that have a part in these pixels, if points may be off by `rounding`.
Box boxAround(const Plane& plane, const Region& pixels, double rounding) {
    Vector3d least = plane.at(pixels.x, pixels.y), most = least;
    for (const int x : {pixels.x, pixels.right() - 1})
        for (const int y : {pixels.y, pixels.bottom() - 1}) {
            least = least.cwiseMin(plane.at(x, y));
            most = most.cwiseMax(plane.at(x, y));
        }
    const auto begin = [&](int axis) {
        return static_cast<std::int64_t>(std::floor(least[axis] - rounding));
    };
    const auto length = [&](int axis) {
        return static_cast<int>(static_cast<std::int64_t>(std::ceil(most[axis] + rounding)) - begin(axis)) +
               1;
    };
    return {begin(0), begin(1), begin(2), {length(0), length(1), length(2)}};
}

Box visiblePart(const VolumeSource& source, const Box& box) {
    const std::optional<Box> bounds = source.bounds();
    return bounds ? intersection(box, *bounds) : box;
}

/// The voxels of one box of a source, as far as they are within its bounds.
class Cell {
public:
    Cell(const VolumeSource& source, const Box& box, JobContext& context)
        : m_box(visiblePart(source, box)), m_volume(source.sample(m_box, context)) {}

    bool has(std::int64_t x, std::int64_t y, std::int64_t z) const {
        return x >= m_box.x && x < m_box.endX() && y >= m_box.y && y < m_box.endY() && z >= m_box.z &&
               z < m_box.endZ();
    }
    float at(std::int64_t x, std::int64_t y, std::int64_t z, int channel) const {
        return m_volume(static_cast<int>(x - m_box.x), static_cast<int>(y - m_box.y),
                        static_cast<int>(z - m_box.z), channel);
    }
    /// Gives a pixel the voxel at a point of whole coordinates. @return whether there is one.
    bool copy(const Vector3d& point, int x, int y, Image& image) const {
        const auto px = static_cast<std::int64_t>(point.x()), py = static_cast<std::int64_t>(point.y()),
                   pz = static_cast<std::int64_t>(point.z());
        if (!has(px, py, pz))
            return false;
        for (int c = 0; c < image.channels(); ++c)
            image(x, y, c) = at(px, py, pz, c);
        return true;
    }
    /// The same for the mean of the eight voxels around a point, weighted by their nearness.
    bool blend(const Vector3d& point, int x, int y, Image& image) const;

private:
    Box m_box;
    Volume m_volume;
};

bool Cell::blend(const Vector3d& point, int x, int y, Image& image) const {
    const Vector3d corner = point.array().floor();
    const Vector3d part = point - corner;
    const auto cx = static_cast<std::int64_t>(corner.x()), cy = static_cast<std::int64_t>(corner.y()),
               cz = static_cast<std::int64_t>(corner.z());
    // Voxels without a share need not be there: a point on the last voxel is within the bounds.
    std::array<double, 8> weights{};
    for (std::size_t i = 0; i < weights.size(); ++i) {
        const bool dx = (i & 1U) != 0, dy = (i & 2U) != 0, dz = (i & 4U) != 0;
        weights[i] =
            (dx ? part.x() : 1 - part.x()) * (dy ? part.y() : 1 - part.y()) * (dz ? part.z() : 1 - part.z());
        if (weights[i] > 0 && !has(cx + dx, cy + dy, cz + dz))
            return false;
    }
    for (int c = 0; c < image.channels(); ++c) {
        double sum = 0;
        for (std::size_t i = 0; i < weights.size(); ++i)
            if (weights[i] > 0)
                sum +=
                    weights[i] * static_cast<double>(at(cx + (i & 1U), cy + (i >> 1 & 1U), cz + (i >> 2), c));
        image(x, y, c) = static_cast<float>(sum);
    }
    return true;
}

/// Makes a part of a slice. @return whether any pixel of it is within the bounds.
bool fillPart(const VolumeSource& source, const Plane& plane, const Region& part, bool exact, Image& image,
              JobContext& context) {
    const Box box = boxAround(plane, part, exact ? 0 : kRounding);
    if (visiblePart(source, box).size.empty())
        return false;
    const Cell cell(source, box, context);
    bool met = false;
    for (int y = part.y; y < part.bottom(); ++y)
        for (int x = part.x; x < part.right(); ++x) {
            const Vector3d point = pointAt(plane, x, y);
            const bool there = exact ? cell.copy(point, x, y, image) : cell.blend(point, x, y, image);
            met = met || there;
        }
    return met;
}

} // namespace

Plane axisPlane(Axis axis, const Vector3d& origin) {
    switch (axis) {
    case Axis::X:
        return {origin, Vector3d::UnitZ(), Vector3d::UnitY()};
    case Axis::Y:
        return {origin, Vector3d::UnitX(), Vector3d::UnitZ()};
    case Axis::Z:
        break;
    }
    return {origin, Vector3d::UnitX(), Vector3d::UnitY()};
}

Plane turned(const Plane& plane, const Vector3d& pivot, double turn, double tilt) {
    if (turn == 0 && tilt == 0)
        return plane;
    const Eigen::Matrix3d rotation =
        (Eigen::AngleAxisd(turn, plane.down.normalized()) * Eigen::AngleAxisd(tilt, plane.right.normalized()))
            .toRotationMatrix();
    return {pivot + rotation * (plane.origin - pivot), rotation * plane.right, rotation * plane.down};
}

std::optional<Image> sliceWithin(const VolumeSource& source, const Plane& plane, Size size,
                                 JobContext& context) {
    checkPlane(plane, size);
    Image image(size, source.channels());
    const bool exact = alongAxes(plane);
    const Size tile = exact ? Size{size.width, kBand} : Size{kTile, kTile};
    bool met = false;
    for (int y = 0; y < size.height; y += tile.height)
        for (int x = 0; x < size.width; x += tile.width) {
            context.check();
            const Size extent{std::min(tile.width, size.width - x), std::min(tile.height, size.height - y)};
            met = fillPart(source, plane, {x, y, extent}, exact, image, context) || met;
        }
    return met ? std::optional(std::move(image)) : std::nullopt;
}

Image slice(const VolumeSource& source, const Plane& plane, Size size, JobContext& context) {
    std::optional<Image> made = sliceWithin(source, plane, size, context);
    if (!made)
        failUsage("The slice lies beside the volume, which has {}.", boxText(*source.bounds()));
    return std::move(*made);
}

} // namespace texloom
