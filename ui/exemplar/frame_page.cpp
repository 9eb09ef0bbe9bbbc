#include "ui/exemplar/frame_page.h"

#include "ui/common/text.h"
#include "ui/common/value_editors.h"
#include "ui/exemplar/edit_canvas.h"

#include <QFormLayout>
#include <QLabel>
#include <QPushButton>

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
    auto* note = new QLabel(translated(tool.params().front().help()) + QLatin1Char(' ') +
                            tr("Drag the corners; N takes the next one, the arrow keys move it."));
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
