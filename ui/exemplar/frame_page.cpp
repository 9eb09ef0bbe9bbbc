#include "ui/exemplar/frame_page.h"

#include "ui/common/text.h"
#include "ui/common/value_editors.h"
#include "ui/exemplar/edit_canvas.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>

#include <utility>

namespace texloom::ui {

bool FramePage::suits(const Tool& tool) {
    const Param::Type type = tool.params().front().type();
    return !tool.joins() && (type == Param::Type::Area || type == Param::Type::Points);
}

FramePage::FramePage(const Tool& tool, EditCanvas* canvas, QWidget* parent)
    : QWidget(parent), m_tool(tool), m_canvas(canvas) {
    auto* form = new QFormLayout(this);
    form->setContentsMargins(0, 0, 0, 0);
    for (const Param& param : tool.params()) {
        ValueEditor* const editor = makeValueEditor(param, this);
        editor->setObjectName(QStringLiteral("edit-%1").arg(QString::fromStdString(param.name())));
        editor->setToolTip(translated(param.help()));
        editor->setValue(param.defaultFor(0));
        if (m_editors.empty())
            form->addRow(editor);
        else
            form->addRow(translated(param.title()), editor);
        m_editors.push_back(editor);
    }
    const bool area = tool.params().front().type() == Param::Type::Area;
    if (area)
        form->addRow(tr("R&atio"), makeRatios());
    auto* note = new QLabel(
        translated(tool.params().front().help()) + QLatin1Char(' ') +
        (area
             ? tr("Draw a rectangle, drag its edges or drag it as a whole; Shift makes a square. N takes the "
                  "next corner, the arrow keys move it. Enter applies, Esc leaves.")
             : tr("Drag the corners; N takes the next one, the arrow keys move it. Enter applies, Esc "
                  "leaves.")));
    note->setWordWrap(true);
    form->addRow(note);
    const QString name = QString::fromStdString(tool.id());
    auto* apply = new QPushButton(translated(tool.info().title), this);
    apply->setObjectName(QStringLiteral("apply-%1").arg(name));
    form->addRow(apply);
    connect(apply, &QPushButton::clicked, this, [this] { Q_EMIT applied(edit()); });
    connect(m_editors.front(), &ValueEditor::edited, this, [this] {
        m_canvas->setFrame(m_editors.front()->value());
        showFrame();
    });
    connect(canvas, &EditCanvas::frameMoved, this, &FramePage::showFrame);
}

QComboBox* FramePage::makeRatios() {
    m_ratios = new QComboBox(this);
    m_ratios->setObjectName(QStringLiteral("ratio-%1").arg(QString::fromStdString(m_tool.id())));
    m_ratios->setToolTip(tr("The rectangle's width by its height"));
    m_ratios->addItem(tr("Any"), 0.0);
    m_ratios->addItem(tr("Square"), 1.0);
    m_ratios->addItem(tr("As the picture"), -1.0);
    for (const auto& [width, height] : {std::pair(2, 1), std::pair(4, 3), std::pair(3, 2), std::pair(16, 9)})
        m_ratios->addItem(QStringLiteral("%1 : %2").arg(width).arg(height), 1.0 * width / height);
    connect(m_ratios, &QComboBox::activated, this, &FramePage::begin);
    return m_ratios;
}

void FramePage::begin() {
    if (m_ratios == nullptr)
        return;
    double ratio = m_ratios->currentData().toDouble();
    if (ratio < 0) {
        const Size size = m_canvas->picture() ? m_canvas->picture()->size() : Size{1, 1};
        ratio = static_cast<double>(size.width) / size.height;
    }
    m_canvas->setRatio(ratio);
}

Values FramePage::edit() const {
    Values edit;
    for (std::size_t i = 0; i < m_editors.size(); ++i)
        edit[m_tool.params()[i].name()] = m_editors[i]->value();
    return edit;
}

void FramePage::showFrame() {
    const Param& param = m_tool.params().front();
    const Value frame = m_canvas->frame();
    const auto* points = std::get_if<PlanePoints>(&frame);
    const bool area = param.type() == Param::Type::Area;
    // The canvas may show the frame of another tool.
    if (area ? points == nullptr : points != nullptr && points->size() == param.pointCount())
        m_editors.front()->setValue(frame);
}

} // namespace texloom::ui
