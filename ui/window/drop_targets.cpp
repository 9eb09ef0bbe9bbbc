#include "ui/window/drop_targets.h"

#include <QDragEnterEvent>
#include <QMimeData>
#include <QPainter>
#include <QStyle>

#include <algorithm>

namespace texloom::ui {

DropTargets::DropTargets(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("dropTargets"));
    setAccessibleName(tr("Places to drop"));
    setAcceptDrops(true);
    hide();
}

void DropTargets::open(bool files, bool masks) {
    m_cards = {{Target::Exemplar, tr("Exemplar"), tr("In place of the one you look at"), true},
               {Target::Add, tr("Add"), tr("As a further exemplar"), true},
               {Target::Companion, tr("Companion map"), tr("Gets the result's layout"), files},
               {Target::Mask, tr("Mask"),
                masks ? tr("Black is never copied") : tr("The method does not use a mask"), files && masks}};
    m_over.reset();
    m_entered = false;
    setGeometry(parentWidget()->rect());
    raise();
    show();
}

void DropTargets::close() {
    hide();
    Q_EMIT closed();
}

void DropTargets::closeUnlessEntered() {
    if (!m_entered)
        close();
}

QRect DropTargets::placeOf(Target target) const {
    const int gap = fontMetrics().height();
    const int columns = 2;
    const int width = (rect().width() - gap * (columns + 1)) / columns;
    const int height = (rect().height() - gap * (columns + 1)) / columns;
    const int index = static_cast<int>(target);
    return {gap + (index % columns) * (width + gap), gap + (index / columns) * (height + gap), width, height};
}

std::optional<DropTargets::Target> DropTargets::targetAt(QPoint point) const {
    for (const Card& card : m_cards)
        if (card.enabled && placeOf(card.target).contains(point))
            return card.target;
    return std::nullopt;
}

void DropTargets::dragEnterEvent(QDragEnterEvent* event) {
    m_entered = true;
    event->acceptProposedAction();
}

void DropTargets::dragMoveEvent(QDragMoveEvent* event) {
    m_over = targetAt(event->position().toPoint());
    event->setAccepted(m_over.has_value());
    update();
}

void DropTargets::dragLeaveEvent(QDragLeaveEvent*) {
    close();
}

void DropTargets::dropEvent(QDropEvent* event) {
    const std::optional<Target> target = targetAt(event->position().toPoint());
    close();
    if (!target)
        return;
    event->acceptProposedAction();
    Q_EMIT dropped(*target, *event->mimeData());
}

void DropTargets::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    QColor veil = palette().color(QPalette::Window);
    veil.setAlpha(215);
    painter.fillRect(rect(), veil);
    for (const Card& card : m_cards)
        paintCard(painter, card);
}

void DropTargets::paintCard(QPainter& painter, const Card& card) const {
    const bool over = m_over == card.target;
    const QPalette::ColorGroup group = card.enabled ? QPalette::Active : QPalette::Disabled;
    const int line = fontMetrics().height();
    const int width = style()->pixelMetric(QStyle::PM_DefaultFrameWidth, nullptr, this) * (over ? 3 : 1);
    const QRect place = placeOf(card.target).adjusted(width, width, -width, -width);
    painter.setPen(QPen(palette().color(group, over ? QPalette::Highlight : QPalette::WindowText), width,
                        over ? Qt::SolidLine : Qt::DashLine));
    painter.setBrush(over ? palette().brush(QPalette::Base) : QBrush(Qt::NoBrush));
    painter.drawRoundedRect(place, line / 2.0, line / 2.0);
    painter.setPen(palette().color(group, QPalette::WindowText));
    QFont bold = font();
    bold.setBold(true);
    bold.setPointSizeF(font().pointSizeF() * 1.4);
    painter.setFont(bold);
    painter.drawText(place.adjusted(line, 0, -line, -place.height() / 2), Qt::AlignHCenter | Qt::AlignBottom,
                     card.title);
    painter.setFont(font());
    painter.drawText(place.adjusted(line, place.height() / 2, -line, 0),
                     Qt::AlignHCenter | Qt::AlignTop | Qt::TextWordWrap, card.text);
}

} // namespace texloom::ui
