#pragma once

#include "core/render/render.h"
#include "ui/jobs/task.h"

#include <QImage>
#include <QPoint>
#include <QTimer>
#include <QWidget>

#include <memory>

namespace texloom::ui {

/// A material on a shape, lit from all around. Dragging turns the view, with the middle button it moves it,
/// Shift with the right button turns the light, the wheel comes nearer; the arrow keys turn, Shift with them
/// turns the light, + and − come nearer, F frames the shape, R goes back to how it was first, C goes through
/// the maps alone, M shows the material again. It is drawn off the GUI thread: quickly while something moves,
/// in full once it rests.
class MaterialView : public QWidget {
    Q_OBJECT

public:
    explicit MaterialView(QWidget* parent = nullptr);
    ~MaterialView() override;

    void setMaterial(std::shared_ptr<const MaterialTexture> material);
    const std::shared_ptr<const MaterialTexture>& material() const { return m_material; }
    void setMesh(std::shared_ptr<const RenderMesh> mesh);
    const std::shared_ptr<const RenderMesh>& mesh() const { return m_mesh; }
    void setLight(std::shared_ptr<const Environment> light);
    const std::shared_ptr<const Environment>& light() const { return m_light; }
    void setLook(const Look& look);
    const Look& look() const { return m_look; }

    /// What is on the screen; null while there is nothing.
    const QImage& picture() const { return m_picture; }
    /// Whether what is on the screen is drawn in full, as everything stands.
    bool rested() const { return m_full && !m_task.running() && !m_rest.isActive(); }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

Q_SIGNALS:
    /// The look was changed by hand.
    void lookChanged();
    void drawn();
    void failed(const QString& sentence);

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void turnBy(double right, double down);
    void turnLightBy(double right);
    void moveBy(QPointF pixels);
    void comeNearer(double factor);
    void nextMap();
    bool arrowKey(const QKeyEvent& event);
    void changedByHand();
    void drawSoon();
    void draw(bool full);

    std::shared_ptr<const MaterialTexture> m_material;
    std::shared_ptr<const RenderMesh> m_mesh;
    std::shared_ptr<const Environment> m_light;
    Look m_look;
    QImage m_picture;
    QPointF m_dragPoint;
    QTimer m_rest;        ///< until something that moved has rested
    bool m_stale = false; ///< whether something changed since the drawing under way began
    bool m_full = false;  ///< whether the picture is drawn in full
    Task<QImage> m_task;
};

/// A picture as rendered() gives it, as a screen shows it. @return of Format_ARGB32_Premultiplied.
QImage shownOnScreen(const Image& rendered);

} // namespace texloom::ui
