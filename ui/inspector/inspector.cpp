#include "ui/inspector/inspector.h"

#include "ui/common/down_scroll.h"
#include "ui/common/text.h"
#include "ui/common/value_editor.h"
#include "ui/inspector/method_form.h"
#include "ui/inspector/mnemonics.h"
#include "ui/inspector/output_group.h"
#include "ui/inspector/param_row.h"
#include "ui/inspector/step_chain.h"

#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>

namespace texloom::ui {

namespace {

/// Lines kept free for the help text, so that the form does not jump while it is read.
constexpr int kHelpLines = 5;

} // namespace

Inspector::Inspector(QWidget* parent)
    : QWidget(parent), m_output(new OutputGroup), m_then(new StepChain), m_help(new QLabel) {
    setObjectName(QStringLiteral("inspector"));
    m_help->setObjectName(QStringLiteral("parameterHelp"));
    m_help->setWordWrap(true);
    m_help->setTextFormat(Qt::RichText);
    m_help->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    m_help->setFixedHeight(fontMetrics().lineSpacing() * kHelpLines);

    auto* content = new QWidget;
    m_column = new QVBoxLayout(content);
    m_column->setContentsMargins(0, 0, 0, 0);
    m_column->addWidget(m_output);
    m_column->addWidget(m_then);
    m_column->addStretch();
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(new DownScroll(content), 1);
    column->addWidget(m_help);
    connect(m_output, &OutputGroup::edited, this, &Inspector::edited);
    connect(m_output, &OutputGroup::helpWanted, this, &Inspector::showHelp);
    connect(m_then, &StepChain::edited, this, &Inspector::showPorts);
    connect(m_then, &StepChain::edited, this, &Inspector::edited);
    connect(m_then, &StepChain::helpWanted, this, &Inspector::showHelp);
}

void Inspector::setMethod(const Method& method) {
    const Values kept = m_form ? m_form->changedValues() : Values{};
    delete m_form;
    Mnemonics mnemonics(tr("fexsvhidtc"));
    m_form = new MethodForm(method, mnemonics);
    m_form->setExemplarSide(m_exemplar.shorterSide());
    m_form->adopt(kept);
    m_column->insertWidget(1, m_form);
    QWidget* last = m_output;
    for (const ParamRow* row : rows()) {
        setTabOrder(last, row->editor());
        last = row->editor();
    }
    setTabOrder(last, m_then);
    connect(m_form, &MethodForm::edited, this, &Inspector::edited);
    connect(m_form, &MethodForm::helpWanted, this, &Inspector::showHelp);
    showHelp(translated(method.info().summary).toHtmlEscaped());
    showPorts();
    Q_EMIT edited();
}

const Method* Inspector::method() const {
    return m_form ? &m_form->method() : nullptr;
}

const std::vector<ParamRow*>& Inspector::rows() const {
    return m_form->rows();
}

void Inspector::setExemplarSize(Size size) {
    m_exemplar = size;
    m_output->setExemplarSize(size);
    if (m_form)
        m_form->setExemplarSide(size.shorterSide());
    m_then->setExemplarSide(size.shorterSide());
    Q_EMIT edited();
}

Values Inspector::values() const {
    return m_form->values();
}

Values Inspector::changedValues() const {
    return m_form->changedValues();
}

void Inspector::setValues(const Values& values) {
    m_form->setValues(values);
}

void Inspector::changeValues(const Values& values) {
    m_form->adopt(values);
    Q_EMIT edited();
}

std::vector<RecipeStep> Inspector::then() const {
    return m_then->steps();
}

std::vector<RecipeStep> Inspector::changedSteps() const {
    std::vector<RecipeStep> steps = {{method()->id(), changedValues()}};
    for (RecipeStep& step : m_then->changedSteps())
        steps.push_back(std::move(step));
    return steps;
}

void Inspector::setThen(const std::vector<RecipeStep>& steps) {
    m_then->setSteps(steps);
}

std::vector<RecipeStep> Inspector::steps() const {
    std::vector<RecipeStep> steps = {{method()->id(), values()}};
    for (RecipeStep& step : then())
        steps.push_back(std::move(step));
    return steps;
}

void Inspector::setSteps(const std::vector<RecipeStep>& steps) {
    setValues(steps.front().parameters);
    setThen({steps.begin() + 1, steps.end()});
}

/// A row for everything that the methods take apart from exemplars and what is shown beside them: their masks
/// and companion maps. The last method decides whether the result wraps, and whether a part can be made.
void Inspector::showPorts() {
    std::vector<Port> ports;
    const std::vector<RecipeStep> chain = steps();
    for (const RecipeStep& step : chain)
        for (const Port& port : findMethod(step.method).info().takes)
            if (port.id != kExemplarPort && port.id != kMaskPort && port.id != kCompanionPort &&
                !findPort(ports, port.id) && (port.id != kInitialPort || step.method == method()->id()))
                ports.push_back(port);
    m_output->setPorts(ports);
    m_output->setMethod(findMethod(chain.back().method).info());
}

void Inspector::resetAll() {
    m_form->setValues({});
    m_then->resetAll();
}

QString Inspector::help() const {
    return m_help->text();
}

void Inspector::showHelp(const QString& html) {
    m_help->setText(html);
}

} // namespace texloom::ui
