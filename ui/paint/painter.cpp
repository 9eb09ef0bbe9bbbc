#include "ui/paint/painter.h"

#include "core/image/selection.h"
#include "ui/common/background.h"
#include "ui/common/text.h"
#include "ui/common/value_editors.h"

#include <QButtonGroup>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QShortcut>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <utility>

namespace texloom::ui {

namespace {

constexpr int kPainterWidth = 130, kPainterLines = 42; ///< of the dialog, in widths and lines of text
constexpr int kColumnWidth = 40;                       ///< of the tools beside the picture
constexpr double kBrushStep = 1.25;

QLabel* wrappedLabel(const QString& text, QWidget* parent) {
    auto* label = new QLabel(text, parent);
    label->setWordWrap(true);
    label->setTextFormat(Qt::PlainText);
    return label;
}

} // namespace

Painter::Painter(std::shared_ptr<const DisplayPicture> picture, Image painted, QWidget* parent)
    : QDialog(parent), m_canvas(new PaintCanvas(this)), m_tools(new QButtonGroup(this)),
      m_toolGrid(new QGridLayout), m_brush(makeValueEditor(brushWidth(), this)),
      m_problem(wrappedLabel({}, this)), m_edits(std::make_shared<SelectionEdits>(std::move(painted))) {
    setObjectName(QStringLiteral("painter"));
    m_canvas->setAccessibleName(tr("Picture that is painted on"));
    m_canvas->setPicture(std::move(picture));
    m_problem->hide();
    addTool(PaintCanvas::Tool::Brush, "paintBrush", tr("&Brush"), tr("Paints where the mouse drags"));
    addTool(PaintCanvas::Tool::Lasso, "paintLasso", tr("&Lasso"), tr("Takes what the mouse drags around"));
    addTool(PaintCanvas::Tool::Polygon, "paintPolygon", tr("&Polygon"), tr("Gets a corner at each click"));
    addTool(PaintCanvas::Tool::Rectangle, "paintRectangle", tr("&Rectangle"),
            tr("Goes from corner to corner"));
    connect(m_canvas, &PaintCanvas::stroked, this, [this](const QImage& stroke, bool add) {
        set(withShape([stroke](Size) { return shapeOf(stroke); }, add));
    });
    connect(m_canvas, &PaintCanvas::outlined, this, [this](const PlanePoints& corners, bool add) {
        set(withShape([corners](Size size) { return selections::polygon(size, corners); }, add));
    });
}

void Painter::build(const std::vector<QLayout*>& parts, const QString& keys) {
    auto* tools = new QWidget(this);
    auto* side = new QVBoxLayout(tools);
    side->setContentsMargins(0, 0, 0, 0);
    side->addLayout(makeTools());
    for (QLayout* part : parts)
        side->addLayout(part);
    side->addStretch();
    side->addWidget(wrappedLabel(keys, tools));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    buttons->setObjectName(QStringLiteral("paintButtons"));
    connect(buttons, &QDialogButtonBox::accepted, this, &Painter::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &Painter::reject);
    auto* middle = new QHBoxLayout;
    middle->addWidget(m_canvas, 1);
    middle->addWidget(tools);
    auto* column = new QVBoxLayout(this);
    column->addLayout(middle, 1);
    column->addWidget(m_problem);
    column->addWidget(buttons);
    tools->setFixedWidth(
        std::max(tools->minimumSizeHint().width(), fontMetrics().averageCharWidth() * kColumnWidth));
    makeKeys();
    m_brush->setValue(brushWidth().defaultFor(0));
    m_tools->button(0)->setChecked(true);
    resize(fontMetrics().averageCharWidth() * kPainterWidth, fontMetrics().height() * kPainterLines);
    showVeil();
    m_canvas->setFocus();
}

void Painter::addTool(PaintCanvas::Tool tool, const char* name, const QString& text, const QString& help) {
    constexpr int kColumns = 2;
    auto* button = new QToolButton(this);
    button->setObjectName(QLatin1String(name));
    button->setText(text);
    button->setToolTip(help);
    button->setCheckable(true);
    button->setFocusPolicy(Qt::StrongFocus);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    connect(button, &QToolButton::toggled, button, [button](bool chosen) {
        QFont font = button->font(); // which is seen whatever the palette
        font.setBold(chosen);
        button->setFont(font);
    });
    const int at = m_toolGrid->count();
    m_tools->addButton(button, static_cast<int>(tool));
    m_toolGrid->addWidget(button, at / kColumns, at % kColumns);
}

void Painter::chooseTool(PaintCanvas::Tool tool) {
    m_tools->button(static_cast<int>(tool))->setChecked(true);
    m_canvas->setTool(tool);
}

QLayout* Painter::makeTools() {
    auto* column = new QVBoxLayout;
    column->addLayout(m_toolGrid);
    m_brush->setObjectName(QStringLiteral("paintBrushWidth"));
    auto* form = new QFormLayout;
    form->addRow(tr("&Width"), m_brush);
    column->addLayout(form);
    connect(m_tools, &QButtonGroup::idClicked, this, [this](int id) {
        m_canvas->setTool(static_cast<PaintCanvas::Tool>(id));
        m_canvas->setFocus();
    });
    connect(m_brush, &ValueEditor::edited, this,
            [this] { m_canvas->setBrushSize(std::get<int>(m_brush->value())); });
    return column;
}

QLayout* Painter::makeLegend(const QPixmap& swatch, const QString& text) {
    auto* row = new QHBoxLayout;
    if (!swatch.isNull()) {
        auto* picture = new QLabel(this);
        picture->setPixmap(swatch);
        picture->setAlignment(Qt::AlignTop);
        row->addWidget(picture);
    }
    auto* label = wrappedLabel(text, this);
    label->setObjectName(QStringLiteral("paintLegend"));
    row->addWidget(label, 1);
    return row;
}

QAbstractButton* Painter::addButton(QLayout* layout, const char* name, const QString& text,
                                    const QString& help) {
    auto* button = new QPushButton(text, this);
    button->setObjectName(QLatin1String(name));
    button->setToolTip(help);
    button->setAutoDefault(false); // Enter closes shapes, and then the dialog
    layout->addWidget(button);
    return button;
}

void Painter::addSteps(QLayout* layout) {
    m_undo = addButton(layout, "paintUndo", tr("&Undo"), tr("Goes back by a step (Ctrl+Z)"));
    m_redo = addButton(layout, "paintRedo", tr("Re&do"), tr("Makes an undone step again (Ctrl+Shift+Z)"));
    for (QAbstractButton* button : {m_undo, m_redo})
        button->setEnabled(false);
    connect(m_undo, &QAbstractButton::clicked, this, &Painter::stepBack);
    connect(m_redo, &QAbstractButton::clicked, this, &Painter::stepOn);
}

void Painter::addKey(const QKeySequence& keys, const std::function<void()>& does) {
    connect(new QShortcut(keys, this), &QShortcut::activated, this, does);
}

void Painter::makeKeys() {
    // Not the buttons' clicks: one that waits for the step before is disabled.
    addKey(Qt::CTRL | Qt::Key_Z, [this] { stepBack(); });
    for (const QKeySequence& keys :
         {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)})
        addKey(keys, [this] { stepOn(); });
    addKey(Qt::Key_BracketLeft, [this] { resizeBrush(1 / kBrushStep); });
    addKey(Qt::Key_BracketRight, [this] { resizeBrush(kBrushStep); });
}

void Painter::resizeBrush(double factor) {
    const int now = m_canvas->brushSize();
    const int next = static_cast<int>(std::lround(now * factor));
    const int moved = next == now ? now + (factor > 1 ? 1 : -1) : next;
    const Param& width = brushWidth();
    m_brush->setValue(
        std::clamp(moved, static_cast<int>(width.smallest()), static_cast<int>(width.largest())));
    m_canvas->setBrushSize(std::get<int>(m_brush->value()));
}

void Painter::stepBack() {
    change({[](SelectionEdits& edits) { edits.undo(); }});
}

void Painter::stepOn() {
    change({[](SelectionEdits& edits) { edits.redo(); }});
}

void Painter::set(const Make& make) {
    change({[make](SelectionEdits& edits) { edits.set(make(edits.selection())); }});
}

void Painter::showVeil() {
    change({[](SelectionEdits&) {}});
}

void Painter::read(const std::function<void(const Image& now)>& done) {
    change({[](SelectionEdits&) {}, done});
}

void Painter::change(Change change) {
    m_changes.push_back(std::move(change));
    if (m_changes.size() == 1)
        nextChange();
}

void Painter::nextChange() {
    inBackground(
        this,
        [edits = m_edits, make = m_changes.front().make, veil = veil()] {
            make(*edits);
            return Shown{veil(edits->selection()), edits->canUndo(), edits->canRedo()};
        },
        [this](const Shown& now) {
            m_problem->hide();
            m_canvas->setVeil(now.veil);
            m_undo->setEnabled(now.undo);
            m_redo->setEnabled(now.redo);
            m_changed = now.undo;
            m_changes.front().done(painted());
            changeDone();
        },
        [this](const QString& why) {
            m_problem->setText(why);
            m_problem->show();
            m_accepting = false;
            changeDone();
        });
}

void Painter::changeDone() {
    m_changes.pop_front();
    if (!m_changes.empty())
        nextChange();
    else if (m_accepting)
        QDialog::accept();
}

void Painter::accept() {
    m_accepting = true;
    if (!busy())
        QDialog::accept();
}

void Painter::reject() {
    if (!changed() || !isVisible())
        return QDialog::reject();
    auto* box =
        new QMessageBox(QMessageBox::Question, tr("Painted and not kept"),
                        tr("What you painted is lost unless you keep it."), QMessageBox::NoButton, this);
    box->setObjectName(QStringLiteral("paintLoss"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    QPushButton* const keep = box->addButton(tr("&Keep"), QMessageBox::AcceptRole);
    QPushButton* const discard = box->addButton(tr("&Discard"), QMessageBox::DestructiveRole);
    QPushButton* const back = box->addButton(tr("&Go on painting"), QMessageBox::RejectRole);
    box->setDefaultButton(keep);
    box->setEscapeButton(back);
    connect(keep, &QPushButton::clicked, this, &Painter::accept);
    connect(discard, &QPushButton::clicked, this, [this] { QDialog::reject(); });
    box->open();
}

} // namespace texloom::ui
