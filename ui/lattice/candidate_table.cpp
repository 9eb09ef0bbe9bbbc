#include "ui/lattice/candidate_table.h"

#include "ui/lattice/lattice_text.h"

#include <QHeaderView>
#include <QIcon>
#include <QPixmap>
#include <QSignalBlocker>

#include <algorithm>
#include <utility>

namespace texloom::ui {

namespace {

constexpr int kLines = 5; // of text, as high as a picture is

QTableWidgetItem* cell(const QString& text) {
    auto* item = new QTableWidgetItem(text);
    item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    return item;
}

} // namespace

CandidateTable::CandidateTable(QWidget* parent) : QTableWidget(0, 3, parent) {
    setObjectName(QStringLiteral("latticeCandidates"));
    setAccessibleName(tr("Lattices to choose from"));
    setHorizontalHeaderLabels({tr("Result"), tr("Vectors"), tr("Goodness")});
    verticalHeader()->hide();
    verticalHeader()->setDefaultSectionSize(side() + 4);
    setIconSize({side(), side()});
    horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    horizontalHeader()->setSectionResizeMode(Result, QHeaderView::Fixed);
    horizontalHeader()->resizeSection(Result,
                                      std::max(side() + 8, horizontalHeader()->sectionSizeHint(Result)));
    horizontalHeader()->setSectionResizeMode(Goodness, QHeaderView::ResizeToContents);
    horizontalHeader()->setHighlightSections(false);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setSelectionMode(QAbstractItemView::SingleSelection);
    setTabKeyNavigation(false);
    fitHeight();
    connect(this, &QTableWidget::currentCellChanged, this, [this](int row) {
        if (m_analysis && row >= 0 && row < static_cast<int>(m_analysis->candidates.size()))
            Q_EMIT chosen(m_analysis->candidates[static_cast<std::size_t>(row)]);
    });
}

int CandidateTable::side() const {
    return fontMetrics().height() * kLines;
}

/// All rows are in sight: what is beyond a small screen is scrolled with the panel.
void CandidateTable::fitHeight() {
    setFixedHeight(std::max(1, rowCount()) * verticalHeader()->defaultSectionSize() +
                   horizontalHeader()->sizeHint().height() + 2 * frameWidth());
}

void CandidateTable::list(std::shared_ptr<const LatticeAnalysis> analysis,
                          const std::optional<Lattice>& inUse) {
    const QSignalBlocker blocker(this);
    if (m_analysis != analysis) {
        m_analysis = std::move(analysis);
        setRowCount(0);
        if (m_analysis)
            for (const LatticeCandidate& candidate : m_analysis->candidates)
                add(candidate);
        fitHeight();
    }
    clearSelection();
    setCurrentCell(-1, -1);
    for (int row = 0; row < rowCount(); ++row)
        if (inUse && sameVectors(*inUse, m_analysis->candidates[static_cast<std::size_t>(row)].lattice))
            selectRow(row);
    setEnabled(rowCount() > 0);
}

void CandidateTable::add(const LatticeCandidate& candidate) {
    const int row = rowCount();
    insertRow(row);
    setItem(row, Result, new QTableWidgetItem);
    setResult(row, nullptr);
    QStringList vectors;
    for (const Vec2 vector : {candidate.lattice.v1, candidate.lattice.v2})
        vectors += alongRows(vector) ? tr("free") : vectorText(vector, 1);
    setItem(row, Vectors, cell(vectors.join(QLatin1Char('\n'))));
    if (candidate.lattice.rowsOnly())
        item(row, Vectors)
            ->setToolTip(tr("Only rows repeat: what lies along them comes from anywhere in a row"));
    setItem(row, Goodness, cell(QString::number(candidate.goodness, 'f', 2)));
    item(row, Goodness)
        ->setToolTip(tr("Mean correlation %1 over %2 multiples of the vectors")
                         .arg(candidate.correlation, 0, 'f', 2)
                         .arg(candidate.multiples));
}

void CandidateTable::setResult(int row, const std::shared_ptr<const DisplayPicture>& result) {
    QTableWidgetItem* const place = item(row, Result);
    if (place == nullptr)
        return;
    place->setText(result ? QString() : QStringLiteral("…"));
    QIcon icon;
    if (result)
        for (const QIcon::Mode mode : {QIcon::Normal, QIcon::Selected}) // not tinted where it is chosen
            icon.addPixmap(QPixmap::fromImage(result->image()), mode);
    place->setIcon(icon);
    place->setToolTip(result ? tr("A small result with this lattice") : QString());
    place->setData(Qt::AccessibleTextRole, place->toolTip());
}

void CandidateTable::setNoResult(int row, const QString& why) {
    QTableWidgetItem* const place = item(row, Result);
    if (place == nullptr)
        return;
    place->setText(QStringLiteral("–"));
    place->setToolTip(why);
}

void CandidateTable::chooseNone() {
    const QSignalBlocker blocker(this);
    clearSelection();
    setCurrentCell(-1, -1);
}

} // namespace texloom::ui
