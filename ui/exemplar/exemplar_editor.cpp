#include "ui/exemplar/exemplar_editor.h"

#include "core/base/text.h"
#include "core/session/run/edited_exemplar.h"
#include "ui/common/background.h"
#include "ui/common/elided_label.h"
#include "ui/common/text.h"
#include "ui/common/value_editors.h"
#include "ui/exemplar/edit_list.h"
#include "ui/exemplar/edit_preview.h"
#include "ui/exemplar/frame_page.h"
#include "ui/exemplar/tool_form.h"
#include "ui/paint/brush.h"

#include <QButtonGroup>
#include <QFormLayout>
#include <QGridLayout>
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

namespace {

QLabel* noteLabel(const QString& text) {
    auto* note = new QLabel(text);
    note->setWordWrap(true);
    return note;
}

} // namespace

ExemplarEditor::ExemplarEditor(ExemplarStore* store, QWidget* parent)
    : QWidget(parent), m_store(store), m_canvas(new EditCanvas(this)), m_preview(new EditPreview(this)),
      m_title(new ElidedLabel(this)), m_buttons(new QButtonGroup(this)) {
    setObjectName(QStringLiteral("exemplarEditor"));
    m_canvas->setAccessibleName(tr("Exemplar being edited"));
    QFont bold = font();
    bold.setBold(true);
    m_title->setFont(bold);

    auto* tools = new QWidget;
    auto* column = new QVBoxLayout(tools);
    column->setContentsMargins(0, 0, 0, 0);
    auto* row = new QWidget(tools);
    column->addWidget(row);
    column->addWidget(makePages());
    makeModes(row);
    makeForms(column);
    column->addWidget(makeListGroup(), 1);
    auto* scroll = new QScrollArea(this);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFocusPolicy(Qt::NoFocus);
    scroll->setWidget(tools);
    scroll->setFixedWidth(std::max(tools->minimumSizeHint().width(), fontMetrics().averageCharWidth() * 40) +
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

    connect(m_canvas, &EditCanvas::painted, this, &ExemplarEditor::hidePainted);
    connect(m_store, &ExemplarStore::changed, this, &ExemplarEditor::showCurrent);
    connect(m_store, &ExemplarStore::currentChanged, this, &ExemplarEditor::showCurrent);
    connect(m_store, &ExemplarStore::pendingChanged, this, &ExemplarEditor::showCurrent);
    connect(m_preview, &EditPreview::made, this,
            [this](const std::shared_ptr<const DisplayPicture>& picture) {
                const bool other = m_canvas->picture() && m_canvas->picture()->size() != picture->size();
                m_canvas->setHidden({}); // which is not where it was
                m_canvas->setPicture(picture);
                m_canvas->setBadge(tr("Preview"));
                if (other)
                    m_canvas->resetFrames();
            });
    connect(m_canvas, &EditCanvas::left, this, [this] { setMode(QStringLiteral("look")); });
    connect(m_canvas, &EditCanvas::accepted, this, [this] {
        if (auto* page = qobject_cast<FramePage*>(m_pages->currentWidget()))
            page->apply();
    });
    setMode(QStringLiteral("look"));
    showCurrent();
}

void ExemplarEditor::hidePainted(const QImage& stroke) {
    m_store->paintMask(m_shownId, shapeOf(stroke), m_canvas->mode() == EditCanvas::Mode::Hide);
}

void ExemplarEditor::addMode(QWidget* row, const QString& title, const QString& help, Mode mode) {
    auto* button = new QToolButton(row);
    button->setText(title);
    button->setToolTip(help);
    button->setObjectName(QStringLiteral("mode-%1").arg(mode.name));
    button->setCheckable(true);
    button->setFocusPolicy(Qt::StrongFocus);
    m_buttons->addButton(button, static_cast<int>(m_modes.size()));
    // In rows of three, so that the picture keeps its room.
    constexpr int kColumns = 3;
    const int number = static_cast<int>(m_modes.size());
    qobject_cast<QGridLayout*>(row->layout())->addWidget(button, number / kColumns, number % kColumns);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    m_modes.push_back(std::move(mode));
}

/// A button for looking, one for each tool with a frame, and two for the mask, with their pages.
void ExemplarEditor::makeModes(QWidget* row) {
    auto* layout = new QGridLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    addMode(row, tr("&Look"), tr("Zoom and pan"),
            {QStringLiteral("look"), nullptr, EditCanvas::Mode::Look, m_pages->addWidget(makeLookPage())});
    for (const Tool& tool : tools()) {
        if (!FramePage::suits(tool))
            continue;
        auto* page = new FramePage(tool, m_canvas, m_pages);
        connect(page, &FramePage::applied, this, [this](const Values& edit) {
            append(edit);
            setMode(QStringLiteral("look"));
        });
        addMode(row, translated(tool.info().title), translated(tool.info().summary),
                {QString::fromStdString(tool.id()), &tool, EditCanvas::Mode::Look, m_pages->addWidget(page)});
    }
    const int mask = m_pages->addWidget(makeMaskPage());
    addMode(row, tr("&Hide"), tr("Paint over what is never copied"),
            {QStringLiteral("hide"), nullptr, EditCanvas::Mode::Hide, mask});
    addMode(row, tr("&Unhide"), tr("Paint over what may be copied again"),
            {QStringLiteral("show"), nullptr, EditCanvas::Mode::Show, mask});
    connect(m_buttons, &QButtonGroup::idClicked, this,
            [this](int id) { setMode(m_modes.at(static_cast<std::size_t>(id)).name); });
}

QWidget* ExemplarEditor::makePages() {
    m_pages = new QStackedWidget(this);
    return m_pages;
}

QWidget* ExemplarEditor::makeLookPage() {
    QLabel* const look =
        noteLabel(tr("The wheel zooms, dragging moves. Choose a tool above, or turn, mirror and even "
                     "out the light below. Files stay as they are."));
    look->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    return look;
}

QWidget* ExemplarEditor::makeMaskPage() {
    auto* page = new QWidget;
    auto* form = new QFormLayout(page);
    form->setContentsMargins(0, 0, 0, 0);
    m_brush = makeValueEditor(brushWidth(), page);
    m_brush->setObjectName(QStringLiteral("edit-brush"));
    m_brush->setAccessibleName(translated(brushWidth().title()));
    m_brush->setValue(brushWidth().defaultFor(0));
    form->addRow(translated(brushWidth().title()), m_brush);
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

/// A form for each tool that edits without a frame: those that move pixels first, as in the list of edits.
void ExemplarEditor::makeForms(QLayout* column) {
    for (const bool warps : {true, false})
        for (const Tool& tool : tools()) {
            if (tool.joins() || tool.warps() != warps || FramePage::suits(tool))
                continue;
            auto* form = new ToolForm(tool, column->parentWidget());
            column->addWidget(form);
            m_forms.push_back(form);
            connect(form, &ToolForm::edited, this, [this, form] { adjust(form); });
            connect(form, &ToolForm::added, this, &ExemplarEditor::append);
            connect(form, &ToolForm::beforeToggled, this, &ExemplarEditor::showCurrent);
        }
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

void ExemplarEditor::setMode(const QString& mode) {
    const auto found =
        std::find_if(m_modes.begin(), m_modes.end(), [&](const Mode& known) { return known.name == mode; });
    m_buttons->button(static_cast<int>(found - m_modes.begin()))->setChecked(true);
    m_pages->setCurrentIndex(found->page);
    if (found->tool != nullptr)
        m_canvas->setFrameFor(found->tool->params().front());
    else
        m_canvas->setMode(found->canvas);
    if (auto* page = qobject_cast<FramePage*>(m_pages->currentWidget()))
        page->begin();
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
    const ExemplarEdits wanted = edits();
    showPicture(*entry, wanted);
    m_clearMask->setEnabled(entry->exemplar.mask.has_value());
    if (other)
        m_canvas->resetFrames();
    fillList(wanted, entry->exemplar.edits);
    for (ToolForm* form : m_forms) {
        const std::optional<std::size_t> standing = standingEdit(wanted, form->tool());
        if (form->adjusts())
            form->setEdit(standing ? &wanted[*standing] : nullptr);
    }
}

/// The exemplar as it is, without one of its edits, or, while edits of a large one are made, soon a preview.
void ExemplarEditor::showPicture(const ExemplarEntry& entry, const ExemplarEdits& wanted) {
    const ExemplarEdits& made = entry.exemplar.edits;
    ++m_beforeRequest; // what is still being made shows an earlier state
    if (wanted != made && EditPreview::worthwhile(entry.exemplar.original().image.image->size())) {
        m_preview->make(entry.exemplar, wanted);
        return;
    }
    m_preview->cancel();
    const auto before = std::find_if(m_forms.begin(), m_forms.end(), [&](const ToolForm* form) {
        return form->showsBefore() && standingEdit(made, form->tool());
    });
    if (before != m_forms.end())
        showWithout(*standingEdit(made, (*before)->tool()));
    else
        m_canvas->setPicture(entry.picture);
    m_canvas->setBadge(before != m_forms.end() ? tr("Before") : QString());
    m_canvas->setHidden(entry.hidden);
}

void ExemplarEditor::showWithout(std::size_t index) {
    const ExemplarEntry* const entry = m_store->current();
    ExemplarEdits without = entry->exemplar.edits;
    without.erase(without.begin() + static_cast<std::ptrdiff_t>(index));
    inBackground(
        this,
        [exemplar = entry->exemplar, without] {
            return std::make_shared<const DisplayPicture>(edited(exemplar, without).image.image);
        },
        [this, request = m_beforeRequest](const std::shared_ptr<const DisplayPicture>& picture) {
            if (request == m_beforeRequest)
                m_canvas->setPicture(picture);
        },
        [](const QString&) {});
}

/// What is not made yet is listed at once, and looks like it.
void ExemplarEditor::fillList(const ExemplarEdits& wanted, const ExemplarEdits& made) {
    const int row = m_list->currentRow();
    const QSignalBlocker blocker(m_list);
    m_list->clear();
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        const bool pending = i >= made.size() || wanted[i] != made[i];
        auto* item = new QListWidgetItem(
            pending ? tr("%1 (being made)").arg(editText(wanted[i])) : editText(wanted[i]), m_list);
        QFont font = m_list->font();
        font.setItalic(pending);
        item->setFont(font);
    }
    m_list->setCurrentRow(std::min(row, m_list->count() - 1));
    m_remove->setEnabled(m_list->currentRow() >= 0);
}

void ExemplarEditor::adjust(const ToolForm* form) {
    const Tool& tool = form->tool();
    set(withStanding(edits(), tool, form->edit()), translated(tool.info().title),
        QString::fromStdString(tool.id()));
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
