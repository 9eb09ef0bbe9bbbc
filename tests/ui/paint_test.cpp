// What is painted in the window, and what it does: masks to a method that completes an image, pictures of
// flat colours to analogies; and pictures that are extended beyond their edges.

#include "core/image/extension.h"
#include "core/image/labels.h"
#include "core/image/selection.h"
#include "tests/ui/painting.h"
#include "tests/ui/window_fixture.h"
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
#include <QComboBox>
#include <QDialogButtonBox>
#include <QLabel>
#include <QMessageBox>
#include <QSignalSpy>
#include <QSpinBox>
#include <QToolButton>

using namespace texloom;
using namespace texloom::ui;

namespace {

/// The selection of a rectangle of whole pixels.
Image rectangle(int left, int top, int right, int bottom) {
    const double x0 = left, y0 = top, x1 = right, y1 = bottom;
    return selections::polygon(kPainted, {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}});
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
        QVERIFY(m_window->inspector()->output()->outputSize() == kPainted);
        const InputFile known = m_window->input(false).inputs.at("known").front();
        QVERIFY(samePixels(*known.image(), selections::inverted(hole)));
        QVERIFY(toQString(known.file.path).startsWith(ownFolder()));

        run();
        const Image& made = m_window->desk()->result()->synthesis.image;
        const Image picture = *loadExemplar(toPath(m_picture)).image;
        const Image exemplar = *m_window->store()->current()->file().image;
        for (int c = 0; c < 3; ++c)
            for (int y = 0; y < kPainted.height; ++y)
                for (int x = 0; x < kPainted.width; ++x)
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
        const Image known = extended(selections::inverted(Image(kPainted, 1)), {6, 3, 10, 0}, {0});
        QVERIFY(samePixels(*inputs.at("known").front().image(), known));
        QVERIFY(samePixels(inputs.at("picture").front().image()->view().crop(6, 3, kPainted), picture));
        run();
        QVERIFY(samePixels(m_window->desk()->result()->synthesis.image.view().crop(6, 3, kPainted), picture));
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
        m_picture = writeTexture(m_folder, QStringLiteral("photo.png"), kPainted, 3);
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
