#include "ui/inspector/method_form.h"

#include "ui/common/text.h"
#include "ui/common/value_editor.h"
#include "ui/inspector/mnemonics.h"
#include "ui/inspector/param_row.h"

#include <QGridLayout>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QVBoxLayout>

#include <algorithm>

namespace texloom::ui {

namespace {

QString conditionText(const Method& method, const Param::Condition& condition) {
    return MethodForm::tr("Only used while “%1” is %2.")
        .arg(translated(method.param(condition.name).title()),
             QString::fromStdString(toText(condition.value)));
}

} // namespace

MethodForm::MethodForm(const Method& method, Mnemonics& mnemonics, QWidget* parent)
    : QWidget(parent), m_method(method) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    std::vector<std::string> groups;
    for (const Param& param : method.params())
        if (std::find(groups.begin(), groups.end(), param.group()) == groups.end())
            groups.push_back(param.group());
    for (const std::string& group : groups)
        column->addWidget(makeGroup(group, mnemonics));
    alignLabels();
    for (QLineEdit* edit : findChildren<QLineEdit*>())
        edit->setAcceptDrops(false);
    updateConditions();
}

QWidget* MethodForm::makeGroup(const std::string& name, Mnemonics& mnemonics) {
    auto* group = new QGroupBox(translated(name));
    auto* grid = new QGridLayout(group);
    grid->setColumnStretch(1, 1);
    for (const Param& param : m_method.params()) {
        if (param.group() != name)
            continue;
        auto* row = new ParamRow(param, grid, group, mnemonics);
        m_rows.push_back(row);
        connect(row, &ParamRow::edited, this, [this] {
            updateConditions();
            Q_EMIT edited();
        });
        connect(row, &ParamRow::approached, this, [this, row] { Q_EMIT helpWanted(row->helpText()); });
    }
    return group;
}

void MethodForm::alignLabels() {
    int width = 0;
    for (const ParamRow* row : m_rows) {
        QFont bold = row->label()->font();
        bold.setBold(true);
        width = std::max(width, QFontMetrics(bold).horizontalAdvance(translated(row->param().title())));
    }
    for (ParamRow* row : m_rows)
        row->label()->setMinimumWidth(width);
}

void MethodForm::updateConditions() {
    const Values current = values();
    for (ParamRow* row : m_rows) {
        const auto& condition = row->param().condition();
        row->setApplies(row->param().applies(current),
                        condition ? conditionText(m_method, *condition) : QString());
    }
}

Values MethodForm::values() const {
    Values values;
    for (const ParamRow* row : m_rows)
        values[row->param().name()] = row->value();
    return values;
}

Values MethodForm::changedValues() const {
    Values values;
    for (const ParamRow* row : m_rows)
        if (row->changed())
            values[row->param().name()] = row->value();
    return values;
}

void MethodForm::setValues(const Values& values) {
    for (ParamRow* row : m_rows) {
        const auto it = values.find(row->param().name());
        if (it == values.end())
            row->reset();
        else
            row->setValue(it->second);
    }
    updateConditions();
    Q_EMIT edited();
}

void MethodForm::adopt(const Values& values) {
    for (ParamRow* row : m_rows)
        if (const auto it = values.find(row->param().name()); it != values.end()) {
            try {
                row->setValue(it->second);
            } catch (const std::exception&) {
                row->reset();
            }
        }
    updateConditions();
}

void MethodForm::setExemplarSide(int side) {
    for (ParamRow* row : m_rows)
        row->setExemplarSide(side);
    updateConditions();
}

} // namespace texloom::ui
