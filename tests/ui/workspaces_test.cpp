#include "core/analysis/lattice_values.h"
#include "core/analysis/map_pictures.h"
#include "core/analysis/map_usage.h"
#include "core/io/image_file.h"
#include "core/match/blend.h"
#include "tests/support/lattices.h"
#include "tests/support/textures.h"
#include "tests/ui/window_fixture.h"
#include "ui/blend/blend_window.h"
#include "ui/common/text.h"
#include "ui/common/value_editor.h"
#include "ui/exemplar/exemplar_panel.h"
#include "ui/inspector/inspector.h"
#include "ui/inspector/output_group.h"
#include "ui/jobs/run_panel.h"
#include "ui/lattice/lattice_tool.h"
#include "ui/maps/result_view.h"
#include "ui/plots/figures_panel.h"
#include "ui/plots/stress_dialog.h"
#include "ui/plots/variance_dialog.h"
#include "ui/window/readout.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTableWidget>

using namespace texloom;
using namespace texloom::ui;

namespace {

constexpr int kPatience = 60'000;
constexpr std::size_t kCut = 0, kPoisson = 1, kLinear = 2,
                      kProgressive = 3; ///< ways of blending, as declared
const Lattice kBricks{{40.5, 0}, {20.25, 21}};

bool near(const Lattice& a, const Lattice& b, double tolerance) {
    return (a.v1 - b.v1).length() < tolerance && (a.v2 - b.v2).length() < tolerance;
}

double number(const MainWindow& window, const char* name) {
    return std::get<double>(window.inspector()->values().at(name));
}

/// Sets a number as someone would who types it.
void setReal(const QWidget& window, const char* editor, double value) {
    auto* edited = child<ValueEditor>(window, editor);
    edited->setValue(value);
    Q_EMIT edited->edited();
}

/// The window with the lattice of a texture found and shown.
bool openLattice(MainWindow& window, const QString& path) {
    window.show();
    if (!openAndFinish(window, path))
        return false;
    child<QAction>(window, "lattice")->trigger();
    return QTest::qWaitFor([&] { return window.lattice()->analysis() != nullptr; }, kPatience);
}

} // namespace

/// The workspaces beside the result: what they find, show and hand on.
class WorkspacesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() {
        m_bricks = m_folder.filePath(QStringLiteral("bricks.png"));
        writeImage(toPath(m_bricks), test::regularTexture({220, 200}, 3, kBricks, {.noise = 0.05}, 3), {});
        m_other = writeTexture(m_folder, QStringLiteral("other.png"), {220, 200}, 5);
        m_grain = m_folder.filePath(QStringLiteral("grain.png"));
        writeImage(toPath(m_grain), test::noise({96, 80}, 3, 4), {});
    }

    void latticeIsFoundShownAndGivenToTheMethod() {
        MainWindow window;
        QVERIFY(openLattice(window, m_bricks));
        const LatticeTool& tool = *window.lattice();
        QVERIFY(tool.isVisible());
        QVERIFY(tool.analysis()->found());
        QVERIFY(tool.lattice().has_value());
        QVERIFY(tool.lattice()->like(kBricks, 0.5));
        QVERIFY(tool.canvas()->picture() == window.store()->current()->picture);
        QVERIFY(tool.correlationCanvas()->picture());
        QCOMPARE(child<QTableWidget>(tool, "latticeCandidates")->rowCount(),
                 static_cast<int>(tool.analysis()->candidates.size()));
        QVERIFY2(tool.useText().contains(QStringLiteral("follows no lattice")), qPrintable(tool.useText()));

        child<QPushButton>(tool, "useLattice")->click();
        QCOMPARE(window.inspector()->method()->id(), std::string("near-regular"));
        const auto given = givenLattice(window.inspector()->method()->params(), window.inspector()->values());
        QVERIFY(given && *given == *tool.lattice());
        QCOMPARE(number(window, "origin-x"), 0.0);
        QVERIFY2(tool.useText().contains(QStringLiteral("uses this lattice")), qPrintable(tool.useText()));

        QSignalSpy finished(window.desk()->controller(), &RunController::finished);
        window.startRun(true);
        QVERIFY(finished.wait(kPatience));
        const auto& figures = window.desk()->result()->synthesis.figures;
        const auto right = std::find_if(figures.begin(), figures.end(), [](const Figure& figure) {
            return figure.name == "Lattice, first vector right";
        });
        QVERIFY(right != figures.end());
        QVERIFY(std::abs(right->value - given->reduced().v1.x) < 1e-9);
        window.inspector()->resetAll();
        QVERIFY2(tool.useText().contains(QStringLiteral("by itself")), qPrintable(tool.useText()));
    }

    void handlesMoveByKeysMouseAndNumbers() {
        MainWindow window;
        QVERIFY(openLattice(window, m_bricks));
        LatticeTool& tool = *window.lattice();
        LatticeCanvas* const canvas = tool.canvas();
        const auto field = [&](const char* name) { return child<QDoubleSpinBox>(tool, name); };
        field("latticeV1x")->setValue(40);
        field("latticeV1y")->setValue(0);
        QTest::keyClick(canvas, Qt::Key_Space);
        QVERIFY(canvas->handle() == LatticeCanvas::Handle::Origin);
        QTest::keyClick(canvas, Qt::Key_Space);
        QVERIFY(canvas->handle() == LatticeCanvas::Handle::First);
        QVERIFY(tool.correlationCanvas()->handle() == LatticeCanvas::Handle::First);
        QTest::keyClick(canvas, Qt::Key_Right);
        QTest::keyClick(canvas, Qt::Key_Down, Qt::ShiftModifier);
        QTest::keyClick(canvas, Qt::Key_Left, Qt::ControlModifier);
        QVERIFY((tool.lattice()->v1 - Vec2{40.9, 10}).length() < 1e-6);
        QCOMPARE(field("latticeV1x")->value(), 40.9);

        canvas->fit();
        const Vec2 from = canvas->placeOf(LatticeCanvas::Handle::Second);
        const auto point = [&](Vec2 p) { return canvas->view().toWidget({p.x, p.y}).toPoint(); };
        const Vec2 way{2, 1};
        QTest::mousePress(canvas, Qt::LeftButton, {}, point(from));
        const Lattice before = *tool.lattice();
        QTest::mouseMove(canvas, point(from + way));
        QTest::mouseRelease(canvas, Qt::LeftButton, {}, point(from + way));
        QVERIFY((tool.lattice()->v2 - before.v2 - way).length() < 1.5 / canvas->view().scale());
        QVERIFY(tool.lattice()->v1 == before.v1);
        QVERIFY(*tool.correlationCanvas()->lattice() == *tool.lattice());

        field("latticeV1y")->setValue(1);
        child<QPushButton>(tool, "fitLattice")->click();
        QTRY_VERIFY(tool.lattice()->like(kBricks, 0.5));
    }

    void aMovedOriginIsWhereTheResultBegins() {
        MainWindow window;
        QVERIFY(openLattice(window, m_bricks));
        LatticeTool& tool = *window.lattice();
        const Lattice lattice = *tool.lattice();
        tool.canvas()->setHandle(LatticeCanvas::Handle::Origin);
        QTest::keyClick(tool.canvas(), Qt::Key_Right, Qt::ShiftModifier);
        QVERIFY(*tool.lattice() == lattice);
        child<QPushButton>(tool, "useLattice")->click();
        const Vec2 given{number(window, "origin-x"), number(window, "origin-y")};
        const Vec2 phase = lattice.coordinates(tool.canvas()->origin() - given);
        QVERIFY(std::abs(phase.x - std::round(phase.x)) < 1e-6);
        QVERIFY(std::abs(phase.y - std::round(phase.y)) < 1e-6);
        QVERIFY(given.length() > 5);
    }

    void aGivenLatticeStaysWithItsExemplar() {
        MainWindow window;
        QVERIFY(openLattice(window, m_bricks));
        const LatticeTool& tool = *window.lattice();
        child<QPushButton>(tool, "useLattice")->click();
        const auto given = [&] {
            return givenLattice(window.inspector()->method()->params(), window.inspector()->values());
        };
        QVERIFY(given());
        const int bricks = window.store()->current()->id;
        window.openFiles({m_grain});
        QTRY_VERIFY(window.store()->current()->id != bricks);
        QVERIFY(!given());
        QTRY_VERIFY_WITH_TIMEOUT(tool.analysis(), kPatience);
        QVERIFY(!tool.lattice() || !tool.lattice()->like(kBricks, 0.5));
        window.store()->setCurrent(bricks);
        QVERIFY(given() && given()->like(kBricks, 0.5));
        QVERIFY(tool.lattice() && *tool.lattice() == *given());
    }

    void vectorsThatSpanNoTileAreRefusedInWords() {
        MainWindow window;
        QVERIFY(openLattice(window, m_bricks));
        LatticeTool& tool = *window.lattice();
        for (const char* name : {"latticeV2x", "latticeV2y"})
            child<QDoubleSpinBox>(tool, name)->setValue(0);
        QVERIFY2(tool.useText().contains(QStringLiteral("do not span a tile")), qPrintable(tool.useText()));
        QVERIFY(!child<QPushButton>(tool, "useLattice")->isEnabled());
        child<QTableWidget>(tool, "latticeCandidates")->setCurrentCell(-1, -1);
        child<QTableWidget>(tool, "latticeCandidates")->setCurrentCell(0, 0);
        QVERIFY(child<QPushButton>(tool, "useLattice")->isEnabled());
        QVERIFY(near(*tool.lattice(), tool.analysis()->candidates.front().lattice, 1e-9));
    }

    void rowsAreNamedAndUsedAsALattice() {
        MainWindow window;
        const QString courses = m_folder.filePath(QStringLiteral("courses.png"));
        writeImage(toPath(courses), test::coursesTexture({200, 180}, 3, {1, 0}, 30, {.colourChange = 0.3}, 3),
                   {});
        QVERIFY(openLattice(window, courses));
        const LatticeTool& tool = *window.lattice();
        QVERIFY2(tool.verdict().contains(QStringLiteral("in rows")), qPrintable(tool.verdict()));
        QCOMPARE(child<QTableWidget>(tool, "latticeCandidates")->item(0, 0)->text(), QStringLiteral("free"));
        // The handle of the free vector lies beside the origin, where it can be taken.
        LatticeCanvas* const canvas = tool.canvas();
        const QPointF origin = canvas->view().toWidget({canvas->origin().x, canvas->origin().y});
        const QPoint at = (origin + QPointF(canvas->fontMetrics().height() * 0.55 * 3, 0)).toPoint();
        QTest::mousePress(canvas, Qt::LeftButton, {}, at);
        QTest::mouseRelease(canvas, Qt::LeftButton, {}, at);
        QVERIFY(canvas->handle() == LatticeCanvas::Handle::First);
        child<QPushButton>(tool, "useLattice")->click();
        QVERIFY2(tool.useText().contains(QStringLiteral("uses this lattice")), qPrintable(tool.useText()));
    }

    void withoutALatticeItSaysWhatWorks() {
        MainWindow window;
        QVERIFY(openLattice(window, m_grain));
        QVERIFY(!window.lattice()->analysis()->found());
        QVERIFY2(window.lattice()->verdict().contains(QStringLiteral("image quilting")),
                 qPrintable(window.lattice()->verdict()));
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
        child<QAction>(window, "showCopies")->trigger();
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

        CurveViewer* const viewer = window.viewer(kLinear);
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

    void earlierResultsAreFetchedToBeBlended() {
        MainWindow window;
        window.show();
        QVERIFY(openAndFinish(window, m_bricks));
        QTRY_VERIFY(!window.desk()->history()->entries().empty());
        child<QAction>(window, "blend")->trigger();
        auto* blend = child<BlendWindow>(window, "blendWindow");
        auto* first = child<QComboBox>(*blend, "blendFirst");
        const int earlier = first->count() - 1;
        QVERIFY2(first->itemText(earlier).startsWith(QStringLiteral("Earlier: ")),
                 qPrintable(first->itemText(earlier)));
        first->setCurrentIndex(earlier);
        child<QComboBox>(*blend, "blendSecond")->setCurrentIndex(1); // the result that is shown
        QTRY_VERIFY_WITH_TIMEOUT(blend->viewer(kLinear)->picture() && !blend->blending(), kPatience);
        QVERIFY(blend->viewer(kCut)->picture()->size() == window.desk()->result()->synthesis.image.size());
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
