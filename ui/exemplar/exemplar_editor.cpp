#include "ui/exemplar/exemplar_editor.h"

#include "core/session/run/edited_exemplar.h"
#include "ui/common/background.h"
#include "ui/common/elided_label.h"
#include "ui/common/text.h"
#include "ui/common/value_editor.h"
#include "ui/exemplar/edit_fields.h"
#include "ui/exemplar/edit_list.h"
#include "ui/exemplar/frame_pages.h"
#include "ui/exemplar/light_group.h"

#include <QButtonGroup>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QStackedWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace texloom::ui {

ExemplarEditor::ExemplarEditor(ExemplarStore* store, QWidget* parent)
    : QWidget(parent), m_store(store), m_canvas(new EditCanvas(this)), m_title(new ElidedLabel(this)),
      m_tools(new QButtonGroup(this)) {
    setObjectName(QStringLiteral("exemplarEditor"));
    m_canvas->setAccessibleName(tr("Exemplar being edited"));
    QFont bold = font();
    bold.setBold(true);
    m_title->setFont(bold);

    auto* tools = new QWidget;
    auto* column = new QVBoxLayout(tools);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(makeToolRow());
    column->addWidget(makeToolPages());
    column->addWidget(makeTurnGroup());
    m_light = new LightGroup(tools);
    column->addWidget(m_light);
    column->addWidget(makeListGroup(), 1);
    auto* scroll = new QScrollArea(this);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFocusPolicy(Qt::NoFocus);
    scroll->setWidget(tools);
    scroll->setFixedWidth(std::max(tools->sizeHint().width(), fontMetrics().averageCharWidth() * 44) +
                          scroll->verticalScrollBar()->sizeHint().width());
    auto* done = new QPushButton(tr("&Done"), this);
    done->setObjectName(QStringLiteral("editDone"));
    connect(done, &QPushButton::clicked, this, &ExemplarEditor::done);

    auto* top = new QHBoxLayout;
    top->addWidget(m_title, 1);
    top->addWidget(done);
    auto* middle = new QHBoxLayout;
    middle->addWidget(m_canvas, 1);
    middle->addWidget(scroll);
    auto* whole = new QVBoxLayout(this);
    whole->setContentsMargins(0, 0, 0, 0);
    whole->addLayout(top);
    whole->addLayout(middle, 1);

    connect(m_light, &LightGroup::edited, this, [this] {
        set(withLight(edits(), m_light->light()), tr("Even out the light"), QStringLiteral("light"));
    });
    connect(m_light, &LightGroup::beforeToggled, this, &ExemplarEditor::showCurrent);
    connect(m_canvas, &EditCanvas::painted, this, [this](const QImage& stroke) {
        Image painted({stroke.width(), stroke.height()}, 1);
        for (int y = 0; y < stroke.height(); ++y)
            for (int x = 0; x < stroke.width(); ++x)
                painted(x, y, 0) = stroke.constScanLine(y)[x] != 0 ? 1.0F : 0.0F;
        m_store->paintMask(m_shownId, std::move(painted), m_canvas->tool() == EditCanvas::Tool::Hide);
    });
    connect(m_store, &ExemplarStore::changed, this, &ExemplarEditor::showCurrent);
    connect(m_store, &ExemplarStore::currentChanged, this, &ExemplarEditor::showCurrent);
    setTool(EditCanvas::Tool::Look);
    showCurrent();
}

QWidget* ExemplarEditor::makeToolRow() {
    auto* row = new QWidget(this);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    const std::tuple<EditCanvas::Tool, QString, QString, const char*> tools[] = {
        {EditCanvas::Tool::Look, tr("&Look"), tr("Zoom and pan"), "toolLook"},
        {EditCanvas::Tool::Crop, tr("&Crop"), tr("Keep a rectangle of the exemplar"), "toolCrop"},
        {EditCanvas::Tool::Rectify, tr("Re&ctify"),
         tr("Make a rectangle of a surface that was photographed at a slant"), "toolRectify"},
        {EditCanvas::Tool::Hide, tr("&Hide"), tr("Paint over what is never copied"), "toolHide"},
        {EditCanvas::Tool::Show, tr("&Unhide"), tr("Paint over what may be copied again"), "toolShow"}};
    for (const auto& [tool, text, help, name] : tools) {
        auto* button = new QToolButton(row);
        button->setText(text);
        button->setToolTip(help);
        button->setObjectName(QLatin1String(name));
        button->setCheckable(true);
        button->setFocusPolicy(Qt::StrongFocus);
        m_tools->addButton(button, static_cast<int>(tool));
        layout->addWidget(button, 1);
    }
    connect(m_tools, &QButtonGroup::idClicked, this,
            [this](int id) { setTool(static_cast<EditCanvas::Tool>(id)); });
    return row;
}

QWidget* ExemplarEditor::makeToolPages() {
    m_pages = new QStackedWidget(this);
    auto* look =
        new QLabel(tr("The wheel zooms, dragging moves. Choose a tool above, or turn, mirror and even "
                      "out the light below. Files stay as they are."),
                   m_pages);
    look->setWordWrap(true);
    look->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    m_pages->addWidget(look);
    auto* crop = new CropPage(m_canvas, m_pages);
    auto* corners = new CornersPage(m_canvas, m_pages);
    connect(crop, &CropPage::applied, this, [this] {
        const QRect frame = m_canvas->cropFrame();
        applyFrame(CropEdit{{frame.x(), frame.y(), {frame.width(), frame.height()}}});
    });
    connect(corners, &CornersPage::applied, this, [this] {
        applyFrame(RectifyEdit{m_canvas->corners(), {}});
    });
    m_pages->addWidget(crop);
    m_pages->addWidget(corners);
    m_pages->addWidget(makeMaskPage());
    return m_pages;
}

QWidget* ExemplarEditor::makeMaskPage() {
    auto* page = new QWidget;
    auto* form = new QFormLayout(page);
    form->setContentsMargins(0, 0, 0, 0);
    m_brush = editorFor("brush", page);
    addEditorRow(form, "brush", m_brush);
    form->addRow(
        noteLabel(tr("Hatched = never copied. Shift and the arrow keys move the brush, the space bar "
                     "dabs.")));
    m_maskNote = noteLabel(tr("The method in use does not use a mask."));
    form->addRow(m_maskNote);
    m_clearMask = new QPushButton(tr("Clear &mask"), page);
    m_clearMask->setObjectName(QStringLiteral("editClearMask"));
    form->addRow(m_clearMask);
    connect(m_brush, &ValueEditor::edited, this,
            [this] { m_canvas->setBrushSize(std::get<int>(m_brush->value())); });
    connect(m_clearMask, &QPushButton::clicked, this, [this] { m_store->clearMask(m_shownId); });
    return page;
}

QWidget* ExemplarEditor::makeTurnGroup() {
    auto* group = new QGroupBox(tr("Turn and mirror"), this);
    auto* form = new QFormLayout(group);
    m_angle = editorFor("angle", group);
    addEditorRow(form, "angle", m_angle);
    auto* row = new QWidget(group);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    const auto add = [&](const QString& text, const QString& help, const char* name, auto onClick) {
        auto* button = new QToolButton(row);
        button->setText(text);
        button->setToolTip(help);
        button->setAccessibleName(help);
        button->setObjectName(QLatin1String(name));
        button->setFocusPolicy(Qt::StrongFocus);
        connect(button, &QToolButton::clicked, this, onClick);
        layout->addWidget(button, 1);
    };
    add(tr("↺ 90°"), tr("Turn left by 90°"), "turnLeft", [this] { append(RotateEdit{-90}); });
    add(tr("↻ 90°"), tr("Turn right by 90°"), "turnRight", [this] { append(RotateEdit{90}); });
    add(tr("↔"), tr("Mirror left to right"), "mirrorAcross",
        [this] { append(FlipEdit{FlipEdit::Axis::Horizontal}); });
    add(tr("↕"), tr("Mirror top to bottom"), "mirrorDown",
        [this] { append(FlipEdit{FlipEdit::Axis::Vertical}); });
    form->addRow(row);
    connect(m_angle, &ValueEditor::edited, this,
            [this] { set(withAngle(edits(), realOf(*m_angle)), tr("Turn"), QStringLiteral("angle")); });
    return group;
}

QWidget* ExemplarEditor::makeListGroup() {
    auto* group = new QGroupBox(tr("Edits, in order"), this);
    auto* column = new QVBoxLayout(group);
    m_list = new QListWidget(group);
    m_list->setObjectName(QStringLiteral("editList"));
    m_list->setAccessibleName(tr("Edits, in order"));
    m_list->setMinimumHeight(fontMetrics().lineSpacing() * 4);
    m_remove = new QPushButton(tr("&Take back"), group);
    m_remove->setObjectName(QStringLiteral("removeEdit"));
    m_remove->setToolTip(tr("Takes the chosen edit out; those after it stay where they fit."));
    column->addWidget(m_list, 1);
    column->addWidget(m_remove, 0, Qt::AlignRight);
    connect(m_list, &QListWidget::currentRowChanged, this,
            [this](int row) { m_remove->setEnabled(row >= 0); });
    connect(m_remove, &QPushButton::clicked, this, [this] { removeEdit(m_list->currentRow()); });
    return group;
}

void ExemplarEditor::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    showCurrent();
    m_canvas->setFocus();
}

void ExemplarEditor::setTool(EditCanvas::Tool tool) {
    m_tools->button(static_cast<int>(tool))->setChecked(true);
    m_pages->setCurrentIndex(std::min(static_cast<int>(tool), 3));
    m_canvas->setTool(tool);
    m_canvas->resetFrames();
    m_canvas->setFocus();
}

void ExemplarEditor::setMaskUsed(bool used) {
    m_maskNote->setVisible(!used);
}

ExemplarEdits ExemplarEditor::edits() const {
    return m_store->wantedEdits(m_shownId);
}

void ExemplarEditor::set(const ExemplarEdits& edits, const QString& what, const QString& key) {
    m_store->setEdits(m_shownId, edits, what, key);
}

void ExemplarEditor::showCurrent() {
    const ExemplarEntry* const entry = m_store->current();
    setEnabled(entry != nullptr);
    if (!isVisible() || entry == nullptr)
        return;
    const bool other = m_shownId != entry->id ||
                       (m_canvas->picture() && m_canvas->picture()->size() != entry->picture->size());
    m_shownId = entry->id;
    m_title->setFullText(
        tr("%1 · %2 px")
            .arg(toQString(entry->file().path.filename()), sizeText(entry->file().image->size())));
    const ExemplarEdits& made = entry->exemplar.edits;
    const bool before = m_light->showsBefore() && lightOf(made) != nullptr;
    if (before)
        showBeforeLight();
    else
        m_canvas->setPicture(entry->picture);
    m_canvas->setBadge(before ? tr("Before") : QString());
    m_canvas->setHidden(entry->hidden);
    m_clearMask->setEnabled(entry->exemplar.mask.has_value());
    if (other)
        m_canvas->resetFrames();
    fillList(made);
    m_light->setLight(lightOf(made));
}

void ExemplarEditor::showBeforeLight() {
    const ExemplarEntry* const entry = m_store->current();
    ExemplarEdits without = entry->exemplar.edits;
    without.pop_back();
    inBackground(
        this,
        [exemplar = entry->exemplar, without] {
            return std::make_shared<const DisplayPicture>(edited(exemplar, without).image.image);
        },
        [this, request = ++m_beforeRequest](const std::shared_ptr<const DisplayPicture>& picture) {
            if (request == m_beforeRequest && m_light->showsBefore())
                m_canvas->setPicture(picture);
        },
        [](const QString&) {});
}

void ExemplarEditor::fillList(const ExemplarEdits& edits) {
    const int row = m_list->currentRow();
    const QSignalBlocker blocker(m_list);
    m_list->clear();
    for (const ExemplarEdit& edit : edits)
        m_list->addItem(editText(edit));
    m_list->setCurrentRow(std::min(row, m_list->count() - 1));
    m_remove->setEnabled(m_list->currentRow() >= 0);
    m_angle->setValue(angleOf(edits));
}

void ExemplarEditor::applyFrame(const ExemplarEdit& edit) {
    append(edit);
    setTool(EditCanvas::Tool::Look);
}

void ExemplarEditor::append(const ExemplarEdit& edit) {
    set(withEdit(edits(), edit), editText(edit));
}

void ExemplarEditor::removeEdit(int index) {
    ExemplarEdits changed = edits();
    if (index < 0 || index >= static_cast<int>(changed.size()))
        return;
    changed.erase(changed.begin() + index);
    set(changed, tr("Take back an edit"));
}

} // namespace texloom::ui
