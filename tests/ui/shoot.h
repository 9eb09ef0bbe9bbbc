#pragma once

#include "tests/ui/window_fixture.h"

namespace texloom::ui {

/// Writes a picture of a widget to the folder of screenshots, named after the state, the test's data and the
/// scale, and checks that no text in it is cut off.
inline void shoot(QWidget& widget, const char* state) {
    settle();
    QVERIFY2(cutText(widget).isEmpty(), qPrintable(cutText(widget)));
    const QString scale = qEnvironmentVariable("QT_SCALE_FACTOR", QStringLiteral("1"));
    const QString file = QStringLiteral("%1/%2-%3-%4x.png")
                             .arg(QStringLiteral(TEXLOOM_SCREENSHOTS), QLatin1String(state),
                                  QLatin1String(QTest::currentDataTag()), scale);
    constexpr int kQuick = 80; // large pictures, compressed a little
    QVERIFY2(widget.grab().save(file, nullptr, kQuick), qPrintable(file));
}

} // namespace texloom::ui
