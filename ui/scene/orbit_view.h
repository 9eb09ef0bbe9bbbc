#pragma once

#include "core/render/render.h"
#include "ui/jobs/task.h"

#include <QImage>
#include <QPoint>
#include <QTimer>
#include <QWidget>

#include <functional>

namespace texloom::ui {

/// Something in space that is looked at from all sides. Dragging turns the view, with the middle button it
/// moves it, Shift with the right button turns the light, the wheel comes nearer; the arrow keys turn, Shift
/// with them turns the light, + and − come nearer, F frames it, R goes back to how it was first. It is drawn
/// off the GUI thread: quickly while something moves, in full once it rests.
class OrbitView : public QWidget {
    Q_OBJECT

public:
    explicit OrbitView(QWidget* parent = nullptr);
    ~OrbitView() override;

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
    struct Drawn {
        QImage picture;
        bool whole = true; ///< else it is drawn again, since more of it will be there
    };
    /// Draws on a worker. @param quickly while something moves.
    using Drawing = std::function<Drawn(const Look& look, Size size, bool quickly, JobContext& context)>;

    /// How what there is now is drawn; empty if there is nothing.
    virtual Drawing drawing() const = 0;
    /// What is said while there is no picture.
    virtual QString placeholder() const = 0;

    /// What is drawn has changed.
    void drawSoon();
    void changeByHand(const Look& look);

    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    /// Keys that a view has beside those of all.
    void addKeys(const QList<Qt::Key>& keys) { m_keys += keys; }
    /// How far the mouse was moved since it was asked last, in points of the widget.
    QPointF dragged(const QMouseEvent& event);
    /// How long a point of the widget is in space, where the view's middle is.
    float pointLength() const;

private:
    void turnBy(double right, double down);
    void turnLightBy(double right);
    void moveBy(QPointF pixels);
    void comeNearer(double factor);
    bool arrowKey(const QKeyEvent& event);
    void draw(bool full);

    Look m_look;
    QImage m_picture;
    QPointF m_dragPoint;
    QList<Qt::Key> m_keys;
    QTimer m_rest;        ///< until something that moved has rested
    bool m_stale = false; ///< whether something changed since the drawing under way began
    bool m_full = false;  ///< whether the picture is drawn in full
    Task<Drawn> m_task;
};

/// A picture as rendered() gives it, as a screen shows it. @return of Format_ARGB32_Premultiplied.
QImage shownOnScreen(const Image& rendered);

} // namespace texloom::ui
