#include "ui/scene/orbit_view.h"

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

constexpr int kQuickSide = 512;            ///< longest side of a picture that is drawn while something moves
constexpr int kMostSampledTwice = 3 << 20; ///< of one that is drawn with several samples a pixel
constexpr int kRest = 120;                 ///< ms
constexpr double kTurn = 0.01;             ///< radians for each pixel that is dragged
constexpr double kKeyTurn = 0.1;           ///< radians for each press of a key
constexpr double kKeyZoom = 0.85;
constexpr float kMostRise = 1.5F;
const QList<Qt::Key> kKeys = {Qt::Key_Left,  Qt::Key_Right, Qt::Key_Up, Qt::Key_Down, Qt::Key_Plus,
                              Qt::Key_Equal, Qt::Key_Minus, Qt::Key_F,  Qt::Key_R};

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

OrbitView::OrbitView(QWidget* parent) : QWidget(parent), m_keys(kKeys) {
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(false);
    m_rest.setSingleShot(true);
    m_rest.setInterval(kRest);
    connect(&m_rest, &QTimer::timeout, this, [this] { draw(true); });
}

OrbitView::~OrbitView() = default;

QSize OrbitView::sizeHint() const {
    return {640, 480};
}

QSize OrbitView::minimumSizeHint() const {
    return {160, 120};
}

void OrbitView::setLook(const Look& look) {
    m_look = look;
    drawSoon();
}

/// Draws at once what can be drawn at once, and in full when nothing has changed for a while.
void OrbitView::drawSoon() {
    m_full = false;
    m_rest.start();
    if (m_task.running())
        m_stale = true;
    else
        draw(false);
}

void OrbitView::draw(bool full) {
    const Drawing drawing = isVisible() ? this->drawing() : nullptr;
    if (!drawing) {
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
    look.samples = full && size.area() <= kMostSampledTwice ? 2 : 1;
    m_task.start(
        {}, [drawing, look, size, full](JobContext& context) { return drawing(look, size, !full, context); },
        [this, full](Drawn made) {
            m_picture = std::move(made.picture);
            update();
            if (m_stale)
                draw(false);
            else if (!made.whole)
                draw(full);
            Q_EMIT drawn();
        },
        [this](const QString& sentence) { Q_EMIT failed(sentence); });
}

/// The keys of the view come before those of actions while it has the focus.
bool OrbitView::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) {
        const auto* const key = static_cast<QKeyEvent*>(event);
        const bool plain = !(key->modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier));
        if (plain && m_keys.contains(static_cast<Qt::Key>(key->key()))) {
            event->accept();
            return true;
        }
    }
    return QWidget::event(event);
}

void OrbitView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), palette().dark());
    if (m_picture.isNull()) {
        painter.setPen(palette().color(QPalette::BrightText));
        painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap, placeholder());
    } else {
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        painter.drawImage(rect(), m_picture);
    }
    if (hasFocus()) {
        painter.setPen(palette().color(QPalette::Highlight));
        painter.drawRect(rect().adjusted(0, 0, -1, -1));
    }
}

void OrbitView::resizeEvent(QResizeEvent*) {
    drawSoon();
}

void OrbitView::showEvent(QShowEvent*) {
    drawSoon();
}

void OrbitView::changeByHand(const Look& look) {
    m_look = look;
    drawSoon();
    Q_EMIT lookChanged();
}

void OrbitView::turnBy(double right, double down) {
    Look look = m_look;
    look.camera.turn -= static_cast<float>(right);
    look.camera.rise = std::clamp(look.camera.rise + static_cast<float>(down), -kMostRise, kMostRise);
    changeByHand(look);
}

void OrbitView::turnLightBy(double right) {
    constexpr double kWhole = 2 * std::numbers::pi;
    Look look = m_look;
    look.lightTurn = static_cast<float>(std::remainder(static_cast<double>(look.lightTurn) + right, kWhole));
    changeByHand(look);
}

float OrbitView::pointLength() const {
    return 2 * m_look.camera.distance * std::tan(m_look.camera.angle / 2) /
           static_cast<float>(std::max(1, std::min(width(), height())));
}

void OrbitView::moveBy(QPointF pixels) {
    Look look = m_look;
    const Eigen::Matrix3f axes = look.camera.axes();
    look.camera.target += pointLength() * (static_cast<float>(pixels.y()) * axes.row(1).transpose() -
                                           static_cast<float>(pixels.x()) * axes.row(0).transpose());
    changeByHand(look);
}

void OrbitView::comeNearer(double factor) {
    constexpr float kNearest = 0.3F, kFarthest = 50;
    Look look = m_look;
    look.camera.distance = std::clamp(look.camera.distance * static_cast<float>(factor), kNearest, kFarthest);
    changeByHand(look);
}

void OrbitView::mousePressEvent(QMouseEvent* event) {
    m_dragPoint = event->position();
}

QPointF OrbitView::dragged(const QMouseEvent& event) {
    const QPointF moved = event.position() - m_dragPoint;
    m_dragPoint = event.position();
    return moved;
}

void OrbitView::mouseMoveEvent(QMouseEvent* event) {
    const QPointF moved = dragged(*event);
    if (event->buttons() & Qt::LeftButton)
        turnBy(kTurn * moved.x(), kTurn * moved.y());
    else if (event->buttons() & Qt::MiddleButton)
        moveBy(moved);
    else if (event->buttons() & Qt::RightButton && event->modifiers() & Qt::ShiftModifier)
        turnLightBy(kTurn * moved.x());
}

void OrbitView::wheelEvent(QWheelEvent* event) {
    constexpr double kNotch = 120;
    comeNearer(std::pow(kKeyZoom, event->angleDelta().y() / kNotch));
    event->accept();
}

/// @return whether the key was one that turns the view or the light.
bool OrbitView::arrowKey(const QKeyEvent& event) {
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

void OrbitView::keyPressEvent(QKeyEvent* event) {
    if (arrowKey(*event))
        return;
    Look look = m_look;
    switch (event->key()) {
    case Qt::Key_Plus:
    case Qt::Key_Equal:
        return comeNearer(kKeyZoom);
    case Qt::Key_Minus:
        return comeNearer(1 / kKeyZoom);
    case Qt::Key_F:
        look.camera.target = Camera().target;
        look.camera.distance = Camera().distance;
        return changeByHand(look);
    case Qt::Key_R:
        look.camera = Camera();
        look.lightTurn = 0;
        return changeByHand(look);
    default:
        QWidget::keyPressEvent(event);
    }
}

} // namespace texloom::ui
