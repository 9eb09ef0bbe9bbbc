#include "ui/material/material_view.h"

#include <QKeyEvent>

#include <utility>

namespace texloom::ui {

MaterialView::MaterialView(QWidget* parent) : OrbitView(parent) {
    setAccessibleName(tr("Material"));
    addKeys({Qt::Key_C, Qt::Key_M});
}

void MaterialView::setMaterial(std::shared_ptr<const MaterialTexture> material) {
    m_material = std::move(material);
    drawSoon();
}

void MaterialView::setMesh(std::shared_ptr<const RenderMesh> mesh) {
    m_mesh = std::move(mesh);
    drawSoon();
}

void MaterialView::setLight(std::shared_ptr<const Environment> light) {
    m_light = std::move(light);
    drawSoon();
}

OrbitView::Drawing MaterialView::drawing() const {
    if (!m_material || !m_mesh || !m_light)
        return nullptr;
    return [material = m_material, mesh = m_mesh, light = m_light](const Look& look, Size size, bool,
                                                                   JobContext& context) {
        return Drawn{shownOnScreen(rendered(*mesh, *material, *light, look, size, context))};
    };
}

QString MaterialView::placeholder() const {
    return m_material ? tr("Drawing…") : tr("No result yet. Press Run.");
}

void MaterialView::keyPressEvent(QKeyEvent* event) {
    Look changed = look();
    if (event->key() == Qt::Key_C) {
        constexpr int kShown = static_cast<int>(Shown::Opacity) + 1;
        changed.shown = static_cast<Shown>((static_cast<int>(changed.shown) + 1) % kShown);
        return changeByHand(changed);
    }
    if (event->key() == Qt::Key_M) {
        changed.shown = Shown::Lit;
        return changeByHand(changed);
    }
    OrbitView::keyPressEvent(event);
}

} // namespace texloom::ui
