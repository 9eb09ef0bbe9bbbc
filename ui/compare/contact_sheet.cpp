#include "ui/compare/contact_sheet.h"

#include "core/base/error.h"

#include <QPainter>
#include <QSaveFile>

#include <algorithm>

namespace texloom::ui {

namespace {

/// Where things lie on a sheet, in pixels.
struct SheetLayout {
    int side;
    int line;
    int margin;
    int columns;

    int cellWidth() const { return side + margin; }
    int cellHeight() const { return side + line * 2 + margin; }
    QRect pictureAt(int index) const {
        return {margin + index % columns * cellWidth(), margin + index / columns * cellHeight(), side, side};
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
    const double scale =
        std::min(1.0, static_cast<double>(place.width()) / item.picture->size().longerSide());
    const QImage& level = item.picture->levelFor(scale);
    const QSize whole(item.picture->size().width, item.picture->size().height);
    QRect target(QPoint(), (QSizeF(whole) * scale).toSize().expandedTo({1, 1}));
    target.moveCenter(place.center());
    painter.drawImage(target, level);
}

} // namespace

QImage contactSheet(const std::vector<CompareItem>& items, int columns, int side, const QFont& font) {
    QFont labels = font;
    labels.setPixelSize(std::max(12, side / 24));
    const QFontMetrics metrics(labels);
    const int count = static_cast<int>(items.size());
    const SheetLayout layout{side, metrics.height(), std::max(4, side / 24), std::min(columns, count)};
    const int rows = (count + layout.columns - 1) / layout.columns;
    QImage sheet(layout.margin + layout.columns * layout.cellWidth(),
                 layout.margin + rows * layout.cellHeight(), QImage::Format_RGB32);
    if (sheet.isNull())
        fail("A sheet of {} × {} pictures of {} px is too large; compare fewer.", layout.columns, rows, side);
    sheet.fill(Qt::white);
    QPainter painter(&sheet);
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
