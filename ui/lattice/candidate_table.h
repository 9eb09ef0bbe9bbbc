#pragma once

#include "core/analysis/lattice_detector.h"

#include <QTableWidget>

#include <memory>
#include <optional>

namespace texloom::ui {

/// The lattices that were found in an exemplar, one to be chosen.
class CandidateTable : public QTableWidget {
    Q_OBJECT

public:
    explicit CandidateTable(QWidget* parent = nullptr);

    /// Lists the candidates of an analysis, none if it is null, and selects the one in use.
    void list(std::shared_ptr<const LatticeAnalysis> analysis, const std::optional<Lattice>& inUse);
    /// Selects none: the lattice in use was made by hand.
    void chooseNone();

Q_SIGNALS:
    void chosen(const texloom::LatticeCandidate& candidate);

private:
    void add(const LatticeCandidate& candidate);

    std::shared_ptr<const LatticeAnalysis> m_analysis;
};

} // namespace texloom::ui
