#pragma once

#include "core/image/size.h"
#include "core/job/job_context.h"
#include "core/render/camera.h"
#include "core/render/render_mesh.h"

#include <array>
#include <cstdint>
#include <vector>

namespace texloom {

/// Which triangle a pixel shows, and where in it.
struct Hit {
    static constexpr std::uint32_t kNone = 0xffffffffU;

    std::uint32_t triangle = kNone;
    float second = 0, third = 0; ///< shares of the second and third vertex

    bool any() const { return triangle != kNone; }
};

/// A triangle as the camera sees it, by homogeneous coordinates (Olano & Greer 1997), which need no clipping:
/// an edge's function is positive on the triangle's side of it, seen from either side.
class SeenTriangle {
public:
    /// @param corners right, down and away from the camera, scaled so that the first two over the third are
    /// pixels
    explicit SeenTriangle(const std::array<Eigen::Vector3d, 3>& corners);

    bool visible() const { return m_size != 0; }
    /// Whether it covers a point of the picture. On an edge that two triangles share it does for one of them.
    bool covers(double x, double y) const;
    /// Distance from the camera's plane; only where it covers.
    double depth(double x, double y) const { return m_size / sum(x, y); }
    /// Shares of the three corners in a point of the triangle's plane, in true perspective.
    std::array<double, 3> shares(double x, double y) const;

private:
    double sum(double x, double y) const;

    std::array<Eigen::Vector3d, 3> m_edges;
    double m_size = 0;
};

/// What a camera sees of a mesh.
class Visibility {
public:
    /// @param context cancels, and gives the threads: the result is the same for any number of them.
    Visibility(const RenderMesh& mesh, const Camera& camera, Size size, JobContext& context);

    Size size() const { return m_size; }
    const Hit& at(int x, int y) const {
        return m_hits[static_cast<std::size_t>(y) * static_cast<std::size_t>(m_size.width) +
                      static_cast<std::size_t>(x)];
    }
    /// The triangle of a hit, for places beside its pixel.
    SeenTriangle seen(std::uint32_t triangle) const;

private:
    void draw(int firstRow, int rows, const std::vector<std::uint32_t>& triangles);

    const RenderMesh& m_mesh;
    Size m_size;
    std::vector<Eigen::Vector3d> m_corners; ///< of the vertices, as SeenTriangle wants them
    std::vector<Hit> m_hits;
};

} // namespace texloom
