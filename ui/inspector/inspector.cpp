#include "ui/inspector/inspector.h"

#include "ui/inspector/mnemonics.h"
#include "ui/inspector/output_group.h"
#include "ui/inspector/param_row.h"
#include "ui/inspector/value_editor.h"
#include "ui/window/text.h"

#include <QGridLayout>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QScrollArea>
#include <QVBoxLayout>

#include <algorithm>

namespace texloom::ui {

namespace {

/// Lines kept free for the help text, so that the form does not jump while it is read.
constexpr int kHelpLines = 5;

QString conditionText(const Method& method, const Param::Condition& condition) {
    return Inspector::tr("Only used while “%1” is %2.")
        .arg(translated(method.param(condition.name).title()),
             QString::fromStdString(toText(condition.value)));
}

} // namespace

Inspector::Inspector(QWidget* parent) : QWidget(parent), m_output(new OutputGroup), m_help(new QLabel) {
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
    m_column->addStretch();
    auto* scroll = new QScrollArea;
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFocusPolicy(Qt::NoFocus);
    scroll->setWidget(content);
    scroll->setMinimumWidth(content->minimumSizeHint().width());

    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(scroll, 1);
    column->addWidget(m_help);
    connect(m_output, &OutputGroup::edited, this, &Inspector::edited);
    connect(m_output, &OutputGroup::helpWanted, this, &Inspector::showHelp);
}

void Inspector::setMethod(const Method& method) {
    Values kept;
    for (const ParamRow* row : m_rows)
        if (row->changed())
            kept[row->param().name()] = row->value();
    m_method = &method;
    m_output->setMethod(method.info());
    makeRows();
    for (ParamRow* row : m_rows)
        if (const auto it = kept.find(row->param().name()); it != kept.end()) {
            try {
                row->setValue(it->second);
            } catch (const std::exception&) {
                row->reset();
            }
        }
    updateConditions();
    showHelp(translated(method.info().summary).toHtmlEscaped());
    Q_EMIT edited();
}

void Inspector::makeRows() {
    delete m_form;
    m_rows.clear();
    m_form = new QWidget;
    auto* column = new QVBoxLayout(m_form);
    column->setContentsMargins(0, 0, 0, 0);
    Mnemonics mnemonics(tr("fexsvhidtc"));
    std::vector<std::string> groups;
    for (const Param& param : m_method->params())
        if (std::find(groups.begin(), groups.end(), param.group()) == groups.end())
            groups.push_back(param.group());
    for (const std::string& group : groups)
        column->addWidget(makeGroup(group, mnemonics));
    m_column->insertWidget(1, m_form);
    alignLabels();
    QWidget* last = m_output;
    for (ParamRow* row : m_rows) {
        row->setExemplarSide(m_exemplar.shorterSide());
        setTabOrder(last, row->editor());
        last = row->editor();
    }
    for (QLineEdit* edit : findChildren<QLineEdit*>())
        edit->setAcceptDrops(false);
}

void Inspector::alignLabels() {
    int width = 0;
    for (const ParamRow* row : m_rows) {
        QFont bold = row->label()->font();
        bold.setBold(true);
        width = std::max(width, QFontMetrics(bold).horizontalAdvance(translated(row->param().title())));
    }
    for (ParamRow* row : m_rows)
        row->label()->setMinimumWidth(width);
}

QWidget* Inspector::makeGroup(const std::string& name, Mnemonics& mnemonics) {
    auto* group = new QGroupBox(translated(name));
    auto* grid = new QGridLayout(group);
    grid->setColumnStretch(1, 1);
    for (const Param& param : m_method->params()) {
        if (param.group() != name)
            continue;
        auto* row = new ParamRow(param, grid, group, mnemonics);
        m_rows.push_back(row);
        connect(row, &ParamRow::edited, this, [this] {
            updateConditions();
            Q_EMIT edited();
        });
        connect(row, &ParamRow::approached, this, [this, row] { showHelp(row->helpText()); });
    }
    return group;
}

void Inspector::setExemplarSize(Size size) {
    m_exemplar = size;
    m_output->setExemplarSize(size);
    for (ParamRow* row : m_rows)
        row->setExemplarSide(size.shorterSide());
    updateConditions();
    Q_EMIT edited();
}

Values Inspector::values() const {
    Values values;
    for (const ParamRow* row : m_rows)
        values[row->param().name()] = row->value();
    return values;
}

void Inspector::setValues(const Values& values) {
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

void Inspector::resetAll() {
    setValues({});
}

QString Inspector::help() const {
    return m_help->text();
}

void Inspector::updateConditions() {
    const Values current = values();
    for (ParamRow* row : m_rows) {
        const auto& condition = row->param().condition();
        row->setApplies(row->param().applies(current),
                        condition ? conditionText(*m_method, *condition) : QString());
    }
}

void Inspector::showHelp(const QString& html) {
    m_help->setText(html);
}

} // namespace texloom::ui
