#pragma once

#include "tests/ui/window_fixture.h"
#include "ui/common/appearance.h"
#include "ui/paint/painter.h"

#include <QAbstractButton>
#include <QMessageBox>
#include <QToolButton>

#include <utility>
#include <vector>

namespace texloom::ui {

inline constexpr Size kPainted{64, 48};

/// The point of a canvas over the middle of a pixel.
inline QPoint over(const PaintCanvas& canvas, QPoint pixel) {
    return canvas.view().toWidget(QPointF(pixel) + QPointF(0.5, 0.5)).toPoint();
}

inline void drag(PaintCanvas& canvas, const std::vector<QPoint>& pixels, Qt::KeyboardModifiers keys = {}) {
    QTest::mousePress(&canvas, Qt::LeftButton, keys, over(canvas, pixels.front()));
    for (const QPoint& pixel : pixels)
        QTest::mouseMove(&canvas, over(canvas, pixel));
    QTest::mouseRelease(&canvas, Qt::LeftButton, keys, over(canvas, pixels.back()));
}

/// Waits until a painter shows what is painted.
inline void settled(const Painter& painter) {
    settle();
    if (!QTest::qWaitFor([&] { return !painter.busy(); }))
        qFatal("the painter did not come to rest");
}

inline void chooseTool(const Painter& painter, const char* name) {
    child<QToolButton>(painter, name)->click();
}

/// Answers the question that a painter asks before it loses something.
inline void answer(const Painter& painter, QMessageBox::ButtonRole role) {
    QTRY_VERIFY(painter.findChild<QMessageBox*>(QStringLiteral("paintLoss")));
    const auto* box = child<QMessageBox>(painter, "paintLoss");
    for (QAbstractButton* button : box->buttons())
        if (box->buttonRole(button) == role)
            return button->click();
    qFatal("no such answer");
}

/// Keeps pictures of a widget, light and dark, in the folder that the environment names, for people to look
/// at.
inline void look(QWidget& widget, const char* name) {
    const QString folder = qEnvironmentVariable("TEXLOOM_LOOK");
    if (folder.isEmpty())
        return;
    for (const auto& [appearance, ending] :
         {std::pair(Appearance::Dark, "dark"), std::pair(Appearance::Light, "light")}) {
        applyAppearance(appearance);
        settle();
        widget.grab().save(
            QStringLiteral("%1/%2_%3.png").arg(folder, QLatin1String(name), QLatin1String(ending)));
    }
}

} // namespace texloom::ui
