#pragma once

#include "core/analysis/lattice_detector.h"
#include "ui/picture/display_picture.h"

#include <QTableWidget>

#include <memory>
#include <optional>

namespace texloom::ui {

/// The lattices that were found in an exemplar, each with a small picture of the result that it would give,
/// one to be chosen.
class CandidateTable : public QTableWidget {
    Q_OBJECT

public:
    /// What stands in which column.
    enum Column { Result, Vectors, Goodness };

    explicit CandidateTable(QWidget* parent = nullptr);

    /// Lists the candidates of an analysis, none if it is null, and selects the one in use. Pictures of the
    /// same analysis stay.
    void list(std::shared_ptr<const LatticeAnalysis> analysis, const std::optional<Lattice>& inUse);
    /// Shows the result that a candidate would give; null takes it away until there is another one.
    void setResult(int row, const std::shared_ptr<const DisplayPicture>& result);
    /// Says why there is none.
    void setNoResult(int row, const QString& why);
    /// Selects none: the lattice in use was made by hand.
    void chooseNone();

Q_SIGNALS:
    void chosen(const texloom::LatticeCandidate& candidate);

private:
    void add(const LatticeCandidate& candidate);
    void fitHeight();
    int side() const;

    std::shared_ptr<const LatticeAnalysis> m_analysis;
};

} // namespace texloom::ui
