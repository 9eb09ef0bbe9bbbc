#include "ui/material/material_view.h"

#include "core/color/color_pipeline.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace texloom::ui {

namespace {

constexpr int kQuickSide = 512;      ///< longest side of a picture that is drawn while something moves
constexpr int kMostPixels = 3 << 20; ///< of one that is drawn with several samples a pixel
constexpr int kRest = 120;           ///< ms
constexpr double kTurn = 0.01;       ///< radians for each pixel that is dragged
constexpr double kKeyTurn = 0.1;     ///< radians for each press of a key
constexpr double kKeyZoom = 0.85;
constexpr float kMostRise = 1.5F;
const QList<Qt::Key> kKeys = {Qt::Key_Left, Qt::Key_Right, Qt::Key_Up,    Qt::Key_Down,
                              Qt::Key_Plus, Qt::Key_Equal, Qt::Key_Minus, Qt::Key_F,
                              Qt::Key_R,    Qt::Key_C,     Qt::Key_M};

} // namespace

QImage shownOnScreen(const Image& rendered) {
    Image colour(rendered.view().channelRange(0, 3));
    color::toWorking(colour, "linear");
    color::toDisplay(colour);
    QImage shown(rendered.width(), rendered.height(), QImage::Format_ARGB32_Premultiplied);
    const auto byteOf = [](float value) {
        const float rounded = std::clamp(value, 0.0F, 1.0F) * 255 + 0.5F;
        return static_cast<int>(rounded);
    };
    for (int y = 0; y < rendered.height(); ++y) {
        auto* row = reinterpret_cast<QRgb*>(shown.scanLine(y));
        for (int x = 0; x < rendered.width(); ++x)
            row[x] = qPremultiply(qRgba(byteOf(colour(x, y, 0)), byteOf(colour(x, y, 1)),
                                        byteOf(colour(x, y, 2)), byteOf(rendered(x, y, 3))));
    }
    return shown;
}

MaterialView::MaterialView(QWidget* parent) : QWidget(parent) {
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Material"));
    setMouseTracking(false);
    m_rest.setSingleShot(true);
    m_rest.setInterval(kRest);
    connect(&m_rest, &QTimer::timeout, this, [this] { draw(true); });
}

MaterialView::~MaterialView() = default;

QSize MaterialView::sizeHint() const {
    return {640, 480};
}

QSize MaterialView::minimumSizeHint() const {
    return {160, 120};
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

void MaterialView::setLook(const Look& look) {
    m_look = look;
    drawSoon();
}

/// Draws at once what can be drawn at once, and in full when nothing has changed for a while.
void MaterialView::drawSoon() {
    m_full = false;
    m_rest.start();
    if (m_task.running())
        m_stale = true;
    else
        draw(false);
}

void MaterialView::draw(bool full) {
    if (!m_material || !m_mesh || !m_light || !isVisible()) {
        m_task.cancel();
        m_picture = {};
        update();
        return;
    }
    m_stale = false;
    m_full = full;
    const double longer = std::max(width(), height()) * devicePixelRatioF();
    const double scale = devicePixelRatioF() * (full ? 1 : std::min(1.0, kQuickSide / std::max(1.0, longer)));
    const Size size{std::max(1, static_cast<int>(width() * scale)),
                    std::max(1, static_cast<int>(height() * scale))};
    Look look = m_look;
    look.samples = full && size.area() <= kMostPixels ? 2 : 1;
    m_task.start(
        {},
        [material = m_material, mesh = m_mesh, light = m_light, look, size](JobContext& context) {
            return shownOnScreen(rendered(*mesh, *material, *light, look, size, context));
        },
        [this](QImage picture) {
            m_picture = std::move(picture);
            update();
            if (m_stale)
                draw(false);
            Q_EMIT drawn();
        },
        [this](const QString& sentence) { Q_EMIT failed(sentence); });
}

/// The keys of the view come before those of actions while it has the focus.
bool MaterialView::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) {
        const auto* const key = static_cast<QKeyEvent*>(event);
        const bool plain = !(key->modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier));
        if (plain && kKeys.contains(static_cast<Qt::Key>(key->key()))) {
            event->accept();
            return true;
        }
    }
    return QWidget::event(event);
}

void MaterialView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), palette().dark());
    if (m_picture.isNull()) {
        painter.setPen(palette().color(QPalette::BrightText));
        painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap,
                         m_material ? tr("Drawing…") : tr("No result yet. Press Run."));
    } else {
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        painter.drawImage(rect(), m_picture);
    }
    if (hasFocus()) {
        painter.setPen(palette().color(QPalette::Highlight));
        painter.drawRect(rect().adjusted(0, 0, -1, -1));
    }
}

void MaterialView::resizeEvent(QResizeEvent*) {
    drawSoon();
}

void MaterialView::showEvent(QShowEvent*) {
    drawSoon();
}

void MaterialView::changedByHand() {
    drawSoon();
    Q_EMIT lookChanged();
}

void MaterialView::turnBy(double right, double down) {
    m_look.camera.turn -= static_cast<float>(right);
    m_look.camera.rise = std::clamp(m_look.camera.rise + static_cast<float>(down), -kMostRise, kMostRise);
    changedByHand();
}

void MaterialView::turnLightBy(double right) {
    constexpr double kWhole = 2 * std::numbers::pi;
    m_look.lightTurn =
        static_cast<float>(std::remainder(static_cast<double>(m_look.lightTurn) + right, kWhole));
    changedByHand();
}

void MaterialView::moveBy(QPointF pixels) {
    const Eigen::Matrix3f axes = m_look.camera.axes();
    const float each = 2 * m_look.camera.distance * std::tan(m_look.camera.angle / 2) /
                       static_cast<float>(std::max(1, std::min(width(), height())));
    m_look.camera.target += each * (static_cast<float>(pixels.y()) * axes.row(1).transpose() -
                                    static_cast<float>(pixels.x()) * axes.row(0).transpose());
    changedByHand();
}

void MaterialView::comeNearer(double factor) {
    constexpr float kNearest = 0.3F, kFarthest = 50;
    m_look.camera.distance =
        std::clamp(m_look.camera.distance * static_cast<float>(factor), kNearest, kFarthest);
    changedByHand();
}

void MaterialView::nextMap() {
    constexpr int kShown = static_cast<int>(Shown::Opacity) + 1;
    m_look.shown = static_cast<Shown>((static_cast<int>(m_look.shown) + 1) % kShown);
    changedByHand();
}

void MaterialView::mousePressEvent(QMouseEvent* event) {
    m_dragPoint = event->position();
}

void MaterialView::mouseMoveEvent(QMouseEvent* event) {
    const QPointF moved = event->position() - m_dragPoint;
    m_dragPoint = event->position();
    if (event->buttons() & Qt::LeftButton)
        turnBy(kTurn * moved.x(), kTurn * moved.y());
    else if (event->buttons() & Qt::MiddleButton)
        moveBy(moved);
    else if (event->buttons() & Qt::RightButton && event->modifiers() & Qt::ShiftModifier)
        turnLightBy(kTurn * moved.x());
}

void MaterialView::wheelEvent(QWheelEvent* event) {
    constexpr double kNotch = 120;
    comeNearer(std::pow(kKeyZoom, event->angleDelta().y() / kNotch));
    event->accept();
}

/// @return whether the key was one that turns the view or the light.
bool MaterialView::arrowKey(const QKeyEvent& event) {
    const int right = event.key() == Qt::Key_Right ? 1 : event.key() == Qt::Key_Left ? -1 : 0;
    const int down = event.key() == Qt::Key_Down ? 1 : event.key() == Qt::Key_Up ? -1 : 0;
    if (right == 0 && down == 0)
        return false;
    if (event.modifiers() & Qt::ShiftModifier)
        turnLightBy(kKeyTurn * (right + down));
    else
        turnBy(kKeyTurn * right, kKeyTurn * down);
    return true;
}

void MaterialView::keyPressEvent(QKeyEvent* event) {
    if (arrowKey(*event))
        return;
    switch (event->key()) {
    case Qt::Key_Plus:
    case Qt::Key_Equal:
        return comeNearer(kKeyZoom);
    case Qt::Key_Minus:
        return comeNearer(1 / kKeyZoom);
    case Qt::Key_F:
        m_look.camera.target = Camera().target;
        m_look.camera.distance = Camera().distance;
        return changedByHand();
    case Qt::Key_R:
        m_look.camera = Camera();
        m_look.lightTurn = 0;
        return changedByHand();
    case Qt::Key_C:
        return nextMap();
    case Qt::Key_M:
        m_look.shown = Shown::Lit;
        return changedByHand();
    default:
        QWidget::keyPressEvent(event);
    }
}

} // namespace texloom::ui
