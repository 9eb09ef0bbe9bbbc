#include "ui/exemplar/tool_form.h"

#include "core/tools/edits.h"
#include "ui/common/text.h"
#include "ui/common/value_editors.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>

namespace texloom::ui {

namespace {

/// Any size will do to tell whether values change nothing.
constexpr Size kAnySize{64, 64};

QString nameOf(const Tool& tool, const Param& param) {
    const QString id = QString::fromStdString(tool.id());
    return param.name() == tool.id()
               ? QStringLiteral("edit-%1").arg(id)
               : QStringLiteral("edit-%1-%2").arg(id, QString::fromStdString(param.name()));
}

} // namespace

ToolForm::ToolForm(const Tool& tool, QWidget* parent)
    : QGroupBox(translated(tool.info().title), parent), m_tool(tool) {
    setObjectName(QStringLiteral("tool-%1").arg(QString::fromStdString(tool.id())));
    setToolTip(translated(tool.info().summary));
    auto* form = new QFormLayout(this);
    if (adjusts() || tool.info().presets.empty())
        makeRows(form);
    if (!tool.info().presets.empty())
        makePresets(form);
    // Where the defaults change nothing, they are as good as no edit; else only a tick can say that there is
    // one.
    if (adjusts() && !changesNothing(tool.defaults(), kAnySize)) {
        setCheckable(true);
        setChecked(false);
        m_before = new QCheckBox(tr("Show &before"), this);
        m_before->setObjectName(QStringLiteral("before-%1").arg(QString::fromStdString(tool.id())));
        form->addRow(m_before);
        connect(this, &QGroupBox::toggled, this, &ToolForm::tell);
        connect(m_before, &QCheckBox::toggled, this, &ToolForm::beforeToggled);
    }
    if (!adjusts() && tool.info().presets.empty()) {
        auto* add = new QPushButton(tr("Apply"), this);
        add->setObjectName(QStringLiteral("apply-%1").arg(QString::fromStdString(tool.id())));
        connect(add, &QPushButton::clicked, this, [this] { Q_EMIT added(values()); });
        form->addRow(add);
    }
    showWhatCounts();
}

void ToolForm::makeRows(QFormLayout* form) {
    for (const Param& param : m_tool.params()) {
        ValueEditor* const editor = makeValueEditor(param, this);
        editor->setObjectName(nameOf(m_tool, param));
        editor->setAccessibleName(translated(param.title()));
        editor->setToolTip(translated(param.help()));
        editor->setValue(param.defaultFor(0));
        auto* label = new QLabel(translated(param.title()), this);
        label->setBuddy(editor);
        form->addRow(label, editor);
        m_editors.push_back(editor);
        m_labels.push_back(label);
        connect(editor, &ValueEditor::edited, this, &ToolForm::tell);
    }
}

void ToolForm::makePresets(QFormLayout* form) {
    auto* row = new QWidget(this);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    int number = 0;
    for (const ToolPreset& preset : m_tool.info().presets) {
        auto* button = new QToolButton(row);
        button->setText(translated(preset.title));
        button->setToolTip(translated(preset.help));
        button->setAccessibleName(translated(preset.help));
        button->setObjectName(
            QStringLiteral("preset-%1-%2").arg(QString::fromStdString(m_tool.id())).arg(number++));
        button->setFocusPolicy(Qt::StrongFocus);
        connect(button, &QToolButton::clicked, this, [this, &preset] { Q_EMIT added(preset.values); });
        layout->addWidget(button, 1);
    }
    form->addRow(row);
}

void ToolForm::setEdit(const ExemplarEdit* edit) {
    m_filling = true;
    if (isCheckable())
        setChecked(edit != nullptr);
    const Values shown = edit != nullptr ? m_tool.resolved(*edit) : m_tool.defaults();
    // Unticked values are kept, to be ticked again.
    if (edit != nullptr || !isCheckable())
        for (std::size_t i = 0; i < m_editors.size(); ++i)
            m_editors[i]->setValue(shown.at(m_tool.params()[i].name()));
    showWhatCounts();
    m_filling = false;
}

ExemplarEdit ToolForm::values() const {
    Values values;
    for (std::size_t i = 0; i < m_editors.size(); ++i)
        values[m_tool.params()[i].name()] = m_editors[i]->value();
    return resolved(values);
}

std::optional<ExemplarEdit> ToolForm::edit() const {
    if (isCheckable() && !isChecked())
        return std::nullopt;
    ExemplarEdit asked = values();
    if (changesNothing(asked, kAnySize))
        return std::nullopt;
    return asked;
}

bool ToolForm::showsBefore() const {
    return m_before != nullptr && m_before->isChecked();
}

void ToolForm::showWhatCounts() {
    Values all;
    for (std::size_t i = 0; i < m_editors.size(); ++i)
        all[m_tool.params()[i].name()] = m_editors[i]->value();
    for (std::size_t i = 0; i < m_editors.size(); ++i) {
        const bool counts = m_tool.params()[i].applies(all);
        m_editors[i]->setVisible(counts);
        m_labels[i]->setVisible(counts);
    }
}

void ToolForm::tell() {
    showWhatCounts();
    if (!m_filling && adjusts())
        Q_EMIT edited();
}

} // namespace texloom::ui
