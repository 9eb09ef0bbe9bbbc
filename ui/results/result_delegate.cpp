#include "ui/results/result_delegate.h"

#include "ui/common/icons.h"
#include "ui/runs/result_history.h"

#include <QApplication>
#include <QImage>
#include <QPainter>
#include <QWidget>

#include <algorithm>

namespace texloom::ui {

namespace {

constexpr int kThumbnailLines = 4;
constexpr int kTextWidths = 24; ///< in average characters

/// Where the parts of a card lie.
struct Card {
    QRect thumbnail;
    QRect title;
    QRect chips;

    Card(const QRect& card, const QFontMetrics& metrics) {
        const int line = metrics.height();
        const int margin = line / 3;
        const QRect inner = card.adjusted(margin, margin, -margin, -margin);
        thumbnail = QRect(inner.topLeft(), QSize(1, 1) * line * kThumbnailLines);
        const int left = thumbnail.right() + 1 + margin * 2;
        title = QRect(left, inner.top(), inner.right() + 1 - left, line);
        chips = QRect(left, title.bottom() + 1 + margin / 2, title.width(), inner.bottom() - title.bottom());
    }
};

void drawThumbnail(QPainter& painter, const QImage& image, const QRect& place) {
    if (image.isNull())
        return;
    const QSize size = image.size().scaled(place.size(), Qt::KeepAspectRatio);
    QRect target(QPoint(), size);
    target.moveCenter(place.center());
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(target, image);
}

/// Draws as many chips as fit, in lines.
void drawChips(QPainter& painter, const QStringList& chips, const QRect& place, const QColor& text) {
    const QFontMetrics metrics = painter.fontMetrics();
    const int gap = metrics.averageCharWidth();
    const int height = metrics.height() + gap / 2;
    QColor frame = text;
    frame.setAlphaF(0.35F);
    QPoint at = place.topLeft();
    for (const QString& chip : chips) {
        QRect box(at, QSize(metrics.horizontalAdvance(chip) + gap, height));
        if (box.right() > place.right() && at.x() > place.left())
            box.moveTopLeft({place.left(), box.bottom() + 1 + gap / 3});
        if (box.bottom() > place.bottom() + gap / 2)
            return;
        painter.setPen(frame);
        painter.drawRoundedRect(QRectF(box).adjusted(0.5, 0.5, -0.5, -0.5), gap / 2.0, gap / 2.0);
        painter.setPen(text);
        painter.drawText(box, Qt::AlignCenter, chip);
        at = box.topRight() + QPoint(gap / 2, 0);
    }
}

/// A small icon in a corner of the thumbnail.
void drawMark(QPainter& painter, const QString& name, const QPoint& corner, int side) {
    const QRect disc(corner, QSize(1, 1) * side * 3 / 2);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QApplication::palette().color(QPalette::Button));
    painter.drawEllipse(disc);
    QRect drawing(0, 0, side, side);
    drawing.moveCenter(disc.center());
    icon(name).paint(&painter, drawing);
}

/// Stars along the thumbnail's lower edge, on a dark band so that they are seen on any picture.
void drawStars(QPainter& painter, int stars, const QRect& thumbnail, int side) {
    if (stars <= 0)
        return;
    const QString text(stars, QChar(0x2605));
    QRect band(thumbnail.left(), thumbnail.bottom() + 1 - side, 0, side);
    band.setWidth(std::min(thumbnail.width(), painter.fontMetrics().horizontalAdvance(text) + side / 2));
    painter.fillRect(band, QColor(0, 0, 0, 190));
    painter.setPen(Qt::white);
    painter.drawText(band, Qt::AlignCenter, text);
}

/// The font of chips: a little smaller than that of titles.
QFont chipFont(QFont font) {
    font.setPointSizeF(font.pointSizeF() * 0.85);
    return font;
}

} // namespace

QSize ResultDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const {
    const int line = option.fontMetrics.height();
    const int margin = line / 3;
    return {line * kThumbnailLines + margin * 4 + option.fontMetrics.averageCharWidth() * kTextWidths,
            line * kThumbnailLines + margin * 2};
}

void ResultDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                           const QModelIndex& index) const {
    painter->save();
    const QStyle* const style = option.widget != nullptr ? option.widget->style() : QApplication::style();
    const bool selected = option.state & QStyle::State_Selected;
    const auto group = option.state & QStyle::State_Active ? QPalette::Active : QPalette::Inactive;
    if (selected)
        painter->fillRect(option.rect, option.palette.color(group, QPalette::Highlight));
    const Card card(option.rect, option.fontMetrics);
    drawThumbnail(*painter, index.data(Qt::DecorationRole).value<QImage>(), card.thumbnail);
    const int side = option.fontMetrics.height();
    if (index.data(ResultHistory::PinnedRole).toBool())
        drawMark(*painter, QStringLiteral("pin"), card.thumbnail.topRight() - QPoint(side * 3 / 2, 0), side);
    if (index.data(ResultHistory::ShownRole).toBool())
        drawMark(*painter, QStringLiteral("shown"), card.thumbnail.topLeft(), side);

    drawStars(*painter, index.data(ResultHistory::StarsRole).toInt(), card.thumbnail, side);

    const QColor text = option.palette.color(group, selected ? QPalette::HighlightedText : QPalette::Text);
    painter->setRenderHint(QPainter::Antialiasing, true);
    painter->setFont(option.font);
    painter->setPen(text);
    const QString title = index.data(Qt::DisplayRole).toString();
    painter->drawText(card.title, Qt::AlignLeft | Qt::AlignVCenter,
                      option.fontMetrics.elidedText(title, Qt::ElideMiddle, card.title.width()));
    painter->setFont(chipFont(option.font));
    painter->setBrush(Qt::NoBrush);
    drawChips(*painter, index.data(ResultHistory::ChipsRole).toStringList(), card.chips, text);
    if (option.state & QStyle::State_HasFocus) {
        QStyleOptionFocusRect focus;
        focus.QStyleOption::operator=(option);
        style->drawPrimitive(QStyle::PE_FrameFocusRect, &focus, painter, option.widget);
    }
    painter->restore();
}

void ResultDelegate::updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                                          const QModelIndex&) const {
    const Card card(option.rect, option.fontMetrics);
    const int height = editor->sizeHint().height();
    QRect place(card.title.left(), 0, card.title.width(), height);
    place.moveCenter(card.title.center());
    if (place.top() < option.rect.top())
        place.moveTop(option.rect.top());
    editor->setGeometry(place);
}

} // namespace texloom::ui
