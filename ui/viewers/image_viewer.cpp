#include "ui/viewers/image_viewer.h"

#include "ui/common/text.h"
#include "ui/viewers/navigator.h"
#include "ui/viewers/scope.h"
#include "ui/viewers/viewer_keys.h"

#include <QApplication>
#include <QCursor>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <utility>

namespace texloom::ui {

namespace {

constexpr double kZoomStep = 1.25;
constexpr double kWheelNotch = 120;

int modulo(int value, int divisor) {
    const int rest = value % divisor;
    return rest < 0 ? rest + divisor : rest;
}

} // namespace

ImageViewer::ImageViewer(QWidget* parent)
    : QWidget(parent), m_navigator(new Navigator(this)), m_scope(new Scope(this)) {
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    connect(m_navigator, &Navigator::placeWanted, this, &ImageViewer::centreOn);
    setAttribute(Qt::WA_OpaquePaintEvent);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

QSize ImageViewer::sizeHint() const {
    return QSize(1, 1) * fontMetrics().height() * 12;
}

QSize ImageViewer::minimumSizeHint() const {
    return QSize(1, 1) * fontMetrics().height() * 6;
}

void ImageViewer::setPicture(std::shared_ptr<const DisplayPicture> picture) {
    const bool sameSize = m_picture && picture && m_picture->size() == picture->size();
    m_picture = std::move(picture);
    if (!sameSize) {
        m_fitted = true;
        m_cursor.reset();
    }
    if (m_fitted)
        fitQuietly();
    m_scope->setPicture(m_picture);
    describe();
    update();
    placeOverlays();
    Q_EMIT viewSettled();
}

void ImageViewer::placeOverlays() {
    m_navigator->follow(m_repeat ? nullptr : m_picture, m_view);
    const int line = fontMetrics().height();
    m_scope->resize(std::min(line * 16, width() - line), std::min(line * 8, height() - line));
    m_scope->move(width() - m_scope->width() - line / 2, line / 2);
}

void ImageViewer::showNextScope() {
    m_scope->cycle();
}

void ImageViewer::toggleNavigator() {
    Navigator::setWanted(!Navigator::wanted());
    for (QWidget* widget : QApplication::allWidgets())
        if (auto* navigator = qobject_cast<Navigator*>(widget))
            navigator->settle();
}

void ImageViewer::setPlaceholder(const QString& text) {
    m_placeholder = text;
    describe();
    update();
}

void ImageViewer::setBadge(const QString& text) {
    m_badge = text;
    describe();
    update();
}

void ImageViewer::setHidden(const QImage& hidden) {
    m_hidden = hidden;
    update();
}

void ImageViewer::setMarker(std::optional<QPoint> pixel) {
    if (m_marker == pixel)
        return;
    m_marker = pixel;
    update();
}

void ImageViewer::setRings(std::vector<QPoint> pixels) {
    if (m_rings == pixels)
        return;
    m_rings = std::move(pixels);
    update();
}

void ImageViewer::setView(const ViewTransform& view, bool fitted) {
    m_fitted = fitted;
    m_view = view;
    if (fitted)
        fitQuietly();
    update();
    placeOverlays();
}

void ImageViewer::centreOn(QPointF place) {
    panBy(QRectF(rect()).center() - m_view.toWidget(place));
}

void ImageViewer::lookAt(QPointF middle, double side) {
    m_fitted = false;
    m_view.setScaleAt({0, 0}, std::min(width(), height()) / side);
    m_view.pan(QRectF(rect()).center() - m_view.toWidget(middle));
    changedByHand();
}

std::optional<QPoint> ImageViewer::pixelAt(QPointF point) const {
    if (!m_picture)
        return {};
    const QPointF exact = m_view.toImage(point);
    const QPoint pixel(static_cast<int>(std::floor(exact.x())), static_cast<int>(std::floor(exact.y())));
    const Size size = m_picture->size();
    if (m_repeat)
        return QPoint(modulo(pixel.x(), size.width), modulo(pixel.y(), size.height));
    if (!QRect(0, 0, size.width, size.height).contains(pixel))
        return {};
    return pixel;
}

QSizeF ImageViewer::imageSize() const {
    return m_picture ? QSizeF(m_picture->size().width, m_picture->size().height) : QSizeF();
}

void ImageViewer::fitQuietly() {
    const QSizeF view = m_repeat ? QSizeF(size()) / 2 : QSizeF(size());
    m_view.fit(imageSize(), view, devicePixelRatioF());
    if (m_repeat)
        m_view.pan({view.width() / 2, view.height() / 2});
}

void ImageViewer::fit() {
    m_fitted = true;
    fitQuietly();
    changedByHand();
}

void ImageViewer::actualSize() {
    setZoom(1);
}

void ImageViewer::setZoom(double zoom) {
    m_fitted = false;
    m_view.setScaleAt(QRectF(rect()).center(), zoom / devicePixelRatioF());
    changedByHand();
}

void ImageViewer::zoomIn() {
    zoomBy(kZoomStep, zoomAnchor());
}

void ImageViewer::zoomOut() {
    zoomBy(1 / kZoomStep, zoomAnchor());
}

void ImageViewer::setRepeats(bool repeat) {
    if (m_repeat == repeat)
        return;
    m_repeat = repeat;
    if (m_fitted)
        fitQuietly();
    changedByHand();
    Q_EMIT repeatsChanged(repeat);
}

void ImageViewer::showSeams() {
    if (!m_picture)
        return;
    setRepeats(true);
    m_fitted = false;
    m_view.fit(imageSize(), size(), devicePixelRatioF());
    m_view.pan(QRectF(rect()).center() - m_view.toWidget({0, 0}));
    changedByHand();
}

QPointF ImageViewer::zoomAnchor() const {
    const QPoint cursor = mapFromGlobal(QCursor::pos());
    return underMouse() && rect().contains(cursor) ? QPointF(cursor) : QRectF(rect()).center();
}

void ImageViewer::zoomBy(double factor, QPointF anchor) {
    m_fitted = false;
    m_view.setScaleAt(anchor, m_view.scale() * factor);
    changedByHand();
}

void ImageViewer::panBy(QPointF distance) {
    m_fitted = false;
    m_view.pan(distance);
    changedByHand();
}

void ImageViewer::changedByHand() {
    if (!m_repeat && m_picture)
        m_view.keepInReach(imageSize(), size());
    describe();
    update();
    placeOverlays();
    Q_EMIT viewChanged();
}

void ImageViewer::describe() {
    QString text = m_placeholder;
    if (m_picture)
        text =
            tr("%1 pixels at %2. %3")
                .arg(sizeText(m_picture->size()), percentText(m_view.scale() * devicePixelRatioF()), m_badge)
                .trimmed();
    if (text != accessibleDescription())
        setAccessibleDescription(text);
}

void ImageViewer::resizeEvent(QResizeEvent*) {
    if (m_fitted)
        fitQuietly();
    else if (!m_repeat && m_picture)
        m_view.keepInReach(imageSize(), size());
    placeOverlays();
    Q_EMIT viewSettled();
}

void ImageViewer::wheelEvent(QWheelEvent* event) {
    if (m_picture)
        zoomBy(std::pow(kZoomStep, event->angleDelta().y() / kWheelNotch), event->position());
    event->accept();
}

void ImageViewer::mousePressEvent(QMouseEvent* event) {
    m_dragging = event->button() == Qt::LeftButton || event->button() == Qt::MiddleButton;
    m_dragPoint = event->position();
    if (m_dragging)
        setCursor(Qt::ClosedHandCursor);
}

void ImageViewer::mouseMoveEvent(QMouseEvent* event) {
    if (m_dragging) {
        panBy(event->position() - m_dragPoint);
        m_dragPoint = event->position();
    }
    m_cursor.reset();
    hoverAt(event->position());
}

void ImageViewer::mouseReleaseEvent(QMouseEvent*) {
    m_dragging = false;
    unsetCursor();
}

void ImageViewer::leaveEvent(QEvent*) {
    Q_EMIT unhovered();
}

void ImageViewer::focusInEvent(QFocusEvent* event) {
    QWidget::focusInEvent(event);
    update();
}

void ImageViewer::focusOutEvent(QFocusEvent* event) {
    QWidget::focusOutEvent(event);
    m_cursor.reset();
    update();
}

void ImageViewer::hoverAt(QPointF point) {
    if (const auto pixel = pixelAt(point))
        Q_EMIT hovered(*pixel);
    else
        Q_EMIT unhovered();
}

bool ImageViewer::panKey(const QKeyEvent& event) {
    const std::pair<int, QPoint> ways[] = {
        {Qt::Key_Left, {-1, 0}}, {Qt::Key_Right, {1, 0}}, {Qt::Key_Up, {0, -1}}, {Qt::Key_Down, {0, 1}}};
    for (const auto& [key, way] : ways)
        if (event.key() == key) {
            if (event.modifiers() & Qt::ShiftModifier)
                moveCursor(way);
            else
                panBy(-QPointF(way) * fontMetrics().height() * 2);
            return true;
        }
    return false;
}

bool ImageViewer::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) {
        if (viewerCommandAt(*static_cast<QKeyEvent*>(event)))
            event->accept();
    }
    return QWidget::event(event);
}

void ImageViewer::keyPressEvent(QKeyEvent* event) {
    if (!m_picture || panKey(*event))
        return;
    const std::optional<ViewerCommand> command = viewerCommandAt(*event);
    if (!command)
        return QWidget::keyPressEvent(event);
    act(*command);
}

void ImageViewer::act(ViewerCommand command) {
    switch (command) {
    case ViewerCommand::Fit:
        return fit();
    case ViewerCommand::ActualSize:
        return actualSize();
    case ViewerCommand::ZoomIn:
        return zoomIn();
    case ViewerCommand::ZoomOut:
        return zoomOut();
    case ViewerCommand::Repeat:
        return setRepeats(!m_repeat);
    case ViewerCommand::Seams:
        return showSeams();
    case ViewerCommand::Navigator:
        return toggleNavigator();
    case ViewerCommand::Scope:
        return showNextScope();
    }
}

std::optional<QPointF> ImageViewer::cursorMiddle() const {
    return m_cursor ? std::optional(QPointF(*m_cursor) + QPointF(0.5, 0.5)) : std::nullopt;
}

void ImageViewer::moveCursor(QPoint step) {
    const Size size = m_picture->size();
    const QPoint from = m_cursor.value_or(pixelAt(QRectF(rect()).center()).value_or(QPoint()));
    m_cursor = QPoint(std::clamp(from.x() + step.x(), 0, size.width - 1),
                      std::clamp(from.y() + step.y(), 0, size.height - 1));
    update();
    Q_EMIT hovered(*m_cursor);
}

} // namespace texloom::ui
