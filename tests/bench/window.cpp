// How soon the window answers: figures to read, printed one a line in milliseconds.

#include "tests/ui/window_fixture.h"
#include "ui/inspector/inspector.h"
#include "ui/inspector/output_group.h"
#include "ui/jobs/run_controller.h"

#include <QElapsedTimer>
#include <QSignalSpy>
#include <QTextStream>

#include <algorithm>
#include <vector>

namespace texloom::ui {
namespace {

constexpr int kPatience = 120'000;
constexpr int kRounds = 5;

void print(const QString& name, std::vector<qint64> times) {
    std::sort(times.begin(), times.end());
    QTextStream(stdout) << QStringLiteral("%1: median %2 ms, worst %3 ms")
                               .arg(name)
                               .arg(times[times.size() / 2])
                               .arg(times.back())
                        << Qt::endl;
}

qint64 showWindow() {
    QElapsedTimer clock;
    clock.start();
    MainWindow window;
    window.show();
    if (!QTest::qWaitForWindowExposed(&window))
        qFatal("the window never showed");
    QCoreApplication::processEvents();
    return clock.elapsed();
}

/// From Run to the first partial picture in the window.
qint64 firstPreview(MainWindow& window, Size output) {
    window.inspector()->output()->setOutputSize(output);
    QSignalSpy previewed(window.controller(), &RunController::previewed);
    QSignalSpy finished(window.controller(), &RunController::finished);
    QSignalSpy stopped(window.controller(), &RunController::stopped);
    QElapsedTimer clock;
    clock.start();
    window.startRun(false);
    if (!previewed.wait(kPatience))
        qFatal("no preview came");
    const qint64 taken = clock.elapsed();
    window.controller()->stop();
    while (stopped.isEmpty() && finished.isEmpty())
        QTest::qWait(5);
    return taken;
}

int measure(int, char**) {
    const QTemporaryDir folder;
    const QString exemplar = writeTexture(folder, QStringLiteral("weave.png"), {512, 512});
    std::vector<qint64> shown;
    for (int round = 0; round < kRounds; ++round)
        shown.push_back(showWindow());
    print(QStringLiteral("window built and painted"), shown);

    MainWindow window;
    window.show();
    if (!openAndFinish(window, exemplar))
        qFatal("the exemplar was not opened");
    for (const int side : {1024, 4096}) {
        std::vector<qint64> times;
        for (int round = 0; round < kRounds; ++round)
            times.push_back(firstPreview(window, {side, side}));
        print(QStringLiteral("first preview of %1 × %1 px after Run").arg(side), times);
    }
    return 0;
}

} // namespace
} // namespace texloom::ui

int main(int argc, char** argv) {
    return texloom::ui::runTests(argc, argv, texloom::ui::measure);
}
