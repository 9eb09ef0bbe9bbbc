#pragma once

#include "core/analysis/lattice.h"
#include "ui/viewers/image_viewer.h"

#include <optional>

namespace texloom::ui {

/// A picture with a lattice over it: two arrows from an origin, whose ends and origin can be dragged. Space
/// goes from handle to handle; then the arrow keys move it by a pixel, with Shift by ten, with Ctrl by a
/// tenth.
class LatticeCanvas : public ImageViewer {
    Q_OBJECT

public:
    /// What is drawn of the lattice: its courses over the exemplar, or its points over the correlation.
    enum class Style { Courses, Points };
    enum class Handle { None, Origin, First, Second };

    explicit LatticeCanvas(Style style, QWidget* parent = nullptr);

    /// Shows a lattice through `origin`, in pixels of the picture; nothing if there is none.
    void setLattice(const std::optional<Lattice>& lattice, Vec2 origin);
    const std::optional<Lattice>& lattice() const { return m_lattice; }
    Vec2 origin() const { return m_origin; }
    /// Whether the origin can be moved.
    void setOriginFixed(bool fixed);
    void setHandle(Handle handle);
    Handle handle() const { return m_handle; }
    /// Where a handle is, in pixels of the picture.
    Vec2 placeOf(Handle handle) const;

Q_SIGNALS:
    /// A handle was moved by hand: lattice() or origin() changed.
    void edited(texloom::ui::LatticeCanvas::Handle handle);
    void handleChanged(texloom::ui::LatticeCanvas::Handle handle);

protected:
    void paintOver(QPainter& painter) const override;
    bool event(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    QPointF toWidget(Vec2 point) const { return view().toWidget({point.x, point.y}); }
    QPointF handlePoint(Handle handle) const;
    double handleRadius() const;
    Handle handleAt(QPointF point) const;
    void moveHandle(Handle handle, Vec2 to);
    void nextHandle(int step);
    bool nudge(const QKeyEvent& event);
    void paintCourses(QPainter& painter) const;
    void paintPoints(QPainter& painter) const;
    void paintArrow(QPainter& painter, Handle handle) const;
    void paintHandle(QPainter& painter, Handle handle) const;

    Style m_style;
    std::optional<Lattice> m_lattice;
    Vec2 m_origin;
    bool m_originFixed = false;
    Handle m_handle = Handle::None;
    Handle m_dragged = Handle::None;
    Vec2 m_grip; ///< from the cursor to the dragged handle, in pixels of the picture
};

} // namespace texloom::ui
