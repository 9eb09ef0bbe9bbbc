#include "ui/common/flow_layout.h"

#include <QStyle>
#include <QWidget>

#include <algorithm>

namespace texloom::ui {

FlowLayout::FlowLayout(QWidget* parent) : QLayout(parent) {
    setContentsMargins(0, 0, 0, 0);
}

FlowLayout::~FlowLayout() {
    qDeleteAll(m_items);
}

void FlowLayout::addItem(QLayoutItem* item) {
    m_items.append(item);
}

QLayoutItem* FlowLayout::takeAt(int index) {
    return index >= 0 && index < m_items.size() ? m_items.takeAt(index) : nullptr;
}

int FlowLayout::heightForWidth(int width) const {
    return rows({0, 0, width, 0}, false);
}

QSize FlowLayout::sizeHint() const {
    QSize whole;
    for (const QLayoutItem* item : m_items) {
        if (item->isEmpty())
            continue;
        const QSize size = item->sizeHint();
        whole = {whole.width() + size.width() + (whole.isEmpty() ? 0 : std::max(0, spacing())),
                 std::max(whole.height(), size.height())};
    }
    return whole;
}

QSize FlowLayout::minimumSize() const {
    QSize largest;
    for (const QLayoutItem* item : m_items)
        if (!item->isEmpty())
            largest = largest.expandedTo(item->minimumSize());
    return largest;
}

void FlowLayout::setGeometry(const QRect& place) {
    QLayout::setGeometry(place);
    rows(place, true);
}

int FlowLayout::rows(const QRect& place, bool move) const {
    const int gap = std::max(0, spacing());
    int x = 0, y = 0, height = 0;
    QList<QLayoutItem*> row;
    const auto end = [&] {
        for (QLayoutItem* item : row) { // in the middle of the row, which is as high as its highest
            const QRect own = item->geometry();
            if (move)
                item->setGeometry(own.translated(0, (height - own.height()) / 2));
        }
        row.clear();
    };
    for (QLayoutItem* item : m_items) {
        if (item->isEmpty())
            continue;
        const QSize size(std::clamp(item->sizeHint().width(),
                                    std::min(item->minimumSize().width(), place.width()),
                                    std::max(1, place.width())),
                         item->sizeHint().height());
        if (x > 0 && x + size.width() > place.width()) {
            end();
            y += height + gap;
            x = height = 0;
        }
        if (move) {
            const QRect own(place.topLeft() + QPoint(x, y), size);
            item->setGeometry(QStyle::visualRect(parentWidget()->layoutDirection(), place, own));
            row.append(item);
        }
        x += size.width() + gap;
        height = std::max(height, size.height());
    }
    end();
    return y + height;
}

} // namespace texloom::ui
