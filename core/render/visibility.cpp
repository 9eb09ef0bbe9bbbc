#include "core/render/visibility.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace texloom {

namespace {

constexpr int kBand = 16; ///< rows that are drawn by one thread

/// The rows and columns that a triangle may touch.
struct Extent {
    int left, right, top, bottom; ///< right and bottom are beyond it
};

Extent extentOf(const std::array<Eigen::Vector3d, 3>& corners, Size size) {
    Extent extent{0, size.width, 0, size.height};
    if (std::any_of(corners.begin(), corners.end(),
                    [](const Eigen::Vector3d& corner) { return corner.z() < Camera::kNearest; }))
        return extent; // it goes on behind the camera
    double left = HUGE_VAL, right = -HUGE_VAL, top = HUGE_VAL, bottom = -HUGE_VAL;
    for (const Eigen::Vector3d& corner : corners) {
        left = std::min(left, corner.x() / corner.z());
        right = std::max(right, corner.x() / corner.z());
        top = std::min(top, corner.y() / corner.z());
        bottom = std::max(bottom, corner.y() / corner.z());
    }
    const auto within = [](double value, int most) {
        return static_cast<int>(std::clamp(value, 0.0, static_cast<double>(most)));
    };
    return {within(std::floor(left), size.width), within(std::ceil(right), size.width),
            within(std::floor(top), size.height), within(std::ceil(bottom), size.height)};
}

} // namespace

SeenTriangle::SeenTriangle(const std::array<Eigen::Vector3d, 3>& corners)
    : m_edges{corners[1].cross(corners[2]), corners[2].cross(corners[0]), corners[0].cross(corners[1])},
      m_size(corners[0].dot(m_edges[0])) {
    if (m_size < 0) {
        m_size = -m_size;
        for (Eigen::Vector3d& edge : m_edges)
            edge = -edge;
    }
}

bool SeenTriangle::covers(double x, double y) const {
    // Of the two triangles beside an edge one has the edge's function and the other exactly its negative.
    return std::all_of(m_edges.begin(), m_edges.end(), [&](const Eigen::Vector3d& edge) {
        const double side = edge.x() * x + edge.y() * y + edge.z();
        return side > 0 || (side == 0 && (edge.x() > 0 || (edge.x() == 0 && edge.y() > 0)));
    });
}

double SeenTriangle::sum(double x, double y) const {
    const Eigen::Vector3d edge = m_edges[0] + m_edges[1] + m_edges[2];
    return edge.x() * x + edge.y() * y + edge.z();
}

std::array<double, 3> SeenTriangle::shares(double x, double y) const {
    const double all = sum(x, y);
    std::array<double, 3> shares{};
    for (std::size_t i = 0; i < 3; ++i)
        shares[i] = (m_edges[i].x() * x + m_edges[i].y() * y + m_edges[i].z()) / all;
    return shares;
}

Visibility::Visibility(const RenderMesh& mesh, const Camera& camera, Size size, JobContext& context)
    : m_mesh(mesh), m_size(size), m_hits(static_cast<std::size_t>(size.area())) {
    const Eigen::Matrix3d axes = camera.axes().cast<double>();
    const Eigen::Vector3d eye = camera.position().cast<double>();
    const double scale =
        std::min(size.width, size.height) / 2.0 / std::tan(static_cast<double>(camera.angle) / 2);
    m_corners.reserve(mesh.mesh.positions.size());
    for (const Eigen::Vector3f& position : mesh.mesh.positions) {
        const Eigen::Vector3d place = axes * (position.cast<double>() - eye);
        const double depth = -place.z();
        m_corners.emplace_back(scale * place.x() + depth * size.width / 2,
                               depth * size.height / 2 - scale * place.y(), depth);
    }
    context.check();
    const int bands = (size.height + kBand - 1) / kBand;
    std::vector<std::vector<std::uint32_t>> touching(static_cast<std::size_t>(bands));
    for (std::size_t t = 0; t < mesh.mesh.triangles.size(); ++t) {
        if (t % 4096 == 0)
            context.check();
        const auto& [a, b, c] = mesh.mesh.triangles[t];
        const Extent extent = extentOf({m_corners[a], m_corners[b], m_corners[c]}, size);
        if (extent.left < extent.right && extent.top < extent.bottom)
            for (int band = extent.top / kBand; band <= (extent.bottom - 1) / kBand; ++band)
                touching[static_cast<std::size_t>(band)].push_back(static_cast<std::uint32_t>(t));
    }
    context.parallel(0, bands, [&](int band) {
        draw(band * kBand, std::min(kBand, size.height - band * kBand),
             touching[static_cast<std::size_t>(band)]);
    });
}

SeenTriangle Visibility::seen(std::uint32_t triangle) const {
    const auto& [a, b, c] = m_mesh.mesh.triangles[triangle];
    return SeenTriangle({m_corners[a], m_corners[b], m_corners[c]});
}

void Visibility::draw(int firstRow, int rows, const std::vector<std::uint32_t>& triangles) {
    std::vector<double> depths(static_cast<std::size_t>(rows) * static_cast<std::size_t>(m_size.width),
                               HUGE_VAL);
    for (const std::uint32_t t : triangles) {
        const auto& [a, b, c] = m_mesh.mesh.triangles[t];
        const std::array<Eigen::Vector3d, 3> corners{m_corners[a], m_corners[b], m_corners[c]};
        const SeenTriangle triangle(corners);
        if (!triangle.visible())
            continue;
        const Extent extent = extentOf(corners, m_size);
        for (int y = std::max(extent.top, firstRow); y < std::min(extent.bottom, firstRow + rows); ++y)
            for (int x = extent.left; x < extent.right; ++x) {
                if (!triangle.covers(x + 0.5, y + 0.5))
                    continue;
                double& nearest =
                    depths[static_cast<std::size_t>(y - firstRow) * static_cast<std::size_t>(m_size.width) +
                           static_cast<std::size_t>(x)];
                const double depth = triangle.depth(x + 0.5, y + 0.5);
                if (depth < Camera::kNearest || depth >= nearest)
                    continue;
                nearest = depth;
                const std::array<double, 3> shares = triangle.shares(x + 0.5, y + 0.5);
                m_hits[static_cast<std::size_t>(y) * static_cast<std::size_t>(m_size.width) +
                       static_cast<std::size_t>(x)] = {t, static_cast<float>(shares[1]),
                                                       static_cast<float>(shares[2])};
            }
    }
}

} // namespace texloom
