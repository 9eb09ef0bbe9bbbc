#include "ui/viewers/navigator.h"

#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QSettings>

#include <algorithm>
#include <utility>

namespace texloom::ui {

namespace {

const QString kWanted = QStringLiteral("viewer/navigator");
constexpr int kLongestLines = 9;  ///< of text: its longer side
constexpr int kLeastOfViewer = 3; ///< a viewer that is not so many times as large has none

} // namespace

Navigator::Navigator(QWidget* viewer) : QWidget(viewer), m_viewer(viewer) {
    setObjectName(QStringLiteral("navigator"));
    setCursor(Qt::OpenHandCursor);
    setToolTip(tr("The whole picture. Drag the frame to look elsewhere; N shows and hides this."));
    hide();
}

bool Navigator::wanted() {
    return QSettings().value(kWanted, true).toBool();
}

void Navigator::setWanted(bool wanted) {
    QSettings().setValue(kWanted, wanted);
}

void Navigator::follow(std::shared_ptr<const DisplayPicture> picture, const ViewTransform& view) {
    m_picture = std::move(picture);
    m_view = view;
    settle();
}

void Navigator::settle() {
    const int longest = fontMetrics().height() * kLongestLines;
    const bool roomy = std::min(m_viewer->width(), m_viewer->height()) >= kLeastOfViewer * longest;
    if (!m_picture || !roomy || !wanted())
        return hide();
    const Size size = m_picture->size();
    const QRectF shown(m_view.origin(), QSizeF(size.width, size.height) * m_view.scale());
    const QRectF all = QRectF(m_viewer->rect()).adjusted(-1, -1, 1, 1);
    if (all.contains(shown))
        return hide();
    const double scale = static_cast<double>(longest) / size.longerSide();
    const int margin = fontMetrics().height() / 2;
    resize(std::max(8, static_cast<int>(size.width * scale)),
           std::max(8, static_cast<int>(size.height * scale)));
    move(m_viewer->width() - width() - margin, m_viewer->height() - height() - margin);
    show();
    update();
}

QRectF Navigator::frame() const {
    const Size size = m_picture->size();
    const double scale = static_cast<double>(width()) / size.width;
    const QPointF from = m_view.toImage({0, 0}) * scale;
    const QPointF to = m_view.toImage(QPointF(m_viewer->width(), m_viewer->height())) * scale;
    return QRectF(from, to).intersected(QRectF(rect()));
}

void Navigator::paintEvent(QPaintEvent*) {
    if (!m_picture)
        return;
    QPainter painter(this);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    const double scale = static_cast<double>(width()) / m_picture->size().width * devicePixelRatioF();
    painter.drawImage(rect(), m_picture->levelFor(scale));
    const QRectF part = frame();
    QPainterPath outside;
    outside.addRect(rect());
    outside.addRect(part);
    painter.fillPath(outside, QColor(0, 0, 0, 110));
    painter.setPen(QPen(Qt::black, 3));
    painter.drawRect(part.adjusted(1, 1, -1, -1));
    painter.setPen(QPen(Qt::white, 1));
    painter.drawRect(part.adjusted(1, 1, -1, -1));
    painter.setPen(QColor(0, 0, 0, 160));
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

void Navigator::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton)
        moveTo(event->position());
}

void Navigator::mouseMoveEvent(QMouseEvent* event) {
    if (event->buttons() & Qt::LeftButton)
        moveTo(event->position());
}

void Navigator::moveTo(QPointF point) {
    const double scale = static_cast<double>(m_picture->size().width) / width();
    Q_EMIT placeWanted(point * scale);
}

} // namespace texloom::ui
