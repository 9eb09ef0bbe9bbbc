#include "ui/paint/label_painter.h"

#include <QButtonGroup>
#include <QFormLayout>
#include <QGridLayout>
#include <QIcon>
#include <QPainter>
#include <QPixmap>
#include <QPushButton>
#include <QSlider>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace texloom::ui {

namespace {

constexpr int kSwatchColumns = 4;
constexpr int kFirstShowing = 35; ///< percent of the picture that shows through first
constexpr int kWholeShowing = 100;
constexpr int kStrokeAlpha = 220;

/// The colours of a palette as a screen shows them.
std::vector<QRgb> shownColours(const labels::Palette& palette) {
    Image indices({static_cast<int>(palette.size()), 1}, 1);
    for (int i = 0; i < indices.width(); ++i)
        indices(i, 0, 0) = static_cast<float>(i);
    const DisplayPicture shown(std::make_shared<const Image>(labels::pictureOf(indices, palette)));
    std::vector<QRgb> colours;
    for (int i = 0; i < indices.width(); ++i)
        colours.push_back(shown.image().pixel(i, 0) | ~RGB_MASK);
    return colours;
}

/// A field of a colour; one that is chosen has a ring that is seen on any colour.
QPixmap swatchOf(QRgb colour, int side, qreal ratio, bool chosen) {
    QPixmap pixmap(QSize(side, side) * ratio);
    pixmap.setDevicePixelRatio(ratio);
    pixmap.fill(QColor(colour));
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    const auto ring = [&](const QColor& tint, double inset) {
        painter.setPen(QPen(tint, 2));
        painter.drawRect(QRectF(0, 0, side, side).adjusted(inset, inset, -inset, -inset));
    };
    if (chosen) {
        ring(Qt::black, 1);
        ring(Qt::white, 3);
        ring(Qt::black, 5);
    } else {
        ring(Qt::gray, 0);
    }
    return pixmap;
}

QImage labelVeil(const Image& indices, const std::vector<QRgb>& colours) {
    QImage veil(indices.width(), indices.height(), QImage::Format_ARGB32_Premultiplied);
    for (int y = 0; y < indices.height(); ++y) {
        const float* const row = indices.plane(0).row(y);
        std::transform(row, row + indices.width(), reinterpret_cast<QRgb*>(veil.scanLine(y)),
                       [&colours](float index) { return colours[static_cast<std::size_t>(index)]; });
    }
    return veil;
}

} // namespace

LabelPainter::LabelPainter(std::shared_ptr<const DisplayPicture> picture, bool ground, Image indices,
                           labels::Palette palette, const QString& meaning, QWidget* parent)
    : Painter(std::move(picture), std::move(indices), parent), m_palette(std::move(palette)),
      m_colours(shownColours(m_palette)), m_swatches(new QButtonGroup(this)), m_showing(new QSlider(this)) {
    addTool(PaintCanvas::Tool::Fill, "paintFill", tr("&Fill"),
            tr("Fills the area of one colour that is clicked"));
    addTool(PaintCanvas::Tool::Pick, "paintPick", tr("P&ick colour"),
            tr("Takes the colour that is clicked, and goes back to the brush"));
    canvas()->setAltPicks(true);
    connect(canvas(), &PaintCanvas::pointed, this, &LabelPainter::pointedAt);
    std::vector<QLayout*> parts = {makePalette(), makeLegend({}, meaning)};
    if (ground)
        parts.push_back(makeShowing());
    else
        m_showing->hide();
    parts.push_back(makeWhole());
    setColour(0);
    build(parts,
          tr("The wheel zooms, the middle button moves the picture. A double click or Enter closes a "
             "polygon. Alt and a click takes the colour there, Alt and a number that of the palette; [ and ] "
             "make the brush smaller and larger. Without a mouse: Shift and the arrow keys move the cursor, "
             "the space bar paints, fills or sets a corner."));
}

QLayout* LabelPainter::makePalette() {
    auto* grid = new QGridLayout;
    const int side = fontMetrics().height() * 2;
    for (int i = 0; i < static_cast<int>(m_palette.size()); ++i) {
        const QRgb colour = m_colours[static_cast<std::size_t>(i)];
        QIcon icon(swatchOf(colour, side, devicePixelRatioF(), false));
        icon.addPixmap(swatchOf(colour, side, devicePixelRatioF(), true), QIcon::Normal, QIcon::On);
        auto* button = new QToolButton(this);
        button->setObjectName(QStringLiteral("paintColour%1").arg(i + 1));
        button->setIcon(icon);
        button->setIconSize({side, side});
        button->setCheckable(true);
        button->setFocusPolicy(Qt::StrongFocus);
        button->setAccessibleName(tr("Colour %1").arg(i + 1));
        button->setToolTip(tr("Colour %1 (Alt+%1)").arg(i + 1));
        m_swatches->addButton(button, i);
        grid->addWidget(button, i / kSwatchColumns, i % kSwatchColumns);
        addKey(Qt::ALT | static_cast<Qt::Key>(Qt::Key_1 + i), [this, i] { setColour(i); });
    }
    grid->setColumnStretch(kSwatchColumns, 1);
    connect(m_swatches, &QButtonGroup::idClicked, this, [this](int index) {
        setColour(index);
        canvas()->setFocus();
    });
    return grid;
}

QLayout* LabelPainter::makeShowing() {
    m_showing->setObjectName(QStringLiteral("paintShowing"));
    m_showing->setOrientation(Qt::Horizontal);
    m_showing->setRange(0, kWholeShowing);
    m_showing->setToolTip(tr("How much of the picture shows through the colours"));
    const auto show = [this] {
        canvas()->setVeilOpacity(1 - static_cast<double>(m_showing->value()) / kWholeShowing);
    };
    connect(m_showing, &QSlider::valueChanged, this, show);
    m_showing->setValue(kFirstShowing);
    auto* form = new QFormLayout;
    form->addRow(tr("Picture &shows"), m_showing);
    return form;
}

QLayout* LabelPainter::makeWhole() {
    auto* column = new QVBoxLayout;
    auto* steps = new QHBoxLayout;
    connect(addButton(column, "paintWhole", tr("Paint &all"), tr("Paints the whole picture in the colour")),
            &QAbstractButton::clicked, this, [this] {
                set([index = m_colour](const Image& now) {
                    Image all(now.size(), 1);
                    for (int y = 0; y < all.height(); ++y)
                        std::fill_n(all.plane(0).row(y), all.width(), static_cast<float>(index));
                    return all;
                });
            });
    column->addLayout(steps);
    addSteps(steps);
    return column;
}

void LabelPainter::setColour(int index) {
    m_colour = index;
    m_swatches->button(index)->setChecked(true);
    QColor tint(m_colours[static_cast<std::size_t>(index)]);
    tint.setAlpha(kStrokeAlpha);
    canvas()->setTint(tint);
}

void LabelPainter::pointedAt(QPoint pixel, PaintCanvas::Tool tool) {
    if (tool == PaintCanvas::Tool::Fill)
        return set([pixel, index = m_colour](const Image& now) {
            return labels::filled(now, pixel.x(), pixel.y(), index);
        });
    if (canvas()->tool() == PaintCanvas::Tool::Pick)
        chooseTool(PaintCanvas::Tool::Brush);
    read([this, pixel](const Image& now) { setColour(static_cast<int>(now(pixel.x(), pixel.y(), 0))); });
}

Painter::Make LabelPainter::withShape(std::function<Image(Size)> shape, bool /*add*/) const {
    return [shape = std::move(shape), index = m_colour](const Image& now) {
        return labels::painted(now, shape(now.size()), index);
    };
}

Painter::Veil LabelPainter::veil() const {
    return [colours = m_colours](const Image& indices) { return labelVeil(indices, colours); };
}

} // namespace texloom::ui
