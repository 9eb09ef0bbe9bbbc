// The painters on their own: masks, and pictures of flat colours, by mouse and by keys.

#include "core/image/labels.h"
#include "core/image/selection.h"
#include "tests/ui/painting.h"
#include "ui/paint/label_painter.h"
#include "ui/paint/mask_painter.h"

#include <QCheckBox>
#include <QDialog>
#include <QMessageBox>
#include <QPushButton>
#include <QSlider>
#include <QSpinBox>
#include <QToolButton>

#include <memory>

using namespace texloom;
using namespace texloom::ui;

namespace {

/// The selection of a rectangle of whole pixels.
Image rectangle(int left, int top, int right, int bottom) {
    const double x0 = left, y0 = top, x1 = right, y1 = bottom;
    return selections::polygon(kPainted, {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}});
}

/// A painter with nothing painted, on its own.
std::unique_ptr<MaskPainter> lonePainter() {
    auto picture = std::make_shared<const Image>(testTexture(kPainted));
    auto painter = std::make_unique<MaskPainter>(std::make_shared<const DisplayPicture>(picture),
                                                 Image(kPainted, 1), QStringLiteral("Black is made anew."));
    painter->show();
    settled(*painter);
    return painter;
}

/// A painter of flat colours with nothing painted, on its own.
std::unique_ptr<LabelPainter> loneLabels() {
    auto picture = std::make_shared<const Image>(testTexture(kPainted));
    auto painter = std::make_unique<LabelPainter>(std::make_shared<const DisplayPicture>(picture), true,
                                                  Image(kPainted, 1), labels::usualColours(3),
                                                  QStringLiteral("Flat colours for materials."));
    painter->show();
    settled(*painter);
    return painter;
}

} // namespace

class PaintersTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void everyToolPaintsAndAltTakesAway() {
        const auto painter = lonePainter();
        PaintCanvas& canvas = *painter->canvas();
        const auto selected = [&](int x, int y) { return painter->painted()(x, y, 0); };
        canvas.setBrushSize(6);
        drag(canvas, {{10, 10}, {30, 10}});
        QTRY_VERIFY(!painter->busy());
        QCOMPARE(selected(20, 10), 1.0F);
        QCOMPARE(selected(20, 12), 1.0F);
        QCOMPARE(selected(20, 16), 0.0F);
        drag(canvas, {{20, 5}, {20, 15}}, Qt::AltModifier);
        QTRY_VERIFY(!painter->busy());
        QCOMPARE(selected(20, 10), 0.0F);
        QCOMPARE(selected(12, 10), 1.0F);

        chooseTool(*painter, "paintPolygon");
        for (const QPoint corner : {QPoint(40, 20), QPoint(60, 20), QPoint(50, 40)})
            QTest::mouseClick(&canvas, Qt::LeftButton, {}, over(canvas, corner));
        QVERIFY2(!painter->busy(), "it is not closed yet");
        QTest::mouseDClick(&canvas, Qt::LeftButton, {}, over(canvas, {50, 40}));
        QTRY_VERIFY(!painter->busy() && selected(50, 25) == 1);
        QCOMPARE(selected(42, 38), 0.0F);

        chooseTool(*painter, "paintLasso");
        child<QCheckBox>(*painter, "maskTakeAway")->setChecked(true);
        drag(canvas, {{44, 22}, {56, 22}, {56, 30}, {44, 30}});
        QTRY_VERIFY(!painter->busy() && selected(50, 25) == 0);
        QCOMPARE(selected(50, 36), 1.0F);
    }

    void stepsAreUndoneAndRedone() {
        const auto painter = lonePainter();
        QVERIFY(QTest::qWaitForWindowActive(painter.get()));
        auto* undo = child<QPushButton>(*painter, "paintUndo");
        auto* redo = child<QPushButton>(*painter, "paintRedo");
        QVERIFY(!undo->isEnabled() && !redo->isEnabled());
        chooseTool(*painter, "paintRectangle");
        drag(*painter->canvas(), {{5, 5}, {20, 20}});
        child<QPushButton>(*painter, "maskInvert")->click();
        QTRY_VERIFY(!painter->busy());
        const Image first = rectangle(5, 5, 21, 21), second = selections::inverted(first);
        QVERIFY(samePixels(painter->painted(), second));
        undo->click();
        QTRY_VERIFY(!painter->busy());
        QVERIFY(samePixels(painter->painted(), first));
        QTest::keyClick(painter->canvas(), Qt::Key_Z, Qt::ControlModifier);
        QTRY_VERIFY(!painter->busy());
        QVERIFY(samePixels(painter->painted(), Image(kPainted, 1)));
        QVERIFY(!undo->isEnabled() && redo->isEnabled());
        for (int i = 0; i < 2; ++i)
            QTest::keyClick(painter->canvas(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QTRY_VERIFY(!painter->busy());
        QVERIFY(samePixels(painter->painted(), second));
        child<QPushButton>(*painter, "maskClear")->click();
        QTRY_VERIFY(!painter->busy());
        QCOMPARE(valueRange(painter->painted()).largest, 0.0F);
    }

    void edgesGrowShrinkAndSoften() {
        const auto painter = lonePainter();
        chooseTool(*painter, "paintRectangle");
        drag(*painter->canvas(), {{20, 15}, {35, 30}});
        QTRY_VERIFY(!painter->busy());
        Image expected = rectangle(20, 15, 36, 31);
        QVERIFY(samePixels(painter->painted(), expected));
        child<QSpinBox>(*painter, "maskPixels")->setValue(3);
        const std::pair<const char*, Image (*)(const ImageView&, int, const std::function<void()>&)> ways[] =
            {{"maskGrow", &selections::grown},
             {"maskShrink", &selections::shrunk},
             {"maskFeather", &selections::feathered}};
        for (const auto& [name, filter] : ways) {
            child<QPushButton>(*painter, name)->click();
            expected = filter(expected, 3, [] {});
            QTRY_VERIFY(!painter->busy());
            QVERIFY2(samePixels(painter->painted(), expected), name);
        }
        QVERIFY(valueRange(expected).largest == 1 && expected(18, 20, 0) > 0 && expected(18, 20, 0) < 1);
    }

    void keysDoWhatTheMouseDoes() {
        const auto painter = lonePainter();
        QVERIFY(QTest::qWaitForWindowActive(painter.get()));
        PaintCanvas* const canvas = painter->canvas();
        canvas->setFocus();
        const int size = canvas->brushSize();
        QTest::keyClick(canvas, Qt::Key_BracketRight);
        QVERIFY(canvas->brushSize() > size);
        for (int i = 0; i < 60; ++i)
            QTest::keyClick(canvas, Qt::Key_BracketLeft);
        QCOMPARE(canvas->brushSize(), 1);
        QTest::keyClick(canvas, Qt::Key_Right, Qt::ShiftModifier);
        QTest::keyClick(canvas, Qt::Key_Space);
        QTRY_VERIFY(!painter->busy());
        double dabbed = 0;
        for (int y = 0; y < kPainted.height; ++y)
            for (int x = 0; x < kPainted.width; ++x)
                dabbed += static_cast<double>(painter->painted()(x, y, 0));
        QVERIFY2(dabbed >= 1 && dabbed <= 4, "a brush as small as can be");

        child<QPushButton>(*painter, "maskClear")->click();
        chooseTool(*painter, "paintPolygon");
        const auto go = [&](Qt::Key key, int times) {
            for (int i = 0; i < times; ++i)
                QTest::keyClick(canvas, key, Qt::ShiftModifier);
            QTest::keyClick(canvas, Qt::Key_Space);
        };
        go(Qt::Key_Left, 10);
        go(Qt::Key_Right, 20);
        go(Qt::Key_Down, 12);
        QTest::keyClick(canvas, Qt::Key_Escape);
        QVERIFY2(painter->isVisible(), "Escape drops the shape alone");
        go(Qt::Key_Left, 10);
        go(Qt::Key_Up, 12);
        go(Qt::Key_Left, 5);
        QTest::keyClick(canvas, Qt::Key_Backspace);
        go(Qt::Key_Down, 12);
        QTest::keyClick(canvas, Qt::Key_Return);
        QTRY_VERIFY(!painter->busy());
        QVERIFY2(painter->isVisible(), "Enter closes the shape alone");
        QCOMPARE(valueRange(painter->painted()).largest, 1.0F);
    }

    void thePainterIsWholeAndNamed() {
        const auto painter = lonePainter();
        QVERIFY(QTest::qWaitForWindowExposed(painter.get()));
        settle();
        QVERIFY(painter->width() <= 1280);
        QCOMPARE(cutText(*painter), QString());
        QCOMPARE(namelessControls(*painter), QStringList());
        chooseTool(*painter, "paintLasso");
        drag(*painter->canvas(), {{10, 10}, {40, 12}, {44, 30}, {25, 38}, {8, 26}});
        QTRY_VERIFY(!painter->busy());
        look(*painter, "painter");
    }

    void closingAsksBeforeStrokesAreLost() {
        const auto painter = lonePainter();
        painter->reject();
        QVERIFY2(!painter->isVisible(), "nothing was painted");
        painter->show();
        chooseTool(*painter, "paintRectangle");
        drag(*painter->canvas(), {{5, 5}, {20, 20}});
        painter->close();
        QVERIFY2(painter->isVisible(), "it asks first");
        answer(*painter, QMessageBox::RejectRole);
        QVERIFY(painter->isVisible());
        QTRY_VERIFY(!painter->findChild<QMessageBox*>());
        QTest::keyClick(painter->canvas(), Qt::Key_Escape);
        answer(*painter, QMessageBox::DestructiveRole);
        QVERIFY(!painter->isVisible());
        QCOMPARE(painter->result(), int(QDialog::Rejected));

        const auto kept = lonePainter();
        drag(*kept->canvas(), {{5, 5}, {20, 20}});
        kept->reject();
        answer(*kept, QMessageBox::AcceptRole);
        QTRY_COMPARE(kept->result(), int(QDialog::Accepted));

        const auto undone = lonePainter();
        drag(*undone->canvas(), {{5, 5}, {20, 20}});
        QTRY_VERIFY(!undone->busy());
        child<QPushButton>(*undone, "paintUndo")->click();
        QTRY_VERIFY(!undone->busy());
        undone->reject();
        QVERIFY2(!undone->isVisible(), "what was undone is not lost");
    }

    void coloursArePaintedFilledAndPicked() {
        const auto painter = loneLabels();
        PaintCanvas& canvas = *painter->canvas();
        const auto at = [&](int x, int y) { return painter->painted()(x, y, 0); };
        child<QToolButton>(*painter, "paintColour3")->click();
        chooseTool(*painter, "paintRectangle");
        drag(canvas, {{10, 10}, {30, 30}});
        QTRY_VERIFY(!painter->busy());
        QCOMPARE(at(10, 10), 2.0F);
        QCOMPARE(at(30, 30), 2.0F);
        QCOMPARE(at(31, 30), 0.0F);
        painter->setColour(1);
        chooseTool(*painter, "paintFill");
        QTest::mouseClick(&canvas, Qt::LeftButton, {}, over(canvas, {20, 20}));
        QTRY_VERIFY(!painter->busy());
        Image expected(kPainted, 1);
        expected = labels::painted(expected, rectangle(10, 10, 31, 31), 1);
        QVERIFY(samePixels(painter->painted(), expected));
        painter->setColour(5);
        chooseTool(*painter, "paintPick");
        QTest::mouseClick(&canvas, Qt::LeftButton, {}, over(canvas, {20, 20}));
        QTRY_COMPARE(painter->colour(), 1);
        QVERIFY2(child<QToolButton>(*painter, "paintBrush")->isChecked(), "the brush follows");
        QTest::mouseClick(&canvas, Qt::LeftButton, Qt::AltModifier, over(canvas, {2, 2}));
        QTRY_COMPARE(painter->colour(), 0);
        QVERIFY2(samePixels(painter->painted(), expected), "picking paints nothing");
        child<QPushButton>(*painter, "paintUndo")->click();
        QTRY_VERIFY(!painter->busy());
        QCOMPARE(at(20, 20), 2.0F);
        painter->setColour(4);
        child<QPushButton>(*painter, "paintWhole")->click();
        QTRY_VERIFY(!painter->busy());
        QCOMPARE(valueRange(painter->painted()).smallest, 4.0F);
    }

    void theColoursShowAsTheyAreAndThePictureThroughThem() {
        const auto painter = loneLabels();
        painter->setColour(3);
        chooseTool(*painter, "paintRectangle");
        drag(*painter->canvas(), {{0, 0}, {20, 20}});
        QTRY_VERIFY(!painter->busy());
        QCOMPARE(painter->canvas()->veil().pixel(5, 5), qRgb(213, 94, 0));
        const QPoint place = over(*painter->canvas(), {10, 10});
        const auto shown = [&] { return painter->canvas()->grab().toImage().pixelColor(place); };
        auto* showing = child<QSlider>(*painter, "paintShowing");
        QVERIFY2(showing->value() > 0, "the picture shows faintly");
        showing->setValue(0);
        QCOMPARE(shown(), QColor(213, 94, 0));
        showing->setValue(100);
        const QColor through = shown();
        painter->canvas()->setVeil({});
        QCOMPARE(shown(), through);
        QVERIFY(through != QColor(213, 94, 0));
    }

    void coloursArePaintedByKeysAlone() {
        const auto painter = loneLabels();
        QVERIFY(QTest::qWaitForWindowActive(painter.get()));
        PaintCanvas* const canvas = painter->canvas();
        canvas->setFocus();
        QTest::keyClick(canvas, Qt::Key_4, Qt::AltModifier);
        QCOMPARE(painter->colour(), 3);
        QTest::keyClick(canvas, Qt::Key_F, Qt::AltModifier);
        QTRY_COMPARE(canvas->tool(), PaintCanvas::Tool::Fill);
        QTest::keyClick(canvas, Qt::Key_Right, Qt::ShiftModifier);
        QTest::keyClick(canvas, Qt::Key_Space);
        QTRY_VERIFY(!painter->busy() && valueRange(painter->painted()).smallest == 3);
        QTest::keyClick(canvas, Qt::Key_2, Qt::AltModifier);
        QTest::keyClick(canvas, Qt::Key_I, Qt::AltModifier);
        QTRY_COMPARE(canvas->tool(), PaintCanvas::Tool::Pick);
        QTest::keyClick(canvas, Qt::Key_Left, Qt::ShiftModifier);
        QTest::keyClick(canvas, Qt::Key_Space);
        QTRY_COMPARE(painter->colour(), 3);
    }

    void thePainterOfColoursIsWholeAndNamed() {
        const auto painter = loneLabels();
        QVERIFY(QTest::qWaitForWindowExposed(painter.get()));
        settle();
        QVERIFY(painter->width() <= 1280);
        QVERIFY(painter->height() <= 768);
        painter->setColour(1);
        chooseTool(*painter, "paintLasso");
        drag(*painter->canvas(), {{10, 10}, {40, 12}, {44, 30}, {25, 38}, {8, 26}});
        QTRY_VERIFY(!painter->busy());
        look(*painter, "labels");
        QCOMPARE(cutText(*painter), QString());
        QCOMPARE(namelessControls(*painter), QStringList());
    }
};

TEXLOOM_UI_TESTS(PaintersTest)
#include "painters_test.moc"
