// What is painted in the window: masks, and what they do to a method that completes an image; pictures of
// flat colours, and what analogies make of them; pictures that are extended beyond their edges.

#include "core/image/extension.h"
#include "core/image/labels.h"
#include "core/image/selection.h"
#include "tests/ui/window_fixture.h"
#include "ui/common/appearance.h"
#include "ui/common/message_bar.h"
#include "ui/common/text.h"
#include "ui/compare/compare_view.h"
#include "ui/exemplar/files.h"
#include "ui/inspector/analogy_view.h"
#include "ui/inspector/inspector.h"
#include "ui/inspector/output_group.h"
#include "ui/inspector/port_row.h"
#include "ui/paint/extend_dialog.h"
#include "ui/paint/label_painter.h"
#include "ui/paint/mask_painter.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QSpinBox>
#include <QToolButton>

using namespace texloom;
using namespace texloom::ui;

namespace {

constexpr Size kPicture{64, 48};

/// The point of a canvas over the middle of a pixel.
QPoint over(const PaintCanvas& canvas, QPoint pixel) {
    return canvas.view().toWidget(QPointF(pixel) + QPointF(0.5, 0.5)).toPoint();
}

void drag(PaintCanvas& canvas, const std::vector<QPoint>& pixels, Qt::KeyboardModifiers keys = {}) {
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
void settled(const Painter& painter) {
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

/// A painter of flat colours with nothing painted, on its own.
std::unique_ptr<LabelPainter> loneLabels() {
    auto picture = std::make_shared<const Image>(testTexture(kPicture));
    auto painter = std::make_unique<LabelPainter>(std::make_shared<const DisplayPicture>(picture), true,
                                                  Image(kPicture, 1), labels::usualColours(3),
                                                  QStringLiteral("Flat colours for materials."));
    painter->show();
    settled(*painter);
    return painter;
}

/// Keeps pictures of a widget, light and dark, in the folder that the environment names, for people to look
/// at.
void look(QWidget& widget, const char* name) {
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

/// Answers the question that a painter asks before it loses something.
void answer(const Painter& painter, QMessageBox::ButtonRole role) {
    QTRY_VERIFY(painter.findChild<QMessageBox*>(QStringLiteral("paintLoss")));
    const auto* box = child<QMessageBox>(painter, "paintLoss");
    for (QAbstractButton* button : box->buttons())
        if (box->buttonRole(button) == role)
            return button->click();
    qFatal("no such answer");
}

void chooseTool(const Painter& painter, const char* name) {
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
        QVERIFY2(child<QLabel>(*painter, "paintLegend")->text().contains(QStringLiteral("is filled")),
                 "the legend says what the port's help says");
        chooseTool(*painter, "paintRectangle");
        drag(*painter->canvas(), {{20, 10}, {30, 25}, {41, 31}});
        const Image hole = rectangle(20, 10, 42, 32);
        QTRY_VERIFY(!painter->busy());
        QVERIFY(samePixels(painter->painted(), hole));
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
        QVERIFY2(samePixels(painter->painted(), hole), "a mask that is there is painted on");
        drag(*painter->canvas(), {{0, 0}, {3, 3}});
        painter->reject();
        answer(*painter, QMessageBox::DestructiveRole);
        QTRY_VERIFY(shownPainters().empty());
        QVERIFY(samePixels(*m_window->input(false).inputs.at("known").front().image(), *known.image()));
    }

    void theShownResultIsPaintedOnWhereNoPictureIsGiven() {
        openWindow();
        const Image before = m_window->desk()->result()->synthesis.image;
        MaskPainter* const painter = openPainter();
        QVERIFY(samePixels(painter->canvas()->picture()->values(), before));
        chooseTool(*painter, "paintLasso");
        const int right = before.width() / 2, bottom = before.height() / 2;
        drag(*painter->canvas(), {{2, 2}, {right, 3}, {right, bottom}, {3, bottom}});
        confirm(*painter);
        QTRY_VERIFY(m_window->input(false).inputs.contains("known"));
        const InputFiles inputs = m_window->input(false).inputs;
        QVERIFY(samePixels(*inputs.at("picture").front().image(), before));
        QVERIFY((*inputs.at("known").front().image())(right / 2, bottom / 2, 0) == 0);
        trigger(*m_window, "undo");
        QVERIFY2(m_window->input(false).inputs.empty(), "both came in one step");
    }

    void withoutAnyPictureThatIsSaid() {
        m_window = std::make_unique<MainWindow>();
        m_window->show();
        choose();
        child<QToolButton>(*m_window, "paint_known")->click();
        QVERIFY(m_window->messages()->text().startsWith(QStringLiteral("There is no picture")));
        trigger(*m_window, "compareInput");
        QVERIFY(m_window->messages()->text().startsWith(QStringLiteral("There is no result")));
    }

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
        QVERIFY(samePixels(painter->painted(), Image(kPicture, 1)));
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
        for (int y = 0; y < kPicture.height; ++y)
            for (int x = 0; x < kPicture.width; ++x)
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
        Image expected(kPicture, 1);
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

    void textureByNumbersNeedsNoOtherProgram() {
        openWindow();
        choose("analogy");
        child<QSpinBox>(*m_window, "outputWidth")->setValue(64);
        child<QSpinBox>(*m_window, "outputHeight")->setValue(48);
        auto* view = child<AnalogyView>(*m_window, "analogy");
        QTRY_VERIFY(view->isVisible());
        LabelPainter* painter = open<LabelPainter>("paint_guide");
        const ExemplarEntry* entry = m_window->store()->current();
        QVERIFY2(samePixels(painter->canvas()->picture()->values(), *entry->file().image),
                 "over the exemplar");
        QCOMPARE(painter->colours().size(), 8U);
        painter->setColour(2);
        chooseTool(*painter, "paintRectangle");
        drag(*painter->canvas(), {{0, 0}, {19, 35}});
        confirm(*painter);
        const auto ofA = [&] {
            const InputFiles& own = m_window->store()->current()->exemplar.inputs;
            return own.contains("guide") ? own.at("guide").front().image() : nullptr;
        };
        QTRY_VERIFY(ofA() != nullptr);
        QVERIFY(ofA()->size() == entry->file().image->size());
        const auto colours = labels::flatColours(*ofA(), 8);
        QCOMPARE(colours->size(), 2U);

        painter = open<LabelPainter>("paint_output-guide");
        QVERIFY2(painter->colours() == *colours, "B has the colours of A");
        QVERIFY(painter->painted().size() == (Size{64, 48}));
        painter->setColour(1);
        chooseTool(*painter, "paintRectangle");
        drag(*painter->canvas(), {{0, 0}, {63, 23}});
        confirm(*painter);
        QTRY_VERIFY(m_window->input(false).inputs.contains("output-guide"));
        run();
        QVERIFY(m_window->desk()->result()->synthesis.image.size() == (Size{64, 48}));
        QVERIFY(m_window->desk()->result()->plan.request.exemplars.front().inputs.image("guide") != nullptr);
        const Recipe recipe = m_window->desk()->result()->plan.recipe;

        child<QToolButton>(*m_window, "clear_guide")->click();
        QTRY_VERIFY(ofA() == nullptr);
        trigger(*m_window, "undo");
        QTRY_VERIFY2(ofA() != nullptr, "what was cleared comes back");
        choose("quilting");
        QVERIFY2(m_window->input(false).exemplars.front().inputs.empty(), "quilting takes no A");
        m_window->restoreRecipe(recipe, false);
        QTRY_COMPARE(m_window->inspector()->method()->id(), std::string("analogy"));
        QTRY_VERIFY(ofA() != nullptr && m_window->input(false).inputs.contains("output-guide"));
        QVERIFY(samePixels(labels::pictureOf(labels::indicesOf(*ofA(), *colours), *colours), *ofA()));
    }

    void analogiesShowTwoByTwoByTheirDeclaration() {
        openWindow();
        QVERIFY(m_window->findChild<AnalogyView*>() == nullptr);
        choose("texture-transfer");
        QVERIFY2(m_window->findChild<AnalogyView*>() != nullptr, "it has a picture for either");
        choose("analogy");
        auto* view = child<AnalogyView>(*m_window, "analogy");
        const auto pictured = [view](const char* picture) {
            return !child<QToolButton>(*view, picture)->icon().isNull();
        };
        QTRY_VERIFY(pictured("analogyExemplar") && pictured("analogyResult"));
        QVERIFY(!pictured("choose_guide") && !pictured("choose_output-guide"));
        child<QToolButton>(*view, "useResult_output-guide")->click();
        QTRY_VERIFY(m_window->input(false).inputs.contains("output-guide"));
        QTRY_VERIFY(pictured("choose_output-guide"));
        child<QToolButton>(*view, "useResult_guide")->click();
        QTRY_VERIFY2(m_window->messages()->text().contains(QStringLiteral("must be the same size")),
                     qPrintable(m_window->messages()->text()));
        QVERIFY2(!pictured("choose_guide"), "what does not fit is not shown");
        const QString same = writeTexture(m_folder, QStringLiteral("labels.png"), {40, 36}, 8);
        child<PortRow>(*view, "port_guide")->read(same);
        QTRY_VERIFY(pictured("choose_guide"));
        QTRY_VERIFY(m_window->store()->current()->exemplar.inputs.contains("guide"));
        child<QToolButton>(*view, "useResult_exemplar")->click();
        QTRY_COMPARE(m_window->store()->entries().size(), 2U);
        QTRY_VERIFY2(!pictured("choose_guide"), "the other exemplar has no A yet");
        settle();
        QCOMPARE(cutText(*view), QString());
        QCOMPARE(namelessControls(*view), QStringList());
        m_window->resize(1366, 768);
        settle();
        QVERIFY(m_window->width() <= 1366);
        QVERIFY2(view->height() < 400, "it fits beside all else");
        look(*m_window, "analogy");
    }

    void aPictureIsExtendedBeyondItsEdges() {
        openWindow();
        child<PortRow>(*m_window, "port_picture")->add(loadExemplar(toPath(m_picture)));
        auto* dialog = open<ExtendDialog>("extend_known");
        auto* ok = child<QDialogButtonBox>(*dialog, "extendButtons")->button(QDialogButtonBox::Ok);
        QVERIFY2(!ok->isEnabled(), "nothing is asked for yet");
        const std::pair<const char*, int> sides[] = {
            {"extendLeft", 6}, {"extendTop", 3}, {"extendRight", 10}, {"extendBottom", 0}};
        for (const auto& [name, pixels] : sides)
            child<QSpinBox>(*dialog, name)->setValue(pixels);
        QVERIFY(child<QLabel>(*dialog, "extendSize")->text().contains(QStringLiteral("80 × 51")));
        QCOMPARE(cutText(*dialog), QString());
        QCOMPARE(namelessControls(*dialog), QStringList());
        look(*dialog, "extend");
        look(*m_window, "holes");
        ok->click();
        QTRY_VERIFY(m_window->input(false).inputs.contains("known"));
        QVERIFY(m_window->inspector()->output()->outputSize() == (Size{80, 51}));
        const Image picture = *loadExemplar(toPath(m_picture)).image;
        const InputFiles inputs = m_window->input(false).inputs;
        const Image known = extended(selections::inverted(Image(kPicture, 1)), {6, 3, 10, 0}, {0});
        QVERIFY(samePixels(*inputs.at("known").front().image(), known));
        QVERIFY(samePixels(inputs.at("picture").front().image()->view().crop(6, 3, kPicture), picture));
        run();
        QVERIFY(samePixels(m_window->desk()->result()->synthesis.image.view().crop(6, 3, kPicture), picture));
        comparesWithTheBefore(*inputs.at("picture").front().image());
        trigger(*m_window, "undo");
        QVERIFY2(!m_window->input(false).inputs.contains("known"), "all of it was one step");

        choose("efros-leung");
        trigger(*m_window, "extendCanvas");
        QTRY_VERIFY(m_window->findChild<ExtendDialog*>() != nullptr);
        m_window->findChild<ExtendDialog*>()->reject();
        choose("random-phase");
        trigger(*m_window, "extendCanvas");
        QVERIFY2(m_window->messages()->text().contains(QStringLiteral("Efros–Leung")),
                 "it says which methods complete pictures");
    }

    void cleanup() { m_window.reset(); }

private:
    void choose(const char* id = "fill-hole") {
        auto* method = child<QComboBox>(*m_window, "method");
        method->setCurrentIndex(method->findData(QLatin1String(id)));
        QCOMPARE(m_window->inspector()->method()->id(), std::string(id));
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

    QList<Painter*> shownPainters() const {
        QList<Painter*> shown = m_window->findChildren<Painter*>();
        shown.removeIf([](const Painter* painter) { return !painter->isVisible(); });
        return shown;
    }

    /// The dialog that a button opens, once it is at rest.
    template <class Dialog> Dialog* open(const char* button) {
        child<QToolButton>(*m_window, button)->click();
        Dialog* dialog = nullptr;
        [[maybe_unused]] const bool opened = QTest::qWaitFor([&] {
            for (auto* found : m_window->findChildren<Dialog*>())
                if (found->isVisible())
                    dialog = found;
            return dialog != nullptr;
        });
        if (dialog == nullptr)
            qFatal("nothing opened: %s", qPrintable(m_window->messages()->text()));
        if (const auto* painter = qobject_cast<const Painter*>(dialog))
            settled(*painter);
        return dialog;
    }

    MaskPainter* openPainter() { return open<MaskPainter>("paint_known"); }

    static void confirm(const Painter& painter) {
        child<QDialogButtonBox>(painter, "paintButtons")->button(QDialogButtonBox::Ok)->click();
    }

    void run() {
        QTRY_VERIFY(!m_window->desk()->running());
        QSignalSpy shown(m_window->desk(), &RunDesk::shown);
        m_window->startRun(false);
        QVERIFY2(shown.wait(60'000), qPrintable(m_window->messages()->text()));
    }

    void comparesWithTheBefore(const Image& picture) {
        trigger(*m_window, "compareInput");
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
