#include "ui/volume/solid_view.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include <chrono>
#include <utility>

namespace texloom::ui {

namespace {

/// Blocks that are not there after this time are drawn grey, and in the next drawing as they are.
constexpr std::chrono::milliseconds kQuickly{60}, kInFull{400};
constexpr double kKeyMove = 6; ///< points for each press of a key or notch of the wheel

} // namespace

SolidView::SolidView(QWidget* parent) : OrbitView(parent) {
    addKeys({Qt::Key_C, Qt::Key_Return, Qt::Key_Enter});
}

void SolidView::setSolid(std::shared_ptr<const BlockCache> solid) {
    m_solid = std::move(solid);
    drawSoon();
}

void SolidView::setLight(std::shared_ptr<const Environment> light) {
    m_light = std::move(light);
    drawSoon();
}

void SolidView::setMesh(std::shared_ptr<const RenderMesh> mesh, const SolidPlacement& placement) {
    m_mesh = std::move(mesh);
    m_placement = placement;
    drawSoon();
}

OrbitView::Drawing SolidView::drawing() const {
    if (!m_solid || !m_light || !m_mesh)
        return nullptr;
    return [solid = m_solid, light = m_light, mesh = m_mesh,
            placement = m_placement](const Look& look, Size size, bool quickly, JobContext& context) {
        const SolidPicture made =
            rendered(*mesh, *solid, placement, *light, look, size, quickly ? kQuickly : kInFull, context);
        return Drawn{shownOnScreen(made.image), made.whole};
    };
}

QString SolidView::placeholder() const {
    return m_solid ? tr("Drawing…") : tr("There is no volume to look at.");
}

void SolidView::move(double right, double down, double away) {
    const Eigen::Matrix3d axes = look().camera.axes().cast<double>();
    const Eigen::Vector3d inSpace =
        static_cast<double>(pointLength()) * (axes.transpose() * Eigen::Vector3d(right, -down, -away));
    Q_EMIT moveWanted(m_placement.scale * (m_placement.rotation() * inSpace));
}

void SolidView::mouseMoveEvent(QMouseEvent* event) {
    if (!(event->modifiers() & Qt::ControlModifier) || !(event->buttons() & Qt::LeftButton))
        return OrbitView::mouseMoveEvent(event);
    const QPointF by = dragged(*event);
    move(by.x(), by.y(), 0);
}

void SolidView::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton)
        Q_EMIT enlargeWanted();
}

void SolidView::wheelEvent(QWheelEvent* event) {
    if (!(event->modifiers() & Qt::ControlModifier))
        return OrbitView::wheelEvent(event);
    constexpr double kNotch = 120;
    move(0, 0, kKeyMove * event->angleDelta().y() / kNotch);
    event->accept();
}

void SolidView::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
        Q_EMIT enlargeWanted();
        return;
    }
    if (event->key() == Qt::Key_C) {
        Look changed = look();
        changed.shown = changed.shown == Shown::Lit ? Shown::Color : Shown::Lit;
        return changeByHand(changed);
    }
    if (event->modifiers() & Qt::ControlModifier)
        switch (event->key()) {
        case Qt::Key_Left:
            return move(-kKeyMove, 0, 0);
        case Qt::Key_Right:
            return move(kKeyMove, 0, 0);
        case Qt::Key_Up:
            return move(0, -kKeyMove, 0);
        case Qt::Key_Down:
            return move(0, kKeyMove, 0);
        case Qt::Key_PageUp:
            return move(0, 0, kKeyMove);
        case Qt::Key_PageDown:
            return move(0, 0, -kKeyMove);
        default:
            break;
        }
    OrbitView::keyPressEvent(event);
}

} // namespace texloom::ui
