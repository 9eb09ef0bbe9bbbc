#include "tests/ui/window_fixture.h"
#include "ui/common/icons.h"
#include "ui/viewers/image_viewer.h"
#include "ui/viewers/navigator.h"
#include "ui/viewers/scope.h"
#include "ui/viewers/viewer_keys.h"

#include <QSignalSpy>
#include <QWheelEvent>

#include <numeric>

using namespace texloom;
using namespace texloom::ui;

namespace {

std::shared_ptr<const DisplayPicture> pictureOf(const Image& image) {
    return std::make_shared<const DisplayPicture>(std::make_shared<const Image>(image));
}

void wheel(ImageViewer& viewer, QPointF at, int notches) {
    QWheelEvent event(at, viewer.mapToGlobal(at), {}, {0, 120 * notches}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(&viewer, &event);
}

bool near(QPointF a, QPointF b, double distance) {
    return std::hypot(a.x() - b.x(), a.y() - b.y()) <= distance;
}

/// Red, with one green pixel.
Image dotted(Size size, QPoint dot) {
    Image image(size, 3);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            image(x, y, QPoint(x, y) == dot ? 1 : 0) = 1;
    return image;
}

} // namespace

class ViewerTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void zoomKeepsThePixelUnderTheCursor() {
        ImageViewer viewer;
        viewer.resize(400, 300);
        viewer.setPicture(pictureOf(testTexture({200, 100})));
        const QPointF at(123, 87);
        const QPointF before = viewer.view().toImage(at);
        wheel(viewer, at, 3);
        QVERIFY(viewer.view().scale() > 2);
        QVERIFY(near(viewer.view().toImage(at), before, 1e-9));
        wheel(viewer, at, -5);
        QVERIFY(near(viewer.view().toImage(at), before, 1e-9));
    }

    void navigatorIsThereWhereThePictureReachesBeyondTheView() {
        ImageViewer viewer;
        viewer.resize(600, 600);
        viewer.setPicture(pictureOf(testTexture({200, 100})));
        viewer.show();
        auto* const navigator = viewer.findChild<Navigator*>();
        QVERIFY(!navigator->isVisible());
        viewer.lookAt({50, 50}, 40);
        QVERIFY(navigator->isVisible());
        QCOMPARE(navigator->width(), 2 * navigator->height());
        QTest::mouseClick(navigator, Qt::LeftButton, Qt::NoModifier,
                          {navigator->width() * 3 / 4, navigator->height() / 2});
        QVERIFY(near(viewer.view().toImage({300, 300}), {150, 50}, 2));
        QTest::keyClick(&viewer, Qt::Key_N);
        QVERIFY(!navigator->isVisible());
        QTest::keyClick(&viewer, Qt::Key_N);
        QVERIFY(navigator->isVisible());
        viewer.fit();
        QVERIFY(!navigator->isVisible());
    }

    void histogramAndWaveformCountWhatIsShown() {
        QImage shown(4, 2, QImage::Format_ARGB32);
        shown.fill(QColor(10, 20, 30));
        shown.setPixelColor(3, 0, QColor(200, 20, 30));
        shown.setPixelColor(3, 1, QColor(0, 0, 0, 0));
        const Histogram counts = histogramOf(shown);
        QCOMPARE(counts[0][10], 6);
        QCOMPARE(counts[0][200], 1);
        QCOMPARE(counts[1][20], 7);
        QCOMPARE(counts[2][30], 7);
        QCOMPARE(std::accumulate(counts[2].begin(), counts[2].end(), 0), 7);
        const QImage waveform = waveformOf(shown, 2);
        QCOMPARE(waveform.size(), QSize(6, 256));
        QCOMPARE(waveform.pixelColor(0, 255 - 10).alpha(), 255);  // four of the left half's four pixels
        QCOMPARE(waveform.pixelColor(1, 255 - 200).alpha(), 128); // the root of a fourth
        QCOMPARE(waveform.pixelColor(0, 255 - 200).alpha(), 0);
        QVERIFY(waveform.pixelColor(4, 255 - 30).alpha() == 255);
    }

    void oneKeyShowsHistogramWaveformAndNeither() {
        ImageViewer viewer;
        viewer.resize(400, 300);
        viewer.setPicture(pictureOf(testTexture({200, 100})));
        viewer.show();
        auto* const scope = viewer.findChild<Scope*>();
        QVERIFY(!scope->isVisible());
        for (const ScopeKind kind : {ScopeKind::Histogram, ScopeKind::Waveform, ScopeKind::None}) {
            const QImage before = viewer.grab().toImage();
            QTest::keyClick(&viewer, Qt::Key_I);
            QCOMPARE(scope->kind(), kind);
            QCOMPARE(scope->isVisible(), kind != ScopeKind::None);
            QVERIFY(viewer.grab().toImage() != before);
        }
    }

    void fitShowsAllInTheMiddle() {
        ImageViewer viewer;
        viewer.resize(400, 300);
        viewer.setPicture(pictureOf(testTexture({200, 100})));
        wheel(viewer, {10, 10}, 4);
        viewer.fit();
        QCOMPARE(viewer.view().scale(), 2.0);
        QCOMPARE(viewer.view().toWidget({100, 50}), QPointF(200, 150));
        viewer.resize(200, 300);
        QCoreApplication::sendPostedEvents();
        viewer.grab();
        QCOMPARE(viewer.view().scale(), 1.0);
    }

    void actualSizeIsOneDevicePixel() {
        ImageViewer viewer;
        viewer.resize(400, 300);
        viewer.setPicture(pictureOf(testTexture({50, 50})));
        QTest::keyClick(&viewer, Qt::Key_1);
        QCOMPARE(viewer.view().scale() * viewer.devicePixelRatioF(), 1.0);
    }

    void keysAreThoseThatWereChosen() {
        ImageViewer viewer;
        viewer.resize(400, 300);
        viewer.setPicture(pictureOf(testTexture({50, 50})));
        setViewerKeys(ViewerCommand::Repeat, {QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_W)});
        QTest::keyClick(&viewer, Qt::Key_W);
        QVERIFY(!viewer.repeats());
        QTest::keyClick(&viewer, Qt::Key_W, Qt::ControlModifier | Qt::AltModifier);
        QVERIFY(viewer.repeats());
        setViewerKeys(ViewerCommand::Repeat, {QKeySequence(Qt::Key_W)});
        QTest::keyClick(&viewer, Qt::Key_W, Qt::ShiftModifier); // the wipe's
        QVERIFY(viewer.repeats());
        const double before = viewer.view().scale();
        QTest::keyClick(&viewer, Qt::Key_Plus, Qt::ShiftModifier);
        QVERIFY(viewer.view().scale() > before);
        QTest::keyClick(&viewer, Qt::Key_Minus, Qt::KeypadModifier);
        QCOMPARE(viewer.view().scale(), before);
    }

    void panStopsWhileSomeIsInReachButNotWhenRepeated() {
        ImageViewer viewer;
        viewer.resize(400, 300);
        viewer.setPicture(pictureOf(testTexture({64, 64})));
        for (int i = 0; i < 100; ++i)
            QTest::keyClick(&viewer, Qt::Key_Left);
        QVERIFY(viewer.view().origin().x() <= 200);
        viewer.setRepeats(true);
        for (int i = 0; i < 100; ++i)
            QTest::keyClick(&viewer, Qt::Key_Left);
        QVERIFY(viewer.view().origin().x() > 400);
    }

    void repeatedPixelsAreFoundModulo() {
        ImageViewer viewer;
        viewer.resize(400, 300);
        viewer.setPicture(pictureOf(testTexture({64, 32})));
        const QPointF outside = viewer.view().toWidget({-1.5, -1.5});
        QVERIFY(!viewer.pixelAt(outside));
        viewer.setRepeats(true);
        QCOMPARE(viewer.pixelAt(viewer.view().toWidget({-1.5, -1.5})), QPoint(62, 30));
        QCOMPARE(viewer.pixelAt(viewer.view().toWidget({64.5, 32.5})), QPoint(0, 0));
        QCOMPARE(viewer.pixelAt(viewer.view().toWidget({-128.5, 65.5})), QPoint(63, 1));
    }

    void halfOffsetPutsTheCornerInTheMiddle() {
        ImageViewer viewer;
        viewer.resize(320, 300);
        viewer.setPicture(pictureOf(dotted({64, 32}, {3, 5})));
        viewer.showSeams();
        QVERIFY(viewer.repeats());
        QCOMPARE(viewer.pixelAt({160.5, 150.5}), QPoint(0, 0));
        QCOMPARE(viewer.pixelAt({159.5, 149.5}), QPoint(63, 31));
        QVERIFY(viewer.view().scale() * 64 > 300); // one tile as large as fits
    }

    void ringsAreAroundEveryTilesCopy() {
        ImageViewer viewer;
        viewer.resize(300, 300);
        viewer.setPicture(pictureOf(dotted({16, 16}, {3, 5})));
        viewer.setRepeats(true);
        const QImage plain = viewer.grab().toImage();
        viewer.setRings({QPoint(8, 8)});
        const QImage ringed = viewer.grab().toImage();
        const double radius = viewer.fontMetrics().height() * 0.35;
        int rings = 0;
        for (const QPoint tile : {QPoint(0, 0), QPoint(-1, 0), QPoint(0, -1)}) {
            const QPointF at =
                viewer.view().toWidget(QPointF(8.5, 8.5) + QPointF(tile) * 16) + QPointF(radius, 0);
            const QPoint pixel = (at * ringed.devicePixelRatio()).toPoint();
            rings += ringed.rect().contains(pixel) && ringed.pixel(pixel) != plain.pixel(pixel);
        }
        QCOMPARE(rings, 3);
    }

    void repeatedPictureIsPaintedModulo() {
        ImageViewer viewer;
        viewer.resize(300, 300);
        viewer.setPicture(pictureOf(dotted({16, 16}, {3, 5})));
        viewer.setRepeats(true);
        const QImage shown = viewer.grab().toImage().convertToFormat(QImage::Format_RGB32);
        for (const QPoint tile : {QPoint(0, 0), QPoint(-1, 0), QPoint(1, 1)}) {
            const QPointF dot = viewer.view().toWidget(QPointF(3.5, 5.5) + QPointF(tile) * 16);
            const QPoint device = (dot * shown.devicePixelRatio()).toPoint();
            if (shown.rect().contains(device))
                QCOMPARE(QColor(shown.pixel(device)), QColor(Qt::green));
        }
        const QPointF corner = viewer.view().toWidget({16, 16}) * shown.devicePixelRatio();
        for (int d = -2; d <= 2; ++d)
            QCOMPARE(QColor(shown.pixel((corner + QPointF(d, d)).toPoint())), QColor(Qt::red));
    }

    void magnifiedPixelsAreSquareAndWhereHoverSaysTheyAre() {
        ImageViewer viewer;
        viewer.resize(320, 320);
        viewer.setPicture(pictureOf(dotted({64, 64}, {20, 30})));
        wheel(viewer, {105, 155}, 5);
        const QImage shown = viewer.grab().toImage();
        for (int y = 0; y < 320; y += 3)
            for (int x = 0; x < 320; x += 3) {
                const QPointF exact = viewer.view().toImage({x + 0.5, y + 0.5});
                const QPointF fraction(exact.x() - std::floor(exact.x()), exact.y() - std::floor(exact.y()));
                const bool edge =
                    fraction.x() < 0.1 || fraction.x() > 0.9 || fraction.y() < 0.1 || fraction.y() > 0.9;
                const auto pixel = viewer.pixelAt({x + 0.5, y + 0.5});
                if (!pixel || edge)
                    continue;
                const QPointF device = QPointF(x + 0.5, y + 0.5) * shown.devicePixelRatio();
                const QColor color =
                    shown.pixelColor(static_cast<int>(device.x()), static_cast<int>(device.y()));
                QCOMPARE(color, *pixel == QPoint(20, 30) ? QColor(Qt::green) : QColor(Qt::red));
            }
    }

    void previewLiesWhereTheFinalWillLie() {
        ImageViewer viewer;
        viewer.resize(400, 400);
        const auto small = std::make_shared<const Image>(testTexture({50, 25}));
        PositionMap made({50, 25}, {{50, 25}});
        made.at(0, 0) = {0, 0, 0};
        viewer.setPicture(std::make_shared<const DisplayPicture>(small, Size{200, 100}, 4, &made));
        QVERIFY(viewer.picture()->transparent());
        QVERIFY(qAlpha(viewer.picture()->image().pixel(0, 0)) == 255);
        QVERIFY(qAlpha(viewer.picture()->image().pixel(1, 0)) == 0);
        wheel(viewer, {50, 50}, 2);
        const ViewTransform before = viewer.view();
        viewer.setPicture(pictureOf(testTexture({200, 100})));
        QVERIFY(viewer.view() == before);
    }

    void greyAndTwoChannelsHaveColours() {
        const QRgb grey = pictureOf(testTexture({4, 4}, 1))->image().pixel(1, 1);
        QVERIFY(qRed(grey) == qGreen(grey) && qGreen(grey) == qBlue(grey) && qRed(grey) > 0);
        const QRgb two = pictureOf(testTexture({4, 4}, 2))->image().pixel(1, 1);
        QVERIFY(qRed(two) > 0 && qGreen(two) > 0);
        QCOMPARE(qBlue(two), 0);
    }

    void reducedLevelsKeepTheMean() {
        const auto picture = pictureOf(testTexture({512, 256}));
        const QImage& small = picture->levelFor(1.0 / 8);
        QCOMPARE(small.size(), QSize(64, 32));
        QCOMPARE(picture->levelFor(1).size(), QSize(512, 256));
        QVERIFY(std::abs(qRed(small.pixel(30, 15)) - 128) < 80);
    }

    void hoverTellsPixelsByMouseAndKeyboard() {
        ImageViewer viewer;
        viewer.resize(200, 200);
        viewer.setPicture(pictureOf(testTexture({100, 100})));
        QSignalSpy hovered(&viewer, &ImageViewer::hovered);
        viewer.show();
        QVERIFY(QTest::qWaitForWindowExposed(&viewer));
        QTest::mouseMove(&viewer, QPoint(21, 41));
        QTRY_VERIFY(!hovered.isEmpty());
        QCOMPARE(hovered.last().front().toPoint(), QPoint(10, 20));
        hovered.clear();
        QTest::keyClick(&viewer, Qt::Key_Right, Qt::ShiftModifier);
        QCOMPARE(hovered.last().front().toPoint(), QPoint(51, 50));
    }

    void markerIsSeenOnBlackAndWhite() {
        for (const float tone : {0.0F, 1.0F}) {
            Image flat({20, 20}, 1);
            for (int y = 0; y < 20; ++y)
                for (int x = 0; x < 20; ++x)
                    flat(x, y, 0) = tone;
            ImageViewer viewer;
            viewer.resize(160, 160);
            viewer.setPicture(pictureOf(flat));
            const QImage before = viewer.grab().toImage();
            viewer.setMarker(QPoint(10, 10));
            const QImage after = viewer.grab().toImage();
            int changed = 0;
            for (int y = 0; y < after.height(); ++y)
                for (int x = 0; x < after.width(); ++x)
                    changed += std::abs(qGray(after.pixel(x, y)) - qGray(before.pixel(x, y))) > 128;
            QVERIFY2(changed > 40, qPrintable(QString::number(changed)));
        }
    }

    void everyIconIsThereAndFollowsThePalette() {
        for (const char* name :
             {"open", "paste", "run", "stop", "quick", "dice", "lock", "wrap", "fit", "actual-size", "export",
              "reset", "zoom-in", "zoom-out", "folder-recent", "close", "crosshair", "help"}) {
            const QIcon drawn = icon(QLatin1String(name));
            QVERIFY2(!drawn.isNull(), name);
            const QImage image = drawn.pixmap(32, 32).toImage();
            const QColor text = QApplication::palette().color(QPalette::ButtonText);
            int opaque = 0;
            for (int y = 0; y < image.height(); ++y)
                for (int x = 0; x < image.width(); ++x)
                    if (qAlpha(image.pixel(x, y)) == 255) {
                        ++opaque;
                        QCOMPARE(QColor(image.pixel(x, y)), text);
                    }
            QVERIFY2(opaque > 10, name);
        }
    }
};

TEXLOOM_UI_TESTS(ViewerTest)
#include "viewer_test.moc"
