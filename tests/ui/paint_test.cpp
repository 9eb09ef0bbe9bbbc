// Masks that are painted in the window: what they do to a method that completes an image, and how they come
// about.

#include "core/image/selection.h"
#include "tests/ui/window_fixture.h"
#include "ui/common/message_bar.h"
#include "ui/common/text.h"
#include "ui/compare/compare_view.h"
#include "ui/exemplar/files.h"
#include "ui/inspector/inspector.h"
#include "ui/inspector/output_group.h"
#include "ui/inspector/port_row.h"
#include "ui/paint/mask_canvas.h"
#include "ui/paint/mask_painter.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QToolButton>

using namespace texloom;
using namespace texloom::ui;

namespace {

constexpr Size kPicture{64, 48};

/// The point of a canvas over the middle of a pixel.
QPoint over(const MaskCanvas& canvas, QPoint pixel) {
    return canvas.view().toWidget(QPointF(pixel) + QPointF(0.5, 0.5)).toPoint();
}

void drag(MaskCanvas& canvas, const std::vector<QPoint>& pixels, Qt::KeyboardModifiers keys = {}) {
    QTest::mousePress(&canvas, Qt::LeftButton, keys, over(canvas, pixels.front()));
    for (const QPoint& pixel : pixels)
        QTest::mouseMove(&canvas, over(canvas, pixel));
    QTest::mouseRelease(&canvas, Qt::LeftButton, keys, over(canvas, pixels.back()));
}

/// The selection of a rectangle of whole pixels.
Image rectangle(int left, int top, int right, int bottom) {
    const double x0 = left, y0 = top, x1 = right, y1 = bottom;
    return selections::polygon(kPicture, {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}});
}

/// Waits until a painter shows what is painted.
void settled(const MaskPainter& painter) {
    settle();
    if (!QTest::qWaitFor([&] { return !painter.busy(); }))
        qFatal("the painter did not come to rest");
}

/// A painter with nothing painted, on its own.
std::unique_ptr<MaskPainter> lonePainter() {
    auto picture = std::make_shared<const Image>(testTexture(kPicture));
    auto painter = std::make_unique<MaskPainter>(std::make_shared<const DisplayPicture>(picture),
                                                 Image(kPicture, 1), QStringLiteral("Black is made anew."));
    painter->show();
    settled(*painter);
    return painter;
}

void chooseTool(const MaskPainter& painter, const char* name) {
    child<QToolButton>(painter, name)->click();
}

} // namespace

class PaintTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aHoleThatIsPaintedIsFilledAndTheRestIsKeptBitForBit() {
        openWindow();
        child<PortRow>(*m_window, "port_picture")->add(loadExemplar(toPath(m_picture)));
        MaskPainter* painter = openPainter();
        QVERIFY2(child<QLabel>(*painter, "maskLegend")->text().contains(QStringLiteral("is filled")),
                 "the legend says what the port's help says");
        chooseTool(*painter, "maskRectangle");
        drag(*painter->canvas(), {{20, 10}, {30, 25}, {41, 31}});
        const Image hole = rectangle(20, 10, 42, 32);
        QTRY_VERIFY(!painter->busy());
        QVERIFY(samePixels(painter->selection(), hole));
        confirm(*painter);
        QTRY_VERIFY(m_window->input(false).inputs.contains("known"));
        QVERIFY(m_window->inspector()->output()->outputSize() == kPicture);
        const InputFile known = m_window->input(false).inputs.at("known").front();
        QVERIFY(samePixels(*known.image(), selections::inverted(hole)));
        QVERIFY(toQString(known.file.path).startsWith(ownFolder()));

        run();
        const Image& made = m_window->desk()->result()->synthesis.image;
        const Image picture = *loadExemplar(toPath(m_picture)).image;
        const Image exemplar = *m_window->store()->current()->file().image;
        for (int c = 0; c < 3; ++c)
            for (int y = 0; y < kPicture.height; ++y)
                for (int x = 0; x < kPicture.width; ++x)
                    QVERIFY(made(x, y, c) ==
                            (hole(x, y, 0) == 0 ? picture(x, y, c)
                                                : exemplar(x % exemplar.width(), y % exemplar.height(), c)));
        comparesWithTheBefore(picture);

        painter = openPainter();
        QVERIFY2(samePixels(painter->selection(), hole), "a mask that is there is painted on");
        drag(*painter->canvas(), {{0, 0}, {3, 3}});
        painter->reject();
        QVERIFY(samePixels(*m_window->input(false).inputs.at("known").front().image(), *known.image()));
    }

    void theShownResultIsPaintedOnWhereNoPictureIsGiven() {
        openWindow();
        const Image before = m_window->desk()->result()->synthesis.image;
        MaskPainter* const painter = openPainter();
        QVERIFY(samePixels(painter->canvas()->picture()->values(), before));
        chooseTool(*painter, "maskLasso");
        const int right = before.width() / 2, bottom = before.height() / 2;
        drag(*painter->canvas(), {{2, 2}, {right, 3}, {right, bottom}, {3, bottom}});
        confirm(*painter);
        QTRY_VERIFY(m_window->input(false).inputs.contains("known"));
        const InputFiles inputs = m_window->input(false).inputs;
        QVERIFY(samePixels(*inputs.at("picture").front().image(), before));
        QVERIFY((*inputs.at("known").front().image())(right / 2, bottom / 2, 0) == 0);
        child<QAction>(*m_window, "undo")->trigger();
        QVERIFY2(m_window->input(false).inputs.empty(), "both came in one step");
    }

    void withoutAnyPictureThatIsSaid() {
        m_window = std::make_unique<MainWindow>();
        m_window->show();
        choose();
        child<QToolButton>(*m_window, "paint_known")->click();
        QVERIFY(m_window->messages()->text().startsWith(QStringLiteral("There is no picture")));
        child<QAction>(*m_window, "compareInput")->trigger();
        QVERIFY(m_window->messages()->text().startsWith(QStringLiteral("There is no result")));
    }

    void everyToolPaintsAndAltTakesAway() {
        const auto painter = lonePainter();
        MaskCanvas& canvas = *painter->canvas();
        const auto selected = [&](int x, int y) { return painter->selection()(x, y, 0); };
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

        chooseTool(*painter, "maskPolygon");
        for (const QPoint corner : {QPoint(40, 20), QPoint(60, 20), QPoint(50, 40)})
            QTest::mouseClick(&canvas, Qt::LeftButton, {}, over(canvas, corner));
        QVERIFY2(!painter->busy(), "it is not closed yet");
        QTest::mouseDClick(&canvas, Qt::LeftButton, {}, over(canvas, {50, 40}));
        QTRY_VERIFY(!painter->busy() && selected(50, 25) == 1);
        QCOMPARE(selected(42, 38), 0.0F);

        chooseTool(*painter, "maskLasso");
        child<QCheckBox>(*painter, "maskTakeAway")->setChecked(true);
        drag(canvas, {{44, 22}, {56, 22}, {56, 30}, {44, 30}});
        QTRY_VERIFY(!painter->busy() && selected(50, 25) == 0);
        QCOMPARE(selected(50, 36), 1.0F);
    }

    void stepsAreUndoneAndRedone() {
        const auto painter = lonePainter();
        QVERIFY(QTest::qWaitForWindowActive(painter.get()));
        auto* undo = child<QPushButton>(*painter, "maskUndo");
        auto* redo = child<QPushButton>(*painter, "maskRedo");
        QVERIFY(!undo->isEnabled() && !redo->isEnabled());
        chooseTool(*painter, "maskRectangle");
        drag(*painter->canvas(), {{5, 5}, {20, 20}});
        child<QPushButton>(*painter, "maskInvert")->click();
        QTRY_VERIFY(!painter->busy());
        const Image first = rectangle(5, 5, 21, 21), second = selections::inverted(first);
        QVERIFY(samePixels(painter->selection(), second));
        undo->click();
        QTRY_VERIFY(!painter->busy());
        QVERIFY(samePixels(painter->selection(), first));
        QTest::keyClick(painter->canvas(), Qt::Key_Z, Qt::ControlModifier);
        QTRY_VERIFY(!painter->busy());
        QVERIFY(samePixels(painter->selection(), Image(kPicture, 1)));
        QVERIFY(!undo->isEnabled() && redo->isEnabled());
        for (int i = 0; i < 2; ++i)
            QTest::keyClick(painter->canvas(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QTRY_VERIFY(!painter->busy());
        QVERIFY(samePixels(painter->selection(), second));
        child<QPushButton>(*painter, "maskClear")->click();
        QTRY_VERIFY(!painter->busy());
        QCOMPARE(valueRange(painter->selection()).largest, 0.0F);
    }

    void edgesGrowShrinkAndSoften() {
        const auto painter = lonePainter();
        chooseTool(*painter, "maskRectangle");
        drag(*painter->canvas(), {{20, 15}, {35, 30}});
        QTRY_VERIFY(!painter->busy());
        Image expected = rectangle(20, 15, 36, 31);
        QVERIFY(samePixels(painter->selection(), expected));
        child<QSpinBox>(*painter, "maskPixels")->setValue(3);
        const std::pair<const char*, Image (*)(const ImageView&, int, const std::function<void()>&)> ways[] =
            {{"maskGrow", &selections::grown},
             {"maskShrink", &selections::shrunk},
             {"maskFeather", &selections::feathered}};
        for (const auto& [name, filter] : ways) {
            child<QPushButton>(*painter, name)->click();
            expected = filter(expected, 3, [] {});
            QTRY_VERIFY(!painter->busy());
            QVERIFY2(samePixels(painter->selection(), expected), name);
        }
        QVERIFY(valueRange(expected).largest == 1 && expected(18, 20, 0) > 0 && expected(18, 20, 0) < 1);
    }

    void keysDoWhatTheMouseDoes() {
        const auto painter = lonePainter();
        QVERIFY(QTest::qWaitForWindowActive(painter.get()));
        MaskCanvas* const canvas = painter->canvas();
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
        for (int y = 0; y < kPicture.height; ++y)
            for (int x = 0; x < kPicture.width; ++x)
                dabbed += static_cast<double>(painter->selection()(x, y, 0));
        QVERIFY2(dabbed >= 1 && dabbed <= 4, "a brush as small as can be");

        child<QPushButton>(*painter, "maskClear")->click();
        chooseTool(*painter, "maskPolygon");
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
        QCOMPARE(valueRange(painter->selection()).largest, 1.0F);
    }

    void thePainterIsWholeAndNamed() {
        const auto painter = lonePainter();
        QVERIFY(QTest::qWaitForWindowExposed(painter.get()));
        settle();
        QVERIFY(painter->width() <= 1280);
        QCOMPARE(cutText(*painter), QString());
        QCOMPARE(namelessControls(*painter), QStringList());
        if (const QString folder = qEnvironmentVariable("TEXLOOM_LOOK"); !folder.isEmpty()) {
            chooseTool(*painter, "maskLasso");
            drag(*painter->canvas(), {{10, 10}, {40, 12}, {44, 30}, {25, 38}, {8, 26}});
            QTRY_VERIFY(!painter->busy());
            painter->grab().save(folder + QStringLiteral("/painter.png"));
        }
    }

    void cleanup() { m_window.reset(); }

private:
    void choose() {
        auto* method = child<QComboBox>(*m_window, "method");
        method->setCurrentIndex(method->findData(QStringLiteral("fill-hole")));
        QCOMPARE(m_window->inspector()->method()->id(), std::string("fill-hole"));
    }

    /// With an exemplar, a first result, and the method that completes images.
    void openWindow() {
        m_window = std::make_unique<MainWindow>();
        m_window->show();
        m_picture = writeTexture(m_folder, QStringLiteral("photo.png"), kPicture, 3);
        QVERIFY(openAndFinish(*m_window, writeTexture(m_folder, QStringLiteral("felt.png"), {40, 36})));
        choose();
        settle();
        QVERIFY(m_window->width() <= 1280);
        QVERIFY2(child<QToolButton>(*m_window, "paint_picture")->isHidden(), "only masks are painted");
    }

    MaskPainter* openPainter() {
        child<QToolButton>(*m_window, "paint_known")->click();
        MaskPainter* painter = nullptr;
        [[maybe_unused]] const bool opened = QTest::qWaitFor([&] {
            for (auto* found : m_window->findChildren<MaskPainter*>())
                if (found->isVisible())
                    painter = found;
            return painter != nullptr;
        });
        if (painter == nullptr)
            qFatal("no painter opened: %s", qPrintable(m_window->messages()->text()));
        settled(*painter);
        return painter;
    }

    static void confirm(const MaskPainter& painter) {
        child<QDialogButtonBox>(painter, "maskButtons")->button(QDialogButtonBox::Ok)->click();
    }

    void run() {
        QTRY_VERIFY(!m_window->desk()->running());
        QSignalSpy shown(m_window->desk(), &RunDesk::shown);
        m_window->startRun(false);
        QVERIFY2(shown.wait(60'000), qPrintable(m_window->messages()->text()));
    }

    void comparesWithTheBefore(const Image& picture) {
        child<QAction>(*m_window, "compareInput")->trigger();
        const CompareView* const view = m_window->compare();
        QTRY_COMPARE(view->mode(), CompareMode::Wipe);
        QCOMPARE(view->items().size(), 2U);
        QVERIFY(samePixels(view->items()[0].picture->values(), picture));
        QVERIFY(samePixels(view->items()[1].picture->values(), m_window->desk()->result()->synthesis.image));
        QTRY_VERIFY(view->isVisible());
    }

    QTemporaryDir m_folder;
    QString m_picture;
    std::unique_ptr<MainWindow> m_window;
};

TEXLOOM_UI_TESTS(PaintTest)
#include "paint_test.moc"
