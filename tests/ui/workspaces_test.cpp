#include "core/analysis/map_pictures.h"
#include "core/analysis/map_usage.h"
#include "core/io/image_file.h"
#include "core/match/blend.h"
#include "core/tools/tool.h"
#include "tests/support/lattices.h"
#include "tests/support/textures.h"
#include "tests/ui/window_fixture.h"
#include "ui/blend/blend_window.h"
#include "ui/common/text.h"
#include "ui/common/value_editor.h"
#include "ui/exemplar/exemplar_panel.h"
#include "ui/maps/result_view.h"
#include "ui/plots/figures_panel.h"
#include "ui/plots/stress_dialog.h"
#include "ui/plots/variance_dialog.h"
#include "ui/window/readout.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>

using namespace texloom;
using namespace texloom::ui;

namespace {

constexpr std::size_t kCut = 0, kPoisson = 1, kLinear = 2,
                      kProgressive = 3; ///< ways of blending, as declared

/// Sets a number as someone would who types it.
void setReal(const QWidget& window, const char* editor, double value) {
    auto* edited = child<ValueEditor>(window, editor);
    edited->setValue(value);
    Q_EMIT edited->edited();
}

} // namespace

/// The workspaces beside the result but the lattice's: what they find, show and hand on.
class WorkspacesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() {
        m_bricks = m_folder.filePath(QStringLiteral("bricks.png"));
        writeImage(toPath(m_bricks),
                   test::regularTexture({220, 200}, 3, Lattice{{40.5, 0}, {20.25, 21}}, {.noise = 0.05}, 3),
                   {});
        m_other = writeTexture(m_folder, QStringLiteral("other.png"), {220, 200}, 5);
        m_grain = m_folder.filePath(QStringLiteral("grain.png"));
        writeImage(toPath(m_grain), test::noise({96, 80}, 3, 4), {});
    }

    void notesOfAResultAreShownUntilTheNextRun() {
        MainWindow window;
        window.show();
        QVERIFY(openAndFinish(window, m_grain));
        QVERIFY(window.results()->notes().isEmpty());
        auto* method = child<QComboBox>(window, "method");
        method->setCurrentIndex(method->findData(QStringLiteral("near-regular")));
        QSignalSpy finished(window.desk()->controller(), &RunController::finished);
        window.startRun(true);
        QVERIFY(finished.wait(kPatience));
        QVERIFY(!window.desk()->result()->synthesis.notes.empty());
        QVERIFY2(window.results()->notes().contains(QStringLiteral("No lattice was found")),
                 qPrintable(window.results()->notes()));
        method->setCurrentIndex(method->findData(QStringLiteral("quilting")));
        window.startRun(true);
        QVERIFY(finished.wait(kPatience));
        QVERIFY(window.results()->notes().isEmpty());
    }

    void aRecipesRegionIsKept() {
        MainWindow window;
        window.show();
        QVERIFY(openAndFinish(window, m_grain));
        auto* method = child<QComboBox>(window, "method");
        method->setCurrentIndex(method->findData(QStringLiteral("near-regular")));
        RunInput wanted = window.input(false);
        wanted.size = {4096, 4096};
        wanted.region = Region{300, 200, {128, 64}};
        QSignalSpy replaced(window.store(), &ExemplarStore::replaced);
        window.restore(wanted);
        QVERIFY(replaced.wait());
        QVERIFY(window.input(false).region == wanted.region);
        QVERIFY(!window.input(true).region);
        QSignalSpy finished(window.desk()->controller(), &RunController::finished);
        window.startRun(false);
        QVERIFY(finished.wait(kPatience));
        QVERIFY((window.desk()->result()->synthesis.image.size() == Size{128, 64}));
        child<QCheckBox>(window, "onlyPart")->setChecked(false);
        QVERIFY(!window.input(false).region);
        method->setCurrentIndex(method->findData(QStringLiteral("random-phase")));
        QVERIFY(!child<QCheckBox>(window, "onlyPart")->isEnabled());
    }

    void pointingAtTheExemplarRingsItsCopies() {
        MainWindow window;
        window.show();
        QVERIFY(openAndFinish(window, m_grain));
        const PositionMap& map = window.desk()->result()->synthesis.map;
        const Source source = map.at(31, 17);
        ImageViewer* const exemplar = window.exemplarPanel()->viewer();
        ImageViewer* const result = window.results()->viewer(ResultView::ResultTab);
        QTRY_VERIFY((Q_EMIT exemplar->hovered({source.x, source.y}), !result->rings().empty()));
        std::size_t copies = 0;
        for (int y = 0; y < map.height(); ++y)
            for (int x = 0; x < map.width(); ++x)
                copies += map.at(x, y) == source ? 1 : 0;
        QCOMPARE(result->rings().size(), copies);
        for (const QPoint pixel : result->rings())
            QVERIFY(map.at(pixel.x(), pixel.y()) == source);
        QVERIFY(result->rings() == window.results()->viewer(ResultView::SynthesisTab)->rings());
        const QString text = child<Readout>(window, "readout")->text();
        QVERIFY2(text.contains(copies == 1 ? QStringLiteral("once in the result")
                                           : QStringLiteral("%1 times in the result").arg(copies)),
                 qPrintable(text));
        Q_EMIT exemplar->unhovered();
        QVERIFY(result->rings().empty());
    }

    void copiedPiecesAreShownWithTheLargest() {
        MainWindow window;
        window.show();
        QVERIFY(openAndFinish(window, m_grain));
        const ImageViewer* copies = window.results()->viewer(ResultView::CopiesTab);
        QVERIFY(!copies->picture());
        trigger(window, "showCopies");
        QTRY_VERIFY(copies->picture());
        QVERIFY(samePixels(copies->picture()->values(),
                           copiedRegionsPicture(window.desk()->result()->synthesis.map)));
        const double largest = 100 * largestVerbatimRegion(window.desk()->result()->synthesis.map);
        QVERIFY2(window.results()
                     ->mapLine(ResultView::CopiesTab)
                     .contains(QStringLiteral("%1 %").arg(largest, 0, 'f', 1)),
                 qPrintable(window.results()->mapLine(ResultView::CopiesTab)));
    }

    void aMapIsEstimatedWhereAMethodHasNone() {
        MainWindow window;
        window.show();
        QVERIFY(openAndFinish(window, m_grain));
        auto* method = child<QComboBox>(window, "method");
        method->setCurrentIndex(method->findData(QStringLiteral("random-phase")));
        QSignalSpy finished(window.desk()->controller(), &RunController::finished);
        window.startRun(true);
        QVERIFY(finished.wait(kPatience));
        window.results()->setTab(ResultView::SynthesisTab);
        const ImageViewer* map = window.results()->viewer(ResultView::SynthesisTab);
        QVERIFY(!map->picture());
        QVERIFY2(map->placeholder().contains(QStringLiteral("copies none")), qPrintable(map->placeholder()));
        auto* estimate = child<QPushButton>(window, "synthesisViewerEstimate");
        QVERIFY(estimate->isVisible());
        estimate->click();
        QVERIFY(!estimate->isVisible());
        QTRY_VERIFY_WITH_TIMEOUT(map->picture(), kPatience);
        QCOMPARE(map->badge(), QStringLiteral("Quick preview · estimated"));
        QVERIFY(window.results()->mapLine(ResultView::SynthesisTab).startsWith(QStringLiteral("Estimated")));
        QVERIFY(window.results()->pictures().sourceOf(5, 5).valid());
        QVERIFY(window.desk()->result()->synthesis.mapKind == MapKind::None);
    }

    void theExemplarIsItsOwnLegendWhileAMapIsInFront() {
        MainWindow window;
        window.show();
        QVERIFY(openAndFinish(window, m_grain));
        const auto plain = window.store()->current()->picture;
        QTRY_VERIFY(window.results()->viewer(ResultView::PositionTab)->picture());
        QVERIFY(window.exemplarPanel()->viewer()->picture() == plain);
        window.results()->setTab(ResultView::SynthesisTab);
        QVERIFY(window.exemplarPanel()->viewer()->picture() != plain);
        QVERIFY(window.exemplarPanel()->viewer()->picture()->size() == plain->size());
        window.results()->setTab(ResultView::ResultTab);
        QVERIFY(window.exemplarPanel()->viewer()->picture() == plain);
    }

    void blendsStandSideBySideAndFollowEveryChange() {
        const std::vector<NamedImage> images = {imageOf(m_bricks), imageOf(m_other)};
        BlendWindow window(images);
        window.show();
        QVERIFY(window.tool().id() == "blend");
        for (const std::size_t way : {kCut, kPoisson, kLinear, kProgressive})
            QTRY_VERIFY_WITH_TIMEOUT(window.viewer(way)->picture(), kPatience);
        QVERIFY(samePixels(window.viewer(kCut)->picture()->values(), cut(images, 0.5)));
        setReal(window, "blend-position", 0.25);
        QVERIFY(window.blending());
        QTRY_VERIFY_WITH_TIMEOUT(!window.blending(), kPatience);
        QVERIFY(samePixels(window.viewer(kCut)->picture()->values(), cut(images, 0.25)));
        QCOMPARE(child<ValueEditor>(window, "blend-band")->findChild<QSpinBox*>()->maximum(),
                 100); // of 220 × 200 px

        ImageViewer* const viewer = window.viewer(kLinear);
        const auto point = [&](double y) { return viewer->view().toWidget({110, y}).toPoint(); };
        QTest::mousePress(viewer, Qt::LeftButton, {}, point(50));
        QTest::mouseMove(viewer, point(150));
        QTest::mouseRelease(viewer, Qt::LeftButton, {}, point(150));
        QVERIFY(std::abs(std::get<double>(child<ValueEditor>(window, "blend-position")->value()) - 0.75) <
                0.03);

        child<QCheckBox>(window, "blendWay0")->setChecked(false);
        QVERIFY(!window.viewer(kCut)->isVisible());
        QTRY_VERIFY_WITH_TIMEOUT(!window.blending(), kPatience);
        const QString path = m_folder.filePath(QStringLiteral("blend.png"));
        window.save(kPoisson, path);
        QTRY_VERIFY(child<QPushButton>(window, "blendUse")->isVisible());
        QVERIFY((readImage(toPath(path)).info.size == Size{220, 200}));
    }

    void imagesOfTwoSizesAreCroppedToWhatBothHave() {
        const std::vector<NamedImage> images = {imageOf(m_bricks), imageOf(m_grain)};
        BlendWindow window(images);
        window.show();
        QTRY_VERIFY_WITH_TIMEOUT(window.viewer(kCut)->picture(), kPatience);
        const Size a = images[0].file.image->size(), b = images[1].file.image->size();
        const Size common{std::min(a.width, b.width), std::min(a.height, b.height)};
        QVERIFY(a != b && window.viewer(kCut)->picture()->size() == common);
        QVERIFY2(window.message().contains(sizeText(common)), qPrintable(window.message()));
        child<QComboBox>(window, "blendSecond")->setCurrentIndex(0);
        QTRY_VERIFY2(window.message().contains(QStringLiteral("Both images are")),
                     qPrintable(window.message()));
        BlendWindow empty({});
        QTRY_VERIFY(empty.message().contains(QStringLiteral("Open two images")));
        QVERIFY(!child<QPushButton>(empty, "blendSave")->isEnabled());
    }

    void theFirstTwoImagesThatCanBeBlendedAreChosen() {
        const QString grey = m_folder.filePath(QStringLiteral("grey.png"));
        writeImage(toPath(grey), test::noise({96, 80}, 1, 4), {});
        BlendWindow window({imageOf(m_grain), imageOf(grey), imageOf(m_bricks)});
        window.show();
        QCOMPARE(child<QComboBox>(window, "blendFirst")->currentIndex(), 0);
        QCOMPARE(child<QComboBox>(window, "blendSecond")->currentIndex(), 2);
        for (const std::size_t way : {kCut, kPoisson, kLinear, kProgressive})
            QTRY_VERIFY_WITH_TIMEOUT(window.viewer(way)->picture(), kPatience);
    }

    void aRegionIsPaintedAndDraggedToBeCloned() {
        const std::vector<NamedImage> images = {imageOf(m_bricks), imageOf(m_other)};
        BlendWindow window(images);
        window.setTool(findTool("poisson-clone"));
        window.show();
        for (const std::size_t way : {0, 1, 2})
            QTRY_VERIFY_WITH_TIMEOUT(window.viewer(way)->picture(), kPatience);
        ImageViewer* const viewer = window.viewer(0);
        const auto point = [&](double x, double y) { return viewer->view().toWidget({x, y}).toPoint(); };
        QTest::mousePress(viewer, Qt::LeftButton, {}, point(110, 100));
        QTest::mouseMove(viewer, point(140, 90));
        QTest::mouseRelease(viewer, Qt::LeftButton, {}, point(140, 90));
        const int right = std::get<int>(child<ValueEditor>(window, "blend-offset-x")->value());
        const int down = std::get<int>(child<ValueEditor>(window, "blend-offset-y")->value());
        QVERIFY(std::abs(right - 30) <= 3 && std::abs(down + 10) <= 3);

        Image selection({220, 200}, 1), mask({220, 200}, 1);
        for (int y = 0; y < 200; ++y)
            for (int x = 0; x < 220; ++x) {
                selection(x, y, 0) = std::hypot(x - 60, y - 70) < 25 ? 1.0F : 0.0F;
                mask(x, y, 0) = 1 - selection(x, y, 0);
            }
        window.setRegion(selection);
        JobMonitor monitor;
        JobContext context(
            {}, [] { return false; }, monitor);
        const Image wanted =
            findTool("poisson-clone")
                .joined(
                    {*images[0].file.image, *images[1].file.image, &mask},
                    findTool("poisson-clone")
                        .resolved({{"offset-x", right}, {"offset-y", down}, {"mode", std::string("paste")}}),
                    context);
        const auto pasted = [&] { return window.viewer(2)->picture(); };
        QTRY_VERIFY_WITH_TIMEOUT(!window.blending() && samePixels(pasted()->values(), wanted), kPatience);
        QVERIFY(child<QPushButton>(window, "blendPaint")->isVisible());
        window.setTool(findTool("blend"));
        QVERIFY(!child<QPushButton>(window, "blendPaint")->isVisible());
    }

    void earlierResultsAreFetchedToBeBlended() {
        MainWindow window;
        window.show();
        QVERIFY(openAndFinish(window, m_bricks));
        QTRY_VERIFY(!window.desk()->history()->entries().empty());
        trigger(window, "blend");
        auto* blend = child<BlendWindow>(window, "blendWindow");
        auto* first = child<QComboBox>(*blend, "blendFirst");
        // The newest: those of other tests may have other sizes.
        const int earlier = first->findText(QStringLiteral("Earlier: "), Qt::MatchStartsWith);
        QVERIFY(earlier >= 0);
        first->setCurrentIndex(earlier);
        child<QComboBox>(*blend, "blendSecond")->setCurrentIndex(1); // the result that is shown
        // Until both are chosen and fetched, what is shown may be a blend of others.
        const Size wanted = window.desk()->result()->synthesis.image.size();
        const auto shown = [&] { return blend->viewer(kCut)->picture(); };
        QTRY_VERIFY_WITH_TIMEOUT(!blend->blending() && shown() && shown()->size() == wanted, kPatience);
    }

    void patchVarianceIsPlottedAsTheAnalysisHasIt() {
        VarianceDialog dialog({imageOf(m_grain)});
        dialog.show();
        child<QLineEdit>(dialog, "varianceSizes")->setText(QStringLiteral("4, 8"));
        child<QLineEdit>(dialog, "varianceNeighbours")->setText(QStringLiteral("5, 20"));
        dialog.compute();
        QTRY_VERIFY_WITH_TIMEOUT(!dialog.computing(), kPatience);
        const PlotData& data = dialog.plot()->data();
        QCOMPARE(data.series.size(), std::size_t{2});
        QCOMPARE(data.series[1].points.size(), std::size_t{2});
        QVERIFY(data.series[0].points[0].x() == 5 && data.series[0].points[0].y() > 0);
        const QStringList lines = dialog.plot()->csv().split(QLatin1Char('\n'));
        QCOMPARE(lines.size(), 4);
        QVERIFY2(lines[1].startsWith(QStringLiteral("5,")), qPrintable(lines[1]));
        child<QLineEdit>(dialog, "varianceSizes")->setText(QStringLiteral("4, big"));
        dialog.compute();
        QVERIFY(!dialog.computing());
        QVERIFY2(dialog.message().contains(QStringLiteral("512")), qPrintable(dialog.message()));
    }

    void roundsOfAStressTestStandSideBySide() {
        RunInput input;
        input.steps.front().method = "quilting";
        input.steps.front().parameters = {{"patch", 12}};
        input.exemplars = {{imageOf(m_grain).file, {}, {}}};
        input.size = {64, 64};
        StressDialog dialog(input);
        dialog.show();
        child<QSpinBox>(dialog, "stressRounds")->setValue(3);
        dialog.start();
        QTRY_VERIFY_WITH_TIMEOUT(!dialog.running(), kPatience);
        QTRY_COMPARE(dialog.findChildren<ImageViewer*>().size(), 3);
        const PlotData& data = dialog.plot()->data();
        QCOMPARE(data.series.front().points.size(), std::size_t{3});
        QVERIFY(data.series.front().points[2].y() > 0);
        input.steps.front().parameters = {{"patch", 500}};
        StressDialog refused(input);
        refused.start();
        QTRY_VERIFY_WITH_TIMEOUT(refused.message().contains(QStringLiteral("500")), kPatience);
    }

    void figuresOfAResultAreMadeWhileTheyAreSeen() {
        MainWindow window;
        window.show();
        QVERIFY(openAndFinish(window, m_bricks));
        auto* panel = child<FiguresPanel>(window, "figuresPanel");
        QTest::qWait(200);
        QVERIFY(panel->titles().isEmpty());
        child<QDockWidget>(window, "figureDock")->raise();
        QTRY_VERIFY_WITH_TIMEOUT(!panel->titles().isEmpty(), kPatience);
        for (const char* title :
             {"Numbers", "Colours: red", "Patches: first component", "Autocorrelation: exemplar",
              "Autocorrelation: result", "How often pixels are used"})
            QVERIFY2(panel->titles().contains(QLatin1String(title)), title);
        panel->showFigure(QStringLiteral("Colours: red"));
        const PlotData& data = panel->plot()->data();
        QCOMPARE(data.series.size(), std::size_t{3});
        double exemplar = 0, difference = 0;
        for (std::size_t i = 0; i < data.series[0].points.size(); ++i) {
            exemplar += data.series[0].points[i].y();
            difference += data.series[2].points[i].y();
        }
        QVERIFY(std::abs(exemplar - 100) < 1e-6 && std::abs(difference) < 1e-6);
        panel->showFigure(QStringLiteral("Autocorrelation: result"));
        QVERIFY(panel->viewer()->picture());
    }

private:
    static NamedImage imageOf(const QString& path) {
        ExemplarFile file = loadExemplar(toPath(path));
        return {QString::fromStdString(file.name()), file};
    }

    /// Both images joined along a horizontal cut, as core does it.
    static Image cut(const std::vector<NamedImage>& images, double position) {
        const Image& first = *images[0].file.image;
        JobMonitor monitor;
        JobContext context(
            {}, [] { return false; }, monitor);
        const auto curve = BlendCurve::at(BlendCurve::Shape::Horizontal, position, first.size());
        return blendAlong(first, *images[1].file.image, curve, {BlendMethod::Cut, 32, {}}, context);
    }

    QTemporaryDir m_folder;
    QString m_bricks;
    QString m_grain;
    QString m_other; ///< of the size of m_bricks
};

TEXLOOM_UI_TESTS(WorkspacesTest)
#include "workspaces_test.moc"
