#pragma once

#include <QSortFilterProxyModel>

namespace texloom::ui {

/// Which of the history's results the dock shows: those of a kind that have a text in what is known of them.
class ResultFilter : public QSortFilterProxyModel {
    Q_OBJECT

public:
    enum class Kind { All, WithoutPreviews, Pinned, Starred };

    explicit ResultFilter(QObject* parent = nullptr);

    Kind kind() const { return m_kind; }
    void setKind(Kind kind);

protected:
    bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

private:
    Kind m_kind = Kind::All;
};

} // namespace texloom::ui
