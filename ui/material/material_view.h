#pragma once

#include "ui/scene/orbit_view.h"

#include <memory>

namespace texloom::ui {

/// A material on a shape, lit from all around. Beside the keys of OrbitView, C goes through the maps alone
/// and M shows the material again.
class MaterialView : public OrbitView {
    Q_OBJECT

public:
    explicit MaterialView(QWidget* parent = nullptr);

    void setMaterial(std::shared_ptr<const MaterialTexture> material);
    const std::shared_ptr<const MaterialTexture>& material() const { return m_material; }
    void setMesh(std::shared_ptr<const RenderMesh> mesh);
    const std::shared_ptr<const RenderMesh>& mesh() const { return m_mesh; }
    void setLight(std::shared_ptr<const Environment> light);
    const std::shared_ptr<const Environment>& light() const { return m_light; }

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    Drawing drawing() const override;
    QString placeholder() const override;

    std::shared_ptr<const MaterialTexture> m_material;
    std::shared_ptr<const RenderMesh> m_mesh;
    std::shared_ptr<const Environment> m_light;
};

} // namespace texloom::ui
