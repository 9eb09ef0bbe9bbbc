#include "ui/compare/contact_sheet.h"

#include "core/base/error.h"

#include <QPainter>
#include <QSaveFile>

#include <algorithm>
#include <cmath>

namespace texloom::ui {

namespace {

/// Where things lie on a sheet, in pixels.
struct SheetLayout {
    int side;
    int line;
    int margin;
    int columns;
    int top; ///< height of the heading

    int cellWidth() const { return side + margin; }
    int cellHeight() const { return side + line * 2 + margin; }
    QRect pictureAt(int index) const {
        return {margin + index % columns * cellWidth(), top + margin + index / columns * cellHeight(), side,
                side};
    }
    QRect labelAt(int index) const {
        const QRect picture = pictureAt(index);
        return {picture.left(), picture.bottom() + 1, side, line * 2};
    }
};

void paintCell(QPainter& painter, const CompareItem& item, const QRect& place) {
    if (!item.picture) {
        painter.setPen(QColor(0x90, 0x90, 0x90));
        painter.drawRect(place.adjusted(0, 0, -1, -1));
        painter.setPen(Qt::black);
        painter.drawText(place.adjusted(8, 8, -8, -8), Qt::AlignCenter | Qt::TextWordWrap, item.message);
        return;
    }
    // Small pictures are enlarged by whole factors, which keep their pixels square.
    const double fitting = static_cast<double>(place.width()) / item.picture->size().longerSide();
    const double scale = fitting > 1 ? std::floor(fitting) : fitting;
    const QImage& level = item.picture->levelFor(std::min(1.0, scale));
    const QSize whole(item.picture->size().width, item.picture->size().height);
    QRect target(QPoint(), (QSizeF(whole) * scale).toSize().expandedTo({1, 1}));
    target.moveCenter(place.center());
    painter.drawImage(target, level);
}

/// Where the heading goes: over the sheet's whole width, in as many lines as it takes.
QRect headingPlace(const QString& heading, const QFontMetrics& metrics, int width, int margin) {
    if (heading.isEmpty())
        return {};
    return metrics.boundingRect(QRect(margin, margin, width - 2 * margin, metrics.height()),
                                Qt::AlignLeft | Qt::TextWordWrap, heading);
}

} // namespace

QImage contactSheet(const std::vector<CompareItem>& items, const QString& heading, int columns, int side,
                    const QFont& font) {
    QFont labels = font;
    labels.setPixelSize(std::max(12, side / 24));
    const QFontMetrics metrics(labels);
    const int count = static_cast<int>(items.size());
    QFont large = labels;
    large.setBold(true);
    SheetLayout layout{side, metrics.height(), std::max(4, side / 24), std::min(columns, count), 0};
    const int width = layout.margin + layout.columns * layout.cellWidth();
    const QRect headed = headingPlace(heading, QFontMetrics(large), width, layout.margin);
    layout.top = heading.isEmpty() ? 0 : headed.bottom() + 1;
    const int rows = (count + layout.columns - 1) / layout.columns;
    QImage sheet(width, layout.top + layout.margin + rows * layout.cellHeight(), QImage::Format_RGB32);
    if (sheet.isNull())
        fail("A sheet of {} × {} pictures of {} px is too large; compare fewer.", layout.columns, rows, side);
    sheet.fill(Qt::white);
    QPainter painter(&sheet);
    painter.setFont(large);
    painter.setPen(Qt::black);
    painter.drawText(headed, Qt::AlignLeft | Qt::TextWordWrap, heading);
    painter.setFont(labels);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    for (int i = 0; i < count; ++i) {
        const CompareItem& item = items[static_cast<std::size_t>(i)];
        paintCell(painter, item, layout.pictureAt(i));
        painter.setPen(Qt::black);
        painter.drawText(layout.labelAt(i), Qt::AlignHCenter | Qt::AlignVCenter | Qt::TextWordWrap,
                         item.label);
    }
    return sheet;
}

void writeSheet(const QImage& sheet, const QString& path) {
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly) || !sheet.save(&file, "PNG") || !file.commit())
        fail("{} cannot be written: {}.", path.toStdString(), file.errorString().toStdString());
}

} // namespace texloom::ui
