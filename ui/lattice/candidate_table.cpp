#include "ui/lattice/candidate_table.h"

#include "ui/lattice/lattice_text.h"

#include <QHeaderView>
#include <QSignalBlocker>

#include <utility>

namespace texloom::ui {

namespace {

constexpr int kRows = 5; // that are in sight, the header not counted

QTableWidgetItem* cell(const QString& text) {
    auto* item = new QTableWidgetItem(text);
    item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    return item;
}

} // namespace

CandidateTable::CandidateTable(QWidget* parent) : QTableWidget(0, 3, parent) {
    setObjectName(QStringLiteral("latticeCandidates"));
    setAccessibleName(tr("Lattices to choose from"));
    setHorizontalHeaderLabels({tr("First vector"), tr("Second vector"), tr("Goodness")});
    verticalHeader()->hide();
    verticalHeader()->setDefaultSectionSize(fontMetrics().height() * 3 / 2);
    horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    horizontalHeader()->setSectionResizeMode(2, QHeaderView::ResizeToContents);
    horizontalHeader()->setHighlightSections(false);
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setSelectionMode(QAbstractItemView::SingleSelection);
    setTabKeyNavigation(false);
    setFixedHeight(fontMetrics().height() * 3 / 2 * kRows + horizontalHeader()->sizeHint().height());
    connect(this, &QTableWidget::currentCellChanged, this, [this](int row) {
        if (m_analysis && row >= 0 && row < static_cast<int>(m_analysis->candidates.size()))
            Q_EMIT chosen(m_analysis->candidates[static_cast<std::size_t>(row)]);
    });
}

void CandidateTable::list(std::shared_ptr<const LatticeAnalysis> analysis,
                          const std::optional<Lattice>& inUse) {
    const QSignalBlocker blocker(this);
    m_analysis = std::move(analysis);
    setRowCount(0);
    if (m_analysis)
        for (const LatticeCandidate& candidate : m_analysis->candidates) {
            add(candidate);
            if (inUse && sameVectors(*inUse, candidate.lattice))
                selectRow(rowCount() - 1);
        }
    setEnabled(rowCount() > 0);
}

void CandidateTable::add(const LatticeCandidate& candidate) {
    const int row = rowCount();
    insertRow(row);
    const auto addVector = [&](int column, Vec2 vector) {
        auto* const item = cell(alongRows(vector) ? tr("free") : vectorText(vector, 1));
        if (alongRows(vector))
            item->setToolTip(tr("Only rows repeat: what lies along them comes from anywhere in a row"));
        setItem(row, column, item);
    };
    addVector(0, candidate.lattice.v1);
    addVector(1, candidate.lattice.v2);
    setItem(row, 2, cell(QString::number(candidate.goodness, 'f', 2)));
    item(row, 2)->setToolTip(tr("Mean correlation %1 over %2 multiples of the vectors")
                                 .arg(candidate.correlation, 0, 'f', 2)
                                 .arg(candidate.multiples));
}

void CandidateTable::chooseNone() {
    const QSignalBlocker blocker(this);
    clearSelection();
    setCurrentCell(-1, -1);
}

} // namespace texloom::ui
