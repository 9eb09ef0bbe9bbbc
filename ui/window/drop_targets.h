#pragma once

#include <QWidget>

#include <optional>
#include <vector>

class QMimeData;

namespace texloom::ui {

/// The places where something can be let go while it is dragged over a window that has an exemplar: in place
/// of the exemplar, beside it, as one of its companion maps, or as its mask. Menus do the same without a
/// mouse.
class DropTargets : public QWidget {
    Q_OBJECT

public:
    enum class Target { Exemplar, Add, Companion, Mask };

    explicit DropTargets(QWidget* parent);

    /// Covers the parent. @param files whether files are dragged; a picture alone can be no map.
    /// @param masks whether the method in use heeds a mask.
    void open(bool files, bool masks);
    /// Goes away unless the drag has come to it.
    void closeUnlessEntered();
    /// The target at a point, if something can be let go there.
    std::optional<Target> targetAt(QPoint point) const;
    /// Where a target is shown.
    QRect placeOf(Target target) const;

Q_SIGNALS:
    void dropped(texloom::ui::DropTargets::Target target, const QMimeData& data);
    /// The drag left or ended.
    void closed();

protected:
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dragMoveEvent(QDragMoveEvent* event) override;
    void dragLeaveEvent(QDragLeaveEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    struct Card {
        Target target;
        QString title, text;
        bool enabled;
    };
    void close();
    void paintCard(QPainter& painter, const Card& card) const;

    std::vector<Card> m_cards;
    std::optional<Target> m_over;
    bool m_entered = false;
};

} // namespace texloom::ui
