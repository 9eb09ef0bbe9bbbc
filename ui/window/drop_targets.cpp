#include "ui/window/drop_targets.h"

#include "ui/common/text.h"

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

void DropTargets::open(Dragged dragged, bool masks, const std::vector<Port>& ports) {
    const bool files = dragged == Dragged::Files;
    m_cards = {{tr("Exemplar"), tr("In place of the one you look at"), true},
               {tr("Add"), tr("Mixed with the exemplars in use"), true},
               {tr("Companion map"), tr("Gets the result's layout"), files},
               {tr("Mask"), masks ? tr("Black is never copied") : tr("The method does not use a mask"),
                files && masks}};
    addPorts(dragged, ports);
    cover();
}

void DropTargets::openWithoutExemplar(Dragged dragged, const std::vector<Port>& ports) {
    m_cards = {{tr("Exemplar"), tr("Opened to learn from"), true}};
    addPorts(dragged, ports);
    cover();
}

void DropTargets::addPorts(Dragged dragged, const std::vector<Port>& ports) {
    for (const Port& port : ports) {
        const bool takes = dragged != Dragged::Picture || port.kind == AssetKind::Image;
        m_cards.push_back({translated(port.title), translated(port.help), takes, port.id});
    }
}

void DropTargets::cover() {
    m_over = -1;
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

QRect DropTargets::placeAt(int index) const {
    constexpr int kColumns = 2;
    const int rows = (static_cast<int>(m_cards.size()) + kColumns - 1) / kColumns;
    const int gap = fontMetrics().height();
    const int width = (rect().width() - gap * (kColumns + 1)) / kColumns;
    const int height = (rect().height() - gap * (rows + 1)) / rows;
    return {gap + (index % kColumns) * (width + gap), gap + (index / kColumns) * (height + gap), width,
            height};
}

QRect DropTargets::placeOf(const std::string& port) const {
    for (std::size_t i = 0; i < m_cards.size(); ++i)
        if (m_cards[i].port == port)
            return placeAt(static_cast<int>(i));
    return {};
}

int DropTargets::cardAt(QPoint point) const {
    for (int i = 0; i < static_cast<int>(m_cards.size()); ++i)
        if (m_cards[static_cast<std::size_t>(i)].enabled && placeAt(i).contains(point))
            return i;
    return -1;
}

std::optional<DropTargets::Target> DropTargets::targetAt(QPoint point) const {
    const int card = cardAt(point);
    if (card < 0 || !m_cards[static_cast<std::size_t>(card)].port.empty())
        return std::nullopt;
    return static_cast<Target>(card);
}

std::string DropTargets::portAt(QPoint point) const {
    const int card = cardAt(point);
    return card < 0 ? std::string() : m_cards[static_cast<std::size_t>(card)].port;
}

void DropTargets::dragEnterEvent(QDragEnterEvent* event) {
    m_entered = true;
    event->acceptProposedAction();
}

void DropTargets::dragMoveEvent(QDragMoveEvent* event) {
    m_over = cardAt(event->position().toPoint());
    event->setAccepted(m_over >= 0);
    update();
}

void DropTargets::dragLeaveEvent(QDragLeaveEvent*) {
    close();
}

void DropTargets::dropEvent(QDropEvent* event) {
    const QPoint point = event->position().toPoint();
    const std::optional<Target> target = targetAt(point);
    const std::string port = portAt(point);
    close();
    if (!target && port.empty())
        return;
    event->acceptProposedAction();
    if (target)
        Q_EMIT dropped(*target, *event->mimeData());
    else
        Q_EMIT droppedInto(port, *event->mimeData());
}

void DropTargets::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    QColor veil = palette().color(QPalette::Window);
    veil.setAlpha(215);
    painter.fillRect(rect(), veil);
    for (int i = 0; i < static_cast<int>(m_cards.size()); ++i)
        paintCard(painter, i);
}

void DropTargets::paintCard(QPainter& painter, int index) const {
    const Card& card = m_cards[static_cast<std::size_t>(index)];
    const bool over = m_over == index;
    const QPalette::ColorGroup group = card.enabled ? QPalette::Active : QPalette::Disabled;
    const int line = fontMetrics().height();
    const int width = style()->pixelMetric(QStyle::PM_DefaultFrameWidth, nullptr, this) * (over ? 3 : 1);
    const QRect place = placeAt(index).adjusted(width, width, -width, -width);
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
