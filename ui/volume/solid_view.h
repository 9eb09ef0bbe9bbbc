#pragma once

#include "core/render/solid.h"
#include "ui/scene/orbit_view.h"

#include <memory>

namespace texloom::ui {

/// A solid on a surface, each point of which has the colour of its voxel. Beside what OrbitView does, Ctrl
/// and dragging, or Ctrl and the arrow keys, move in the plane of the screen what can be moved: a cut, or the
/// texture on a mesh; with Ctrl and Page Up or Page Down, or the wheel, away from the viewer and nearer. C
/// shows the colours alone, without light.
class SolidView : public OrbitView {
    Q_OBJECT

public:
    explicit SolidView(QWidget* parent = nullptr);

    /// All of them are needed to draw.
    void setSolid(std::shared_ptr<const BlockCache> solid);
    void setLight(std::shared_ptr<const Environment> light);
    /// @param placement from coordinates of the mesh to voxels.
    void setMesh(std::shared_ptr<const RenderMesh> mesh, const SolidPlacement& placement);
    const std::shared_ptr<const RenderMesh>& mesh() const { return m_mesh; }
    const SolidPlacement& placement() const { return m_placement; }

Q_SIGNALS:
    /// What can be moved is to be moved so far, in voxels of the solid.
    void moveWanted(const Eigen::Vector3d& voxels);
    /// It is to have all the room, or not any more.
    void enlargeWanted();

protected:
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    Drawing drawing() const override;
    QString placeholder() const override;
    /// Along the screen to the right, down, and away from the viewer; in points of the widget.
    void move(double right, double down, double away);

    std::shared_ptr<const BlockCache> m_solid;
    std::shared_ptr<const Environment> m_light;
    std::shared_ptr<const RenderMesh> m_mesh;
    SolidPlacement m_placement;
};

} // namespace texloom::ui
