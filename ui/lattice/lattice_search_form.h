#pragma once

#include "core/analysis/lattice_candidate.h"
#include "core/base/param.h"

#include <QWidget>

#include <vector>

namespace texloom::ui {

class ParamRow;

/// What decides between lattices when one is looked for, as the methods that look for one declare it; folded
/// away until it is asked for.
class LatticeSearchForm : public QWidget {
    Q_OBJECT

public:
    explicit LatticeSearchForm(QWidget* parent = nullptr);

    LatticeCriteria criteria() const;
    /// Shows them, without edited().
    void setCriteria(const LatticeCriteria& criteria);

Q_SIGNALS:
    void edited();
    /// It was unfolded or folded away.
    void folded();

private:
    std::vector<Param> m_params;
    std::vector<ParamRow*> m_rows;
};

} // namespace texloom::ui
