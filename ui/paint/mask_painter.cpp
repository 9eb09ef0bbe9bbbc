#include "ui/paint/mask_painter.h"

#include "core/image/selection.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QPainter>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace texloom::ui {

namespace {

constexpr int kMostPixels = 256, kFirstPixels = 4;
constexpr QColor kVeilColor(255, 0, 110, 140);

} // namespace

MaskPainter::MaskPainter(std::shared_ptr<const DisplayPicture> picture, Image selection,
                         const QString& meaning, QWidget* parent)
    : Painter(std::move(picture), std::move(selection), parent),
      m_takeAway(new QCheckBox(tr("&Take away"), this)), m_pixels(new QSpinBox(this)) {
    canvas()->setTint(kVeilColor);
    build({makeTakeAway(), makeMeaning(meaning), makeEdges(), makeWhole()},
          tr("The wheel zooms, the middle button moves the picture. A double click or Enter closes a "
             "polygon. Alt takes away; [ and ] make the brush smaller and larger. Without a mouse: Shift and "
             "the arrow keys move the cursor, the space bar paints or sets a corner."));
}

Painter::Make MaskPainter::withShape(std::function<Image(Size)> shape, bool add) const {
    return [shape = std::move(shape), add](const Image& now) {
        return selections::combined(now, shape(now.size()), add);
    };
}

QImage MaskPainter::veilOf(const Image& selection) {
    constexpr int kWhole = 255;
    std::array<QRgb, kWhole + 1> colors{};
    const QColor color = kVeilColor;
    for (int i = 0; i <= kWhole; ++i)
        colors[static_cast<std::size_t>(i)] =
            qPremultiply(qRgba(color.red(), color.green(), color.blue(), color.alpha() * i / kWhole));
    QImage veil(selection.width(), selection.height(), QImage::Format_ARGB32_Premultiplied);
    for (int y = 0; y < selection.height(); ++y) {
        const float* const row = selection.plane(0).row(y);
        std::transform(row, row + selection.width(), reinterpret_cast<QRgb*>(veil.scanLine(y)),
                       [&colors](float value) {
                           const float share = std::clamp(value, 0.0F, 1.0F);
                           return colors[static_cast<std::size_t>(std::lround(share * kWhole))];
                       });
    }
    return veil;
}

QLayout* MaskPainter::makeTakeAway() {
    auto* row = new QHBoxLayout;
    m_takeAway->setObjectName(QStringLiteral("maskTakeAway"));
    m_takeAway->setToolTip(
        tr("Shapes are taken away from what is painted. Alt does the same for one shape."));
    connect(m_takeAway, &QCheckBox::toggled, canvas(), &PaintCanvas::setTakesAway);
    row->addWidget(m_takeAway);
    return row;
}

QLayout* MaskPainter::makeMeaning(const QString& meaning) {
    const int side = fontMetrics().height();
    QPixmap swatch(side, side);
    swatch.fill(Qt::gray);
    QPainter(&swatch).fillRect(swatch.rect(), kVeilColor);
    return makeLegend(swatch, tr("Painted: black in the mask, lighter where it is softened.") +
                                  QLatin1Char(' ') + meaning);
}

QLayout* MaskPainter::makeEdges() {
    auto* column = new QVBoxLayout;
    m_pixels->setObjectName(QStringLiteral("maskPixels"));
    m_pixels->setAccessibleName(tr("Pixels by which edges are moved"));
    m_pixels->setRange(1, kMostPixels);
    m_pixels->setValue(kFirstPixels);
    m_pixels->setSuffix(QLatin1Char(' ') + tr("px"));
    m_pixels->setToolTip(tr("By how many pixels the buttons below grow, shrink or soften what is painted."));
    auto* form = new QFormLayout;
    form->addRow(tr("Edges by"), m_pixels);
    column->addLayout(form);
    auto* row = new QHBoxLayout;
    column->addLayout(row);
    using Filter = Image (*)(const ImageView&, int, const std::function<void()>&);
    const auto connectTo = [this](const QAbstractButton* button, Filter filter) {
        connect(button, &QAbstractButton::clicked, this, [this, filter] {
            set([filter, pixels = m_pixels->value()](const Image& now) {
                return filter(now, pixels, [] {});
            });
        });
    };
    connectTo(addButton(row, "maskGrow", tr("&Grow"), tr("Paints further, by so many pixels")),
              &selections::grown);
    connectTo(addButton(row, "maskShrink", tr("&Shrink"), tr("Paints less far, by so many pixels")),
              &selections::shrunk);
    connectTo(addButton(row, "maskFeather", tr("&Feather"),
                        tr("Softens the edge outwards, over so many pixels: what was painted stays whole")),
              &selections::feathered);
    return column;
}

QLayout* MaskPainter::makeWhole() {
    auto* column = new QVBoxLayout;
    auto* first = new QHBoxLayout;
    auto* second = new QHBoxLayout;
    column->addLayout(first);
    column->addLayout(second);
    connect(addButton(first, "maskInvert", tr("&Invert"), tr("Paints what is not painted, and nothing else")),
            &QAbstractButton::clicked, this,
            [this] { set([](const Image& now) { return selections::inverted(now); }); });
    connect(addButton(first, "maskClear", tr("Cl&ear"), tr("Takes all away that is painted")),
            &QAbstractButton::clicked, this,
            [this] { set([](const Image& now) { return Image(now.size(), 1); }); });
    addSteps(second);
    return column;
}

} // namespace texloom::ui
