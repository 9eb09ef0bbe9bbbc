// How soon the window answers: figures to read, printed one a line in milliseconds.

#include "tests/ui/window_fixture.h"
#include "ui/compare/compare_view.h"
#include "ui/inspector/inspector.h"
#include "ui/inspector/output_group.h"
#include "ui/maps/result_view.h"
#include "ui/runs/run_controller.h"
#include "ui/viewers/image_viewer.h"

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
    QSignalSpy previewed(window.desk()->controller(), &RunController::previewed);
    QSignalSpy finished(window.desk()->controller(), &RunController::finished);
    QSignalSpy cancelled(window.desk()->controller(), &RunController::cancelled);
    QElapsedTimer clock;
    clock.start();
    window.startRun(false);
    if (!previewed.wait(kPatience))
        qFatal("no preview came");
    const qint64 taken = clock.elapsed();
    window.desk()->cancel();
    while (cancelled.isEmpty() && finished.isEmpty())
        QTest::qWait(5);
    return taken;
}

std::shared_ptr<const DisplayPicture> largePicture(std::uint64_t seed) {
    constexpr int kSide = 8192, kTile = 512;
    const Image tile = testTexture({kTile, kTile}, 3, seed);
    Image image({kSide, kSide}, 3);
    for (int c = 0; c < 3; ++c)
        for (int y = 0; y < kSide; ++y)
            for (int x = 0; x < kSide; ++x)
                image(x, y, c) = tile(x % kTile, (y + x / kTile) % kTile, c);
    return std::make_shared<const DisplayPicture>(std::make_shared<const Image>(std::move(image)));
}

/// Times of single frames while a viewer is panned and zoomed by its keys, in microseconds: from the key to
/// the picture painted in all of the window.
std::vector<qint64> frames(QWidget& window, ImageViewer& viewer) {
    constexpr int kFrames = 40;
    std::vector<qint64> times;
    viewer.setFocus();
    for (const Qt::Key key : {Qt::Key_F, Qt::Key_Plus, Qt::Key_1, Qt::Key_Minus})
        for (int frame = 0; frame < kFrames; ++frame) {
            const Qt::Key now = frame == 0 ? key : (frame % 8 == 7 && key != Qt::Key_F) ? key : Qt::Key_Right;
            QElapsedTimer clock;
            clock.start();
            QTest::keyClick(&viewer, now);
            window.repaint();
            QCoreApplication::processEvents();
            times.push_back(clock.nsecsElapsed() / 1000);
        }
    return times;
}

void printFrames(const QString& name, std::vector<qint64> times) {
    std::sort(times.begin(), times.end());
    constexpr double kMicro = 1e6;
    const auto worst = static_cast<double>(times[times.size() * 95 / 100]);
    QTextStream(stdout) << QStringLiteral("%1: median %2 frames/s, slowest twentieth %3 frames/s")
                               .arg(name)
                               .arg(kMicro / static_cast<double>(times[times.size() / 2]), 0, 'f', 0)
                               .arg(kMicro / worst, 0, 'f', 0)
                        << Qt::endl;
}

/// A large result in the viewer, plain and repeated, and four of them in a linked grid.
void measureLarge(MainWindow& window) {
    window.resize(1920, 1080);
    std::vector<std::shared_ptr<const DisplayPicture>> pictures;
    for (std::uint64_t seed = 1; seed <= 4; ++seed)
        pictures.push_back(largePicture(seed));
    ImageViewer viewer;
    viewer.resize(1600, 1000);
    viewer.setPicture(pictures.front());
    viewer.show();
    if (!QTest::qWaitForWindowExposed(&viewer))
        qFatal("the viewer never showed");
    printFrames(QStringLiteral("8192 × 8192 px in a viewer of 1600 × 1000 px"), frames(viewer, viewer));
    viewer.setRepeats(true);
    printFrames(QStringLiteral("the same, repeated"), frames(viewer, viewer));
    CompareView* const compare = window.compare();
    std::vector<CompareItem> items;
    for (const auto& picture : pictures)
        items.push_back({QStringLiteral("large"), picture, {}, {}});
    compare->setItems(std::move(items));
    window.results()->showPage(compare);
    QCoreApplication::processEvents();
    printFrames(QStringLiteral("four of 8192 × 8192 px compared in a grid, window of 1920 × 1080 px"),
                frames(window, *compare->viewer(0)));
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
    measureLarge(window);
    return 0;
}

} // namespace
} // namespace texloom::ui

int main(int argc, char** argv) {
    return texloom::ui::runTests(argc, argv, texloom::ui::measure);
}
