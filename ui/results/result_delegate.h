#pragma once

#include <QStyledItemDelegate>

namespace texloom::ui {

/// Paints a result as a card: its thumbnail, its name, and chips with what tells it from others; a pin where
/// it is pinned. The name is edited where it stands.
class ResultDelegate : public QStyledItemDelegate {
    Q_OBJECT

public:
    using QStyledItemDelegate::QStyledItemDelegate;

    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
    void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                              const QModelIndex& index) const override;
};

} // namespace texloom::ui
