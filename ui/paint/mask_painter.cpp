#include "ui/paint/mask_painter.h"

#include "core/image/selection.h"
#include "ui/common/background.h"
#include "ui/common/text.h"
#include "ui/common/value_editors.h"
#include "ui/paint/mask_canvas.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QGroupBox>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QShortcut>
#include <QSpinBox>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <utility>

namespace texloom::ui {

namespace {

constexpr int kPainterWidth = 130, kPainterLines = 42; ///< of the dialog, in widths and lines of text
constexpr int kColumnWidth = 40;                       ///< of the tools beside the picture
constexpr int kMostPixels = 256, kFirstPixels = 4;
constexpr double kBrushStep = 1.25;

QLabel* wrappedLabel(const QString& text, QWidget* parent) {
    auto* label = new QLabel(text, parent);
    label->setWordWrap(true);
    label->setTextFormat(Qt::PlainText);
    return label;
}

} // namespace

MaskPainter::MaskPainter(std::shared_ptr<const DisplayPicture> picture, Image selection,
                         const QString& meaning, QWidget* parent)
    : QDialog(parent), m_canvas(new MaskCanvas(this)), m_tools(new QButtonGroup(this)),
      m_takeAway(new QCheckBox(tr("&Take away"), this)), m_brush(makeValueEditor(brushWidth(), this)),
      m_pixels(new QSpinBox(this)), m_problem(wrappedLabel({}, this)),
      m_edits(std::make_shared<SelectionEdits>(std::move(selection))) {
    setObjectName(QStringLiteral("maskPainter"));
    m_canvas->setAccessibleName(tr("Picture that is painted on"));
    m_canvas->setPicture(std::move(picture));
    m_problem->hide();
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    buttons->setObjectName(QStringLiteral("maskButtons"));
    connect(buttons, &QDialogButtonBox::accepted, this, &MaskPainter::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &MaskPainter::reject);
    auto* middle = new QHBoxLayout;
    middle->addWidget(m_canvas, 1);
    middle->addWidget(makeColumn(meaning));
    auto* column = new QVBoxLayout(this);
    column->addLayout(middle, 1);
    column->addWidget(m_problem);
    column->addWidget(buttons);
    connect(m_canvas, &MaskCanvas::stroked, this, [this](const QImage& stroke, bool add) {
        set([stroke, add](const Image& now) { return selections::combined(now, shapeOf(stroke), add); });
    });
    connect(m_canvas, &MaskCanvas::outlined, this, [this](const PlanePoints& corners, bool add) {
        set([corners, add](const Image& now) {
            return selections::combined(now, selections::polygon(now.size(), corners), add);
        });
    });
    makeKeys();
    m_brush->setValue(brushWidth().defaultFor(0));
    m_tools->button(0)->setChecked(true);
    resize(fontMetrics().averageCharWidth() * kPainterWidth, fontMetrics().height() * kPainterLines);
    change([](SelectionEdits&) {}); // shows what is painted already
    m_canvas->setFocus();
}

QWidget* MaskPainter::makeColumn(const QString& meaning) {
    auto* tools = new QWidget(this);
    auto* column = new QVBoxLayout(tools);
    column->setContentsMargins(0, 0, 0, 0);
    column->addLayout(makeTools());
    column->addLayout(makeLegend(meaning));
    column->addLayout(makeEdges());
    column->addLayout(makeWhole());
    column->addStretch();
    column->addWidget(wrappedLabel(
        tr("The wheel zooms, the middle button moves the picture. A double click or Enter closes a polygon. "
           "Alt takes away; [ and ] make the brush smaller and larger. Without a mouse: Shift and the arrow "
           "keys move the cursor, the space bar paints or sets a corner."),
        tools));
    tools->setFixedWidth(
        std::max(tools->minimumSizeHint().width(), fontMetrics().averageCharWidth() * kColumnWidth));
    return tools;
}

QLayout* MaskPainter::makeTools() {
    auto* column = new QVBoxLayout;
    auto* grid = new QGridLayout;
    const std::pair<QString, QString> tools[] = {{tr("&Brush"), tr("Paints where the mouse drags")},
                                                 {tr("&Lasso"), tr("Takes what the mouse drags around")},
                                                 {tr("&Polygon"), tr("Gets a corner at each click")},
                                                 {tr("&Rectangle"), tr("Goes from corner to corner")}};
    const char* const names[] = {"maskBrush", "maskLasso", "maskPolygon", "maskRectangle"};
    for (int i = 0; i < 4; ++i) {
        auto* button = new QToolButton(this);
        button->setObjectName(QLatin1String(names[i]));
        button->setText(tools[i].first);
        button->setToolTip(tools[i].second);
        button->setCheckable(true);
        button->setFocusPolicy(Qt::StrongFocus);
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        m_tools->addButton(button, i);
        grid->addWidget(button, i / 2, i % 2);
    }
    column->addLayout(grid);
    m_takeAway->setObjectName(QStringLiteral("maskTakeAway"));
    m_takeAway->setToolTip(
        tr("Shapes are taken away from what is painted. Alt does the same for one shape."));
    column->addWidget(m_takeAway);
    m_brush->setObjectName(QStringLiteral("maskBrushWidth"));
    auto* form = new QFormLayout;
    form->addRow(tr("&Width"), m_brush);
    column->addLayout(form);
    connect(m_tools, &QButtonGroup::idClicked, this, [this](int id) {
        m_canvas->setTool(static_cast<MaskCanvas::Tool>(id));
        m_canvas->setFocus();
    });
    connect(m_takeAway, &QCheckBox::toggled, m_canvas, &MaskCanvas::setTakesAway);
    connect(m_brush, &ValueEditor::edited, this,
            [this] { m_canvas->setBrushSize(std::get<int>(m_brush->value())); });
    return column;
}

QLayout* MaskPainter::makeLegend(const QString& meaning) {
    auto* row = new QHBoxLayout;
    auto* swatch = new QLabel(this);
    const int side = fontMetrics().height();
    QPixmap pixmap(side, side);
    pixmap.fill(Qt::gray);
    QPainter(&pixmap).fillRect(pixmap.rect(), MaskCanvas::veilColor());
    swatch->setPixmap(pixmap);
    swatch->setAlignment(Qt::AlignTop);
    auto* text = wrappedLabel(
        tr("Painted: black in the mask, lighter where it is softened.") + QLatin1Char(' ') + meaning, this);
    text->setObjectName(QStringLiteral("maskLegend"));
    row->addWidget(swatch);
    row->addWidget(text, 1);
    return row;
}

QAbstractButton* MaskPainter::addButton(QLayout* layout, const char* name, const QString& text,
                                        const QString& help) {
    auto* button = new QPushButton(text, this);
    button->setObjectName(QLatin1String(name));
    button->setToolTip(help);
    button->setAutoDefault(false); // Enter closes shapes, and then the dialog
    layout->addWidget(button);
    return button;
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
    m_undo = addButton(second, "maskUndo", tr("&Undo"), tr("Goes back by a step (Ctrl+Z)"));
    m_redo = addButton(second, "maskRedo", tr("Re&do"), tr("Makes an undone step again (Ctrl+Shift+Z)"));
    for (QAbstractButton* button : {m_undo, m_redo})
        button->setEnabled(false);
    connect(m_undo, &QAbstractButton::clicked, this,
            [this] { change([](SelectionEdits& edits) { edits.undo(); }); });
    connect(m_redo, &QAbstractButton::clicked, this,
            [this] { change([](SelectionEdits& edits) { edits.redo(); }); });
    return column;
}

void MaskPainter::makeKeys() {
    const auto add = [this](const QKeySequence& keys, const std::function<void()>& does) {
        connect(new QShortcut(keys, this), &QShortcut::activated, this, does);
    };
    // Not the buttons' clicks: one that waits for the step before is disabled.
    add(Qt::CTRL | Qt::Key_Z, [this] { change([](SelectionEdits& edits) { edits.undo(); }); });
    for (const QKeySequence& keys :
         {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)})
        add(keys, [this] { change([](SelectionEdits& edits) { edits.redo(); }); });
    add(Qt::Key_BracketLeft, [this] { resizeBrush(1 / kBrushStep); });
    add(Qt::Key_BracketRight, [this] { resizeBrush(kBrushStep); });
}

void MaskPainter::resizeBrush(double factor) {
    const int now = m_canvas->brushSize();
    const int next = static_cast<int>(std::lround(now * factor));
    const int moved = next == now ? now + (factor > 1 ? 1 : -1) : next;
    const Param& width = brushWidth();
    m_brush->setValue(
        std::clamp(moved, static_cast<int>(width.smallest()), static_cast<int>(width.largest())));
    m_canvas->setBrushSize(std::get<int>(m_brush->value()));
}

void MaskPainter::set(const std::function<Image(const Image&)>& make) {
    change([make](SelectionEdits& edits) { edits.set(make(edits.selection())); });
}

void MaskPainter::change(Change change) {
    m_changes.push_back(std::move(change));
    if (m_changes.size() == 1)
        nextChange();
}

void MaskPainter::nextChange() {
    inBackground(
        this,
        [edits = m_edits, change = m_changes.front()] {
            change(*edits);
            return Shown{MaskCanvas::veilOf(edits->selection()), edits->canUndo(), edits->canRedo()};
        },
        [this](const Shown& now) {
            m_problem->hide();
            m_canvas->setVeil(now.veil);
            m_undo->setEnabled(now.undo);
            m_redo->setEnabled(now.redo);
            changeDone();
        },
        [this](const QString& why) {
            m_problem->setText(why);
            m_problem->show();
            m_accepting = false;
            changeDone();
        });
}

void MaskPainter::changeDone() {
    m_changes.pop_front();
    if (!m_changes.empty())
        nextChange();
    else if (m_accepting)
        QDialog::accept();
}

void MaskPainter::accept() {
    m_accepting = true;
    if (!busy())
        QDialog::accept();
}

} // namespace texloom::ui
