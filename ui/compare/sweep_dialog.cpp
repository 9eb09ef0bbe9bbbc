#include "ui/compare/sweep_dialog.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "ui/common/appearance.h"
#include "ui/common/screen_size.h"
#include "ui/common/text.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace texloom::ui {

namespace {

constexpr int kValueWidths = 40;
constexpr int kSheetWidths = 64;

/// What an axis starts with: all choices, both states, or the value itself and some around it.
QString suggestion(const Param& parameter, const Value& value) {
    QStringList texts;
    for (const Choice& choice : parameter.choices())
        texts += QString::fromStdString(choice.id);
    if (parameter.type() == Param::Type::Toggle)
        texts = {QStringLiteral("off"), QStringLiteral("on")};
    if (!texts.isEmpty())
        return texts.join(QStringLiteral(", "));
    const auto* whole = std::get_if<int>(&value);
    const double middle = whole != nullptr ? *whole : std::get<double>(value);
    for (const double factor : {0.5, 1.0, 2.0}) {
        double near = middle * factor;
        if (parameter.hasRange())
            near = std::clamp(near, parameter.smallest(), parameter.largest());
        const QString text = QString::fromStdString(numberText(whole != nullptr ? std::round(near) : near));
        if (!texts.contains(text))
            texts += text;
    }
    return texts.join(QStringLiteral(", "));
}

/// What may be written for a parameter; choices with what they are called elsewhere in the window.
QString limitsOf(const Param& parameter) {
    QStringList texts;
    for (const Choice& choice : parameter.choices())
        texts += SweepDialog::tr("%1: %2").arg(QString::fromStdString(choice.id), translated(choice.title));
    return texts.isEmpty() ? translated(parameter.limits()) : texts.join(QLatin1Char('\n'));
}

} // namespace

SweepDialog::SweepDialog(RunInput input, QWidget* parent)
    : QDialog(parent), m_input(std::move(input)),
      m_across(makeRow(QStringLiteral("Across"), tr("Values across"))),
      m_down(makeRow(QStringLiteral("Down"), tr("Values down"))),
      m_varySeed(new QRadioButton(tr("Another seed for &each run"), this)),
      m_quick(new QCheckBox(tr("At a &preview's size"), this)), m_said(new QLabel(this)) {
    setObjectName(QStringLiteral("sweepDialog"));
    setWindowTitle(tr("Parameter sweep"));
    auto* same = new QRadioButton(tr("The &same seed for all"), this);
    same->setChecked(true);
    m_varySeed->setObjectName(QStringLiteral("sweepVarySeed"));
    m_quick->setObjectName(QStringLiteral("sweepQuick"));
    m_quick->setChecked(true);
    m_said->setObjectName(QStringLiteral("sweepSaid"));
    m_said->setWordWrap(true);

    auto* intro =
        new QLabel(tr("Makes a run for every combination of the values and shows them side by side. "
                      "Write values as a list (8, 16, 32) or as from:to:count (8:64:5)."),
                   this);
    intro->setWordWrap(true);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    m_start = buttons->addButton(tr("Start"), QDialogButtonBox::AcceptRole);
    m_start->setObjectName(QStringLiteral("sweepStart"));
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);

    auto* column = new QVBoxLayout(this);
    column->addWidget(intro);
    column->addLayout(makeForm(same));
    column->addWidget(m_said);
    column->addStretch();
    column->addWidget(buttons);

    listTargets();
    m_down.target->insertItem(0, tr("Nothing"), -1);
    m_across.target->setCurrentIndex(0);
    m_down.target->setCurrentIndex(0);
    for (const Row& row : {m_across, m_down}) {
        connect(row.target, &QComboBox::currentIndexChanged, this, [this, row] { targetChosen(row); });
        connect(row.values, &QLineEdit::textChanged, this, &SweepDialog::refresh);
        targetChosen(row);
    }
    connect(m_varySeed, &QRadioButton::toggled, this, &SweepDialog::refresh);
    const int width = fontMetrics().averageCharWidth() * kSheetWidths;
    resizeWithinScreen(this, {width, layout()->totalHeightForWidth(width)});
}

QFormLayout* SweepDialog::makeForm(QWidget* sameSeed) {
    auto* form = new QFormLayout;
    form->addRow(tr("&Across"), m_across.target);
    form->addRow(QString(), m_across.values);
    form->addRow(QString(), m_across.limits);
    form->addRow(tr("&Down"), m_down.target);
    form->addRow(QString(), m_down.values);
    form->addRow(QString(), m_down.limits);
    form->addRow(tr("Seed"), sameSeed);
    form->addRow(QString(), m_varySeed);
    form->addRow(tr("Size"), m_quick);
    return form;
}

SweepDialog::Row SweepDialog::makeRow(const QString& name, const QString& title) {
    const Row row{new QComboBox(this), new QLineEdit(this), new QLabel(this)};
    row.target->setObjectName(QStringLiteral("sweep%1").arg(name));
    row.values->setObjectName(QStringLiteral("sweep%1Values").arg(name));
    row.values->setAccessibleName(title);
    row.values->setMinimumWidth(fontMetrics().averageCharWidth() * kValueWidths);
    row.limits->setForegroundRole(QPalette::PlaceholderText);
    return row;
}

void SweepDialog::listTargets() {
    std::vector<std::string> ids;
    for (const RecipeStep& step : m_input.steps)
        ids.push_back(step.method);
    for (std::size_t step = 0; step < ids.size(); ++step) {
        const Method& method = findMethod(ids[step]);
        for (const Param& parameter : method.params()) {
            const QString title = translated(parameter.title());
            m_targets.push_back(
                {ids.size() > 1 ? tr("%1: %2").arg(translated(method.info().title), title) : title, step,
                 &parameter});
        }
    }
    m_targets.push_back({tr("Seed"), 0, nullptr});
    for (const Row& row : {m_across, m_down})
        for (std::size_t i = 0; i < m_targets.size(); ++i)
            row.target->addItem(m_targets[i].title, static_cast<int>(i));
}

void SweepDialog::targetChosen(const Row& row) {
    const int index = row.target->currentData().toInt();
    row.values->setEnabled(index >= 0);
    row.limits->setText({});
    if (index < 0) {
        row.values->clear();
    } else if (const Target& target = m_targets[static_cast<std::size_t>(index)];
               target.parameter == nullptr) {
        row.limits->setText(tr("Whole numbers"));
        row.values->setText(QStringLiteral("1:4:4"));
    } else {
        const Values& settings = m_input.steps[target.step].parameters;
        row.limits->setText(limitsOf(*target.parameter));
        row.values->setText(suggestion(*target.parameter, settings.at(target.parameter->name())));
    }
    refresh();
}

SweepAxis SweepDialog::axisOf(const Row& row) const {
    const Target& target = m_targets[static_cast<std::size_t>(row.target->currentData().toInt())];
    const std::string text = row.values->text().toStdString();
    SweepAxis axis{target.step, "", {}};
    if (target.parameter == nullptr) {
        axis.values = sweepSeeds(text);
    } else {
        axis.parameter = target.parameter->name();
        axis.values = sweepValues(*target.parameter, text);
    }
    if (axis.values.empty())
        failUsage("There are no values for {}.", target.title.toStdString());
    return axis;
}

void SweepDialog::refresh() {
    m_cells.clear();
    QPalette colors = palette();
    try {
        std::vector<SweepAxis> axes = {axisOf(m_across)};
        if (m_down.target->currentData().toInt() >= 0)
            axes.push_back(axisOf(m_down));
        m_columns = static_cast<int>(axes.front().values.size());
        m_cells = sweepCells(m_input, axes, m_varySeed->isChecked());
        m_said->setText(m_cells.size() == 1 ? tr("1 run") : tr("%1 runs").arg(m_cells.size()));
    } catch (const Error& error) {
        m_said->setText(translated(error.message()));
        colors.setColor(QPalette::WindowText, errorColor(colors));
    }
    m_said->setPalette(colors);
    m_start->setEnabled(!m_cells.empty());
}

bool SweepDialog::quick() const {
    return m_quick->isChecked();
}

} // namespace texloom::ui
