#include "core/volume/mesh.h"

namespace texloom {

Mesh::Bounds Mesh::bounds() const {
    if (positions.empty())
        return {};
    Bounds bounds{positions.front(), positions.front()};
    for (const Eigen::Vector3f& position : positions) {
        bounds.lowest = bounds.lowest.cwiseMin(position);
        bounds.highest = bounds.highest.cwiseMax(position);
    }
    return bounds;
}

} // namespace texloom
