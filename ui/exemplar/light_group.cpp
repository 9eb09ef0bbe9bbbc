#include "ui/exemplar/light_group.h"

#include "ui/common/value_editor.h"
#include "ui/exemplar/edit_fields.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QLabel>

namespace texloom::ui {

LightGroup::LightGroup(QWidget* parent)
    : QGroupBox(tr("Even out the light"), parent), m_model(editorFor("model", this)),
      m_width(editorFor("width", this)), m_order(editorFor("order", this)),
      m_strength(editorFor("strength", this)), m_before(new QCheckBox(tr("Show &before"), this)) {
    setObjectName(QStringLiteral("editLight"));
    setCheckable(true);
    setChecked(false);
    setToolTip(tr("Takes slow changes of brightness out of the colours, so that parts from light and "
                  "dark places match."));
    m_width->setToolTip(tr("Width of the window that finds the light, in shares of the shorter side: larger "
                           "leaves more of the texture's own shades."));
    m_order->setToolTip(tr("How often the light may bend over the exemplar: 1 is a plain slope."));
    m_before->setObjectName(QStringLiteral("showBefore"));
    auto* form = new QFormLayout(this);
    addEditorRow(form, "model", m_model);
    addEditorRow(form, "strength", m_strength);
    m_widthLabel = addEditorRow(form, "width", m_width);
    m_orderLabel = addEditorRow(form, "order", m_order);
    form->addRow(m_before);
    connect(this, &QGroupBox::toggled, this, &LightGroup::tell);
    for (ValueEditor* editor : {m_model, m_width, m_order, m_strength})
        connect(editor, &ValueEditor::edited, this, &LightGroup::tell);
    connect(m_before, &QCheckBox::toggled, this, &LightGroup::beforeToggled);
    showWhatCounts();
}

void LightGroup::setLight(const FlattenEdit* light) {
    m_filling = true;
    setChecked(light != nullptr);
    if (light != nullptr) {
        const bool smooth = light->model == FlattenEdit::Model::Smooth;
        m_model->setValue(std::string(smooth ? "smooth" : "polynomial"));
        m_width->setValue(light->width);
        m_order->setValue(light->order);
        m_strength->setValue(light->strength);
    }
    showWhatCounts();
    m_filling = false;
}

std::optional<FlattenEdit> LightGroup::light() const {
    if (!isChecked())
        return std::nullopt;
    return FlattenEdit{smooth() ? FlattenEdit::Model::Smooth : FlattenEdit::Model::Polynomial,
                       realOf(*m_width), std::get<int>(m_order->value()), realOf(*m_strength)};
}

bool LightGroup::showsBefore() const {
    return m_before->isChecked();
}

bool LightGroup::smooth() const {
    return std::get<std::string>(m_model->value()) == "smooth";
}

void LightGroup::showWhatCounts() {
    for (QWidget* widget : {static_cast<QWidget*>(m_width), static_cast<QWidget*>(m_widthLabel)})
        widget->setVisible(smooth());
    for (QWidget* widget : {static_cast<QWidget*>(m_order), static_cast<QWidget*>(m_orderLabel)})
        widget->setVisible(!smooth());
}

void LightGroup::tell() {
    if (!m_filling)
        Q_EMIT edited();
}

} // namespace texloom::ui
