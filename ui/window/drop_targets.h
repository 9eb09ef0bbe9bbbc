#pragma once

#include "core/methods/port.h"

#include <QWidget>

#include <optional>
#include <string>
#include <vector>

class QMimeData;

namespace texloom::ui {

/// The places where something can be let go while it is dragged over the window: in place of the exemplar,
/// beside it, as one of its companion maps, as its mask, or in one of the method's ports. Menus and the
/// inspector do the same without a mouse.
class DropTargets : public QWidget {
    Q_OBJECT

public:
    enum class Target { Exemplar, Add, Companion, Mask };
    enum class Dragged { Picture, Files, Result };

    explicit DropTargets(QWidget* parent);

    /// Covers the parent. @param dragged a picture or a result can be no companion map; a result may hold
    /// what any port takes. @param masks whether the method in use heeds a mask. @param ports that the method
    /// has beside exemplars and what belongs to them.
    void open(Dragged dragged, bool masks, const std::vector<Port>& ports = {});
    /// The same where there is no exemplar yet: as one, or in a port.
    void openWithoutExemplar(Dragged dragged, const std::vector<Port>& ports);
    /// Goes away unless the drag has come to it.
    void closeUnlessEntered();
    /// The target at a point, if something can be let go there.
    std::optional<Target> targetAt(QPoint point) const;
    /// The id of the port at a point, if something can be let go there; else empty.
    std::string portAt(QPoint point) const;
    /// Where a target is shown.
    QRect placeOf(Target target) const { return placeAt(static_cast<int>(target)); }
    /// Where a port is shown; empty if it is not.
    QRect placeOf(const std::string& port) const;

Q_SIGNALS:
    void dropped(texloom::ui::DropTargets::Target target, const QMimeData& data);
    void droppedInto(const std::string& port, const QMimeData& data);
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
        QString title, text;
        bool enabled;
        std::string port = {}; ///< its id; empty for one of the targets, which come first
    };
    void addPorts(Dragged dragged, const std::vector<Port>& ports);
    void cover();
    void close();
    QRect placeAt(int index) const;
    /// The index of the card at a point where something can be let go; −1 if there is none.
    int cardAt(QPoint point) const;
    void paintCard(QPainter& painter, int index) const;

    std::vector<Card> m_cards;
    int m_over = -1;
    bool m_entered = false;
};

} // namespace texloom::ui
