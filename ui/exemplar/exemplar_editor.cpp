#include "ui/exemplar/exemplar_editor.h"

#include "core/base/param.h"
#include "core/base/text.h"
#include "core/session/edited_exemplar.h"
#include "ui/inspector/value_editor.h"
#include "ui/jobs/background.h"
#include "ui/window/elided_label.h"
#include "ui/window/icons.h"
#include "ui/window/text.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QStackedWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace texloom::ui {

namespace {

/// What the page's sliders set.
struct Fields {
    double angle = 0;
    FlattenEdit::Model model = FlattenEdit::Model::Smooth;
    double width = 0.25;
    int order = 2;
    double strength = 1;
    int brush = 32;
};

const std::vector<Param>& fields() {
    static const std::vector<Param> all = {
        field(&Fields::angle, "angle", TR("Angle")).range(-45, 45).unit("°"),
        field(&Fields::model, "model", TR("Light"))
            .choices({{"smooth", TR("Soft changes")}, {"polynomial", TR("One slope over all")}}),
        field(&Fields::width, "width", TR("Softness")).range(0.02, 1),
        field(&Fields::order, "order", TR("Bends")).range(1, 4),
        field(&Fields::strength, "strength", TR("Strength")).range(0, 1),
        field(&Fields::brush, "brush", TR("Brush")).range(1, 512).unit("px")};
    return all;
}

const Param& fieldNamed(const char* name) {
    return *std::find_if(fields().begin(), fields().end(),
                         [=](const Param& param) { return param.name() == name; });
}

ValueEditor* editorFor(const char* name, QWidget* parent) {
    const Param& param = fieldNamed(name);
    ValueEditor* const editor = makeValueEditor(param, parent);
    editor->setObjectName(QStringLiteral("edit-%1").arg(QLatin1String(name)));
    editor->setAccessibleName(translated(param.title()));
    editor->setValue(param.defaultFor(0));
    return editor;
}

QLabel* addRow(QFormLayout* form, const char* name, ValueEditor* editor) {
    auto* label = new QLabel(translated(fieldNamed(name).title()));
    label->setBuddy(editor);
    form->addRow(label, editor);
    return label;
}

bool isQuarterTurn(double degrees) {
    return std::fmod(degrees, 90) == 0;
}

/// The flattening among edits; they hold at most one, the last.
const FlattenEdit* lightOf(const ExemplarEdits& edits) {
    return edits.empty() ? nullptr : std::get_if<FlattenEdit>(&edits.back());
}

/// The angle that the slider stands for: a turn that is no quarter, last but for the light.
RotateEdit* angleOf(ExemplarEdits& edits) {
    const std::size_t light = lightOf(edits) != nullptr ? 1 : 0;
    if (edits.size() <= light)
        return nullptr;
    auto* rotation = std::get_if<RotateEdit>(&edits[edits.size() - 1 - light]);
    return rotation != nullptr && !isQuarterTurn(rotation->degrees) ? rotation : nullptr;
}

struct EditText {
    QString operator()(const CropEdit& edit) const {
        return ExemplarEditor::tr("Cropped to %1 at %2, %3")
            .arg(sizeText(edit.area.size))
            .arg(edit.area.x)
            .arg(edit.area.y);
    }
    QString operator()(const RotateEdit& edit) const {
        return ExemplarEditor::tr("Turned by %1°").arg(edit.degrees);
    }
    QString operator()(const FlipEdit& edit) const {
        return edit.axis == FlipEdit::Axis::Horizontal ? ExemplarEditor::tr("Mirrored left to right")
                                                       : ExemplarEditor::tr("Mirrored top to bottom");
    }
    QString operator()(const RectifyEdit&) const { return ExemplarEditor::tr("Rectified by four corners"); }
    QString operator()(const FlattenEdit& edit) const {
        return ExemplarEditor::tr("Light evened out by %1 %").arg(std::lround(edit.strength * 100));
    }
};

} // namespace

QString editText(const ExemplarEdit& edit) {
    return std::visit(EditText{}, edit);
}

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
    column->addWidget(makeLightGroup());
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

    connect(m_canvas, &EditCanvas::frameMoved, this, &ExemplarEditor::showFrame);
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

QSpinBox* ExemplarEditor::makePixels(const QString& name, const QString& label) {
    auto* pixels = new QSpinBox(this);
    pixels->setObjectName(name);
    pixels->setAccessibleName(label);
    pixels->setRange(0, 65535);
    pixels->setKeyboardTracking(false);
    return pixels;
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
    m_pages->addWidget(makeCropPage());
    m_pages->addWidget(makeRectifyPage());
    m_pages->addWidget(makeMaskPage());
    return m_pages;
}

namespace {

QWidget* pairOf(QWidget* first, QWidget* second) {
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(first, 1);
    layout->addWidget(second, 1);
    return row;
}

QLabel* noteLabel(const QString& text) {
    auto* note = new QLabel(text);
    note->setWordWrap(true);
    return note;
}

} // namespace

QWidget* ExemplarEditor::makeCropPage() {
    auto* page = new QWidget;
    auto* form = new QFormLayout(page);
    form->setContentsMargins(0, 0, 0, 0);
    m_cropX = makePixels(QStringLiteral("cropX"), tr("Left edge of the crop"));
    m_cropY = makePixels(QStringLiteral("cropY"), tr("Upper edge of the crop"));
    m_cropWidth = makePixels(QStringLiteral("cropWidth"), tr("Width of the crop"));
    m_cropHeight = makePixels(QStringLiteral("cropHeight"), tr("Height of the crop"));
    form->addRow(tr("Left, top"), pairOf(m_cropX, m_cropY));
    form->addRow(tr("Width, height"), pairOf(m_cropWidth, m_cropHeight));
    auto* apply = new QPushButton(tr("Cr&op"), page);
    apply->setObjectName(QStringLiteral("applyCrop"));
    form->addRow(noteLabel(tr("Drag the corners; N takes the next one, the arrow keys move it.")));
    form->addRow(apply);
    for (QSpinBox* pixels : {m_cropX, m_cropY, m_cropWidth, m_cropHeight})
        connect(pixels, &QSpinBox::valueChanged, this, &ExemplarEditor::takeCropFields);
    connect(apply, &QPushButton::clicked, this, &ExemplarEditor::applyFrame);
    return page;
}

QWidget* ExemplarEditor::makeRectifyPage() {
    auto* page = new QWidget;
    auto* form = new QFormLayout(page);
    form->setContentsMargins(0, 0, 0, 0);
    const QString names[] = {tr("Top left"), tr("Top right"), tr("Bottom right"), tr("Bottom left")};
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t axis = 0; axis < 2; ++axis) {
            QSpinBox* const pixels = makePixels(
                QStringLiteral("corner%1%2").arg(i).arg(axis == 0 ? QLatin1Char('x') : QLatin1Char('y')),
                axis == 0 ? tr("%1 corner, across").arg(names[i]) : tr("%1 corner, down").arg(names[i]));
            m_corners[2 * i + axis] = pixels;
            connect(pixels, &QSpinBox::valueChanged, this, &ExemplarEditor::takeCornerFields);
        }
        form->addRow(names[i], pairOf(m_corners[2 * i], m_corners[2 * i + 1]));
    }
    auto* apply = new QPushButton(tr("Recti&fy"), page);
    apply->setObjectName(QStringLiteral("applyRectify"));
    form->addRow(
        noteLabel(tr("Put the corners on four that are a rectangle in reality. N takes the next one, "
                     "the arrow keys move it.")));
    form->addRow(apply);
    connect(apply, &QPushButton::clicked, this, &ExemplarEditor::applyFrame);
    return page;
}

QWidget* ExemplarEditor::makeMaskPage() {
    auto* page = new QWidget;
    auto* form = new QFormLayout(page);
    form->setContentsMargins(0, 0, 0, 0);
    m_brush = editorFor("brush", page);
    addRow(form, "brush", m_brush);
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
    addRow(form, "angle", m_angle);
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
    add(tr("↺ 90°"), tr("Turn left by 90°"), "turnLeft", [this] { turn(-90); });
    add(tr("↻ 90°"), tr("Turn right by 90°"), "turnRight", [this] { turn(90); });
    add(tr("↔"), tr("Mirror left to right"), "mirrorAcross", [this] { mirror(FlipEdit::Axis::Horizontal); });
    add(tr("↕"), tr("Mirror top to bottom"), "mirrorDown", [this] { mirror(FlipEdit::Axis::Vertical); });
    form->addRow(row);
    connect(m_angle, &ValueEditor::edited, this, [this] {
        const Value angle = m_angle->value();
        setAngle(std::holds_alternative<int>(angle) ? std::get<int>(angle) : std::get<double>(angle));
    });
    return group;
}

QGroupBox* ExemplarEditor::makeLightGroup() {
    m_light = new QGroupBox(tr("Even out the light"), this);
    m_light->setObjectName(QStringLiteral("editLight"));
    m_light->setCheckable(true);
    m_light->setChecked(false);
    m_light->setToolTip(
        tr("Takes slow changes of brightness out of the colours, so that parts from light and "
           "dark places match."));
    auto* form = new QFormLayout(m_light);
    m_model = editorFor("model", m_light);
    m_strength = editorFor("strength", m_light);
    m_width = editorFor("width", m_light);
    m_order = editorFor("order", m_light);
    m_width->setToolTip(tr("Width of the window that finds the light, in shares of the shorter side: larger "
                           "leaves more of the texture's own shades."));
    m_order->setToolTip(tr("How often the light may bend over the exemplar: 1 is a plain slope."));
    addRow(form, "model", m_model);
    addRow(form, "strength", m_strength);
    m_widthLabel = addRow(form, "width", m_width);
    m_orderLabel = addRow(form, "order", m_order);
    m_withoutLight = new QCheckBox(tr("Show &before"), m_light);
    m_withoutLight->setObjectName(QStringLiteral("showBefore"));
    form->addRow(m_withoutLight);
    connect(m_light, &QGroupBox::toggled, this, &ExemplarEditor::lightEdited);
    for (ValueEditor* editor : {m_model, m_width, m_order, m_strength})
        connect(editor, &ValueEditor::edited, this, &ExemplarEditor::lightEdited);
    connect(m_withoutLight, &QCheckBox::toggled, this, &ExemplarEditor::showCurrent);
    return m_light;
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
    const ExemplarEdits made = entry->exemplar.edits;
    if (m_withoutLight->isChecked() && lightOf(made) != nullptr)
        showBeforeLight();
    else
        m_canvas->setPicture(entry->picture);
    m_canvas->setBadge(m_withoutLight->isChecked() && lightOf(made) != nullptr ? tr("Before") : QString());
    m_canvas->setHidden(entry->hidden);
    m_clearMask->setEnabled(entry->exemplar.mask.has_value());
    if (other)
        m_canvas->resetFrames();
    fillList(made);
    showLight(made);
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
            if (request == m_beforeRequest && m_withoutLight->isChecked())
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
    ExemplarEdits copy = edits;
    const RotateEdit* const angle = angleOf(copy);
    const double shown = angle != nullptr ? angle->degrees : 0;
    m_angle->setValue(shown);
}

void ExemplarEditor::showLight(const ExemplarEdits& edits) {
    m_filling = true;
    const FlattenEdit* const light = lightOf(edits);
    m_light->setChecked(light != nullptr);
    if (light != nullptr) {
        const bool smooth = light->model == FlattenEdit::Model::Smooth;
        m_model->setValue(std::string(smooth ? "smooth" : "polynomial"));
        m_width->setValue(light->width);
        m_order->setValue(light->order);
        m_strength->setValue(light->strength);
    }
    const bool smooth = std::get<std::string>(m_model->value()) == "smooth";
    for (QWidget* widget : {static_cast<QWidget*>(m_width), static_cast<QWidget*>(m_widthLabel)})
        widget->setVisible(smooth);
    for (QWidget* widget : {static_cast<QWidget*>(m_order), static_cast<QWidget*>(m_orderLabel)})
        widget->setVisible(!smooth);
    m_filling = false;
}

void ExemplarEditor::showFrame() {
    const QRect frame = m_canvas->cropFrame();
    const std::pair<QSpinBox*, int> crop[] = {{m_cropX, frame.x()},
                                              {m_cropY, frame.y()},
                                              {m_cropWidth, frame.width()},
                                              {m_cropHeight, frame.height()}};
    for (const auto& [pixels, value] : crop) {
        const QSignalBlocker blocker(pixels);
        pixels->setValue(value);
    }
    for (std::size_t i = 0; i < m_corners.size(); ++i) {
        const PlanePoint& corner = m_canvas->corners()[i / 2];
        const QSignalBlocker blocker(m_corners[i]);
        m_corners[i]->setValue(static_cast<int>(std::lround(i % 2 == 0 ? corner.x : corner.y)));
    }
}

void ExemplarEditor::takeCropFields() {
    if (!m_canvas->picture())
        return;
    const Size size = m_canvas->picture()->size();
    const int x = std::clamp(m_cropX->value(), 0, size.width - 1);
    const int y = std::clamp(m_cropY->value(), 0, size.height - 1);
    m_canvas->setCropFrame({x, y, std::clamp(m_cropWidth->value(), 1, size.width - x),
                            std::clamp(m_cropHeight->value(), 1, size.height - y)});
    showFrame();
}

void ExemplarEditor::takeCornerFields() {
    std::array<PlanePoint, 4> corners;
    for (std::size_t i = 0; i < corners.size(); ++i)
        corners[i] = {static_cast<double>(m_corners[2 * i]->value()),
                      static_cast<double>(m_corners[2 * i + 1]->value())};
    m_canvas->setCorners(corners);
}

void ExemplarEditor::applyFrame() {
    const QRect frame = m_canvas->cropFrame();
    if (m_canvas->tool() == EditCanvas::Tool::Crop)
        append(CropEdit{{frame.x(), frame.y(), {frame.width(), frame.height()}}});
    else
        append(RectifyEdit{m_canvas->corners(), {}});
    setTool(EditCanvas::Tool::Look);
}

void ExemplarEditor::append(const ExemplarEdit& edit) {
    ExemplarEdits changed = edits();
    const auto end = lightOf(changed) != nullptr ? changed.end() - 1 : changed.end();
    changed.insert(end, edit);
    set(changed, editText(edit));
}

void ExemplarEditor::turn(double degrees) {
    append(RotateEdit{degrees});
}

void ExemplarEditor::mirror(FlipEdit::Axis axis) {
    append(FlipEdit{axis});
}

void ExemplarEditor::setAngle(double degrees) {
    ExemplarEdits changed = edits();
    RotateEdit* const angle = angleOf(changed);
    const QString key = QStringLiteral("angle");
    if (angle != nullptr && degrees != 0) {
        angle->degrees = degrees;
    } else if (angle != nullptr) {
        changed.erase(changed.end() - (lightOf(changed) != nullptr ? 2 : 1));
    } else if (degrees != 0) {
        changed.insert(lightOf(changed) != nullptr ? changed.end() - 1 : changed.end(), RotateEdit{degrees});
    }
    set(changed, tr("Turn"), key);
}

void ExemplarEditor::lightEdited() {
    if (m_filling)
        return;
    const auto real = [](const ValueEditor* editor) {
        const Value value = editor->value();
        return std::holds_alternative<int>(value) ? std::get<int>(value) : std::get<double>(value);
    };
    ExemplarEdits changed = edits();
    if (lightOf(changed) != nullptr)
        changed.pop_back();
    if (m_light->isChecked()) {
        const bool smooth = std::get<std::string>(m_model->value()) == "smooth";
        changed.emplace_back(FlattenEdit{smooth ? FlattenEdit::Model::Smooth : FlattenEdit::Model::Polynomial,
                                         real(m_width), std::get<int>(m_order->value()), real(m_strength)});
    }
    set(changed, tr("Even out the light"), QStringLiteral("light"));
}

void ExemplarEditor::removeEdit(int index) {
    ExemplarEdits changed = edits();
    if (index < 0 || index >= static_cast<int>(changed.size()))
        return;
    changed.erase(changed.begin() + index);
    set(changed, tr("Take back an edit"));
}

} // namespace texloom::ui
