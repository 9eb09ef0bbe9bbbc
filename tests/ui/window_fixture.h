#pragma once

#include "core/image/image.h"
#include "tests/ui/test_programs.h"
#include "ui/window/main_window.h"

#include <QApplication>
#include <QTemporaryDir>
#include <QTest>

#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>

namespace texloom::ui {

/// How many milliseconds a test waits for what must come.
inline constexpr int kPatience = 60'000;

/// Makes an application whose settings and caches are in a temporary folder, and runs the tests of one class.
int runTests(int argc, char** argv, const std::function<int(int, char**)>& tests);

/// A picture in which no two patches are alike, the same at each call.
Image testTexture(Size size, int channels = 3, std::uint64_t seed = 1);

/// Writes a test texture as an 8-bit PNG. @return its path.
QString writeTexture(const QTemporaryDir& folder, const QString& name, Size size, std::uint64_t seed = 1);

/// Brings the window to the state in which a first exemplar has been opened and its quick run has ended.
bool openAndFinish(MainWindow& window, const QString& path);

/// How many methods "Try all methods" runs: all but those of solids.
std::size_t triedMethods();

/// Lets layouts come to rest, which ask for one another by events.
void settle();

/// The first text in a window that has less room than it asks for; empty if all are whole.
QString cutText(const QWidget& window);

/// The first two widgets of a layout that lie on each other, or one that reaches beyond the window or the
/// area that scrolls it; empty if all have their place.
QString misplaced(const QWidget& window);

/// Names of the widgets in a window that take the focus but that a screen reader could not tell.
QStringList namelessControls(const QWidget& window);

/// Whether something that took so many milliseconds kept to what is promised for a machine that does nothing
/// else: longer is allowed where others compute as well, and where they leave no room to tell, it is said and
/// passed over.
bool inTime(qint64 taken, std::chrono::milliseconds promised);

/// The child of this type and name. The test ends if there is none.
template <class Widget> Widget* child(const QObject& parent, const char* name) {
    auto* found = parent.findChild<Widget*>(QLatin1String(name));
    if (found == nullptr)
        qFatal("no child %s", name);
    return found;
}

/// Does what the action of this name does, once it can be done: what is offered may follow from work in the
/// background. The test ends if it cannot within a minute.
void trigger(const QObject& parent, const char* name);

} // namespace texloom::ui
