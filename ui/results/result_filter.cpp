#include "ui/results/result_filter.h"

#include "ui/runs/result_history.h"

namespace texloom::ui {

ResultFilter::ResultFilter(QObject* parent) : QSortFilterProxyModel(parent) {
    setFilterRole(ResultHistory::SearchRole);
    setFilterCaseSensitivity(Qt::CaseInsensitive);
}

void ResultFilter::setKind(Kind kind) {
    m_kind = kind;
    invalidateFilter();
}

bool ResultFilter::filterAcceptsRow(int row, const QModelIndex& parent) const {
    const QModelIndex index = sourceModel()->index(row, 0, parent);
    const bool pinned = index.data(ResultHistory::PinnedRole).toBool();
    if (m_kind == Kind::Pinned && !pinned)
        return false;
    if (m_kind == Kind::Starred && index.data(ResultHistory::StarsRole).toInt() == 0)
        return false;
    if (m_kind == Kind::WithoutPreviews && !pinned && index.data(ResultHistory::PreviewRole).toBool())
        return false;
    return QSortFilterProxyModel::filterAcceptsRow(row, parent);
}

} // namespace texloom::ui
