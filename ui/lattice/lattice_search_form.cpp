#include "ui/lattice/lattice_search_form.h"

#include "core/analysis/lattice_settings.h"
#include "core/base/settings.h"
#include "ui/inspector/mnemonics.h"
#include "ui/inspector/param_row.h"

#include <QGridLayout>
#include <QToolButton>
#include <QVBoxLayout>

namespace texloom::ui {

LatticeSearchForm::LatticeSearchForm(QWidget* parent)
    : QWidget(parent), m_params(latticeSearchFields<LatticeSettings>()) {
    auto* fold = new QToolButton;
    fold->setObjectName(QStringLiteral("latticeAdvanced"));
    fold->setText(tr("Advanced"));
    fold->setToolTip(tr("What decides between lattices when one is looked for"));
    fold->setCheckable(true);
    fold->setAutoRaise(true);
    fold->setArrowType(Qt::RightArrow);
    fold->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    fold->setFocusPolicy(Qt::StrongFocus);
    auto* form = new QWidget;
    auto* grid = new QGridLayout(form);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setColumnStretch(1, 1);
    Mnemonics none(QStringLiteral("ABCDEFGHIJKLMNOPQRSTUVWXYZ")); // the window's labels have them
    for (const Param& param : m_params) {
        m_rows.push_back(new ParamRow(param, grid, form, none));
        connect(m_rows.back(), &ParamRow::edited, this, &LatticeSearchForm::edited);
    }
    form->hide();
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(fold);
    column->addWidget(form);
    connect(fold, &QToolButton::toggled, this, [this, fold, form](bool open) {
        fold->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
        form->setVisible(open);
        layout()->activate();
        Q_EMIT folded();
    });
}

LatticeCriteria LatticeSearchForm::criteria() const {
    Values values;
    for (const ParamRow* row : m_rows)
        values[row->param().name()] = row->value();
    return settingsFrom<LatticeSettings>(m_params, values).criteria();
}

void LatticeSearchForm::setCriteria(const LatticeCriteria& criteria) {
    m_rows[0]->setValue(criteria.alpha);
    m_rows[1]->setValue(criteria.significance);
}

} // namespace texloom::ui
