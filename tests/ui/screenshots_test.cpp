#include "core/session/run/checkpoint_file.h"
#include "core/tools/edits.h"
#include "tests/support/volumes.h"
#include "tests/ui/shoot.h"
#include "tests/ui/window_fixture.h"
#include "ui/blend/blend_window.h"
#include "ui/common/appearance.h"
#include "ui/common/background.h"
#include "ui/common/language.h"
#include "ui/common/message_bar.h"
#include "ui/common/text.h"
#include "ui/common/value_editor.h"
#include "ui/compare/compare_view.h"
#include "ui/compare/wipe_viewer.h"
#include "ui/exemplar/exemplar_editor.h"
#include "ui/exemplar/exemplar_panel.h"
#include "ui/exemplar/files.h"
#include "ui/export/export_dialog.h"
#include "ui/export/preset_editor.h"
#include "ui/inspector/inspector.h"
#include "ui/inspector/output_group.h"
#include "ui/inspector/param_row.h"
#include "ui/jobs/run_panel.h"
#include "ui/lattice/lattice_previews.h"
#include "ui/lattice/lattice_tool.h"
#include "ui/maps/result_view.h"
#include "ui/plots/figures_panel.h"
#include "ui/plots/stress_dialog.h"
#include "ui/plots/variance_dialog.h"
#include "ui/session/document.h"
#include "ui/session/missing_files_dialog.h"
#include "ui/volume/slice_view.h"
#include "ui/volume/solid_panel.h"
#include "ui/volume/volume_page.h"
#include "ui/window/drop_targets.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QToolButton>

using namespace texloom;
using namespace texloom::ui;

/// Draws the window in all its states to PNG files, for people to look at, and checks that nothing is cut
/// off.
class ScreenshotsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(QDir().mkpath(QStringLiteral(TEXLOOM_SCREENSHOTS))); }

    void everyState_data() {
        QTest::addColumn<int>("appearance");
        QTest::newRow("light") << static_cast<int>(Appearance::Light);
        QTest::newRow("dark") << static_cast<int>(Appearance::Dark);
    }

    void everyState() {
        QFETCH(int, appearance);
        applyAppearance(static_cast<Appearance>(appearance));
        MainWindow window;
        window.resize(1280, 800);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        auto* bundled = child<QListWidget>(window, "bundledThumbnails");
        QTRY_COMPARE(bundled->count(), bundledExemplars().size());
        workers().waitForDone();
        QCoreApplication::processEvents();
        shoot(window, "start");

        QVERIFY(openAndFinish(window, bundledNamed("crazy_paving")));
        shoot(window, "quick");
        showRunning(window);
        showResult(window);
        showError(window);
        showExport(window);
        showPipeline(window);
        showEditing(window);
        showSessions(window);
        showCompare(window);
        showMaps(window);
        showLattice(window);
        showVolume();
        showFigures(window);
        showTools(window);
        showSmallScreen(window);
        showManyRuns(window);
    }

    void workWorthKeeping_data() { everyState_data(); }

    void workWorthKeeping() {
        QFETCH(int, appearance);
        applyAppearance(static_cast<Appearance>(appearance));
        MainWindow window;
        window.resize(1280, 800);
        window.show();
        QVERIFY(openAndFinish(window, bundledNamed("crazy_paving")));
        auto* method = child<QComboBox>(window, "method");
        method->setCurrentIndex(method->findData(QStringLiteral("texture-optimization")));
        window.inspector()->output()->setOutputSize({512, 512});
        auto* figures = child<QDockWidget>(window, "figureDock");
        figures->raise();
        window.resizeDocks({figures}, {window.height() * 2 / 5}, Qt::Vertical);
        QSignalSpy grew(window.desk()->controller(), &RunController::curvesGrew);
        QSignalSpy finished(window.desk()->controller(), &RunController::finished);
        window.startRun(false);
        QTRY_VERIFY_WITH_TIMEOUT(grew.size() > 3, 60'000);
        shoot(window, "figures-live");
        child<QDockWidget>(window, "jobDock")->raise();
        shoot(window, "jobs");
        trigger(window, "stop");
        QVERIFY(finished.wait(60'000));
        child<QDockWidget>(window, "resultDock")->raise();
        workers().waitForDone();
        shoot(window, "kept");
        showBrokenRun(window);
    }

    void otherLanguages_data() {
        QTest::addColumn<QString>("language");
        QTest::newRow("de") << QStringLiteral("de_DE");
        QTest::newRow("fr") << QStringLiteral("fr_FR");
    }

    void otherLanguages() {
        QFETCH(QString, language);
        applyAppearance(Appearance::Light);
        useLanguage(QLocale(language));
        {
            MainWindow window;
            window.resize(1280, 800);
            window.show();
            QVERIFY(QTest::qWaitForWindowExposed(&window));
            shoot(window, "start");
            QVERIFY(openAndFinish(window, bundledNamed("crazy_paving")));
            workers().waitForDone();
            shoot(window, "quick");
            QVERIFY(child<QAction>(window, "run")->text() != QStringLiteral("&Run"));
            showExport(window);
            showEditing(window);
            showSessions(window);
        }
        useLanguage(QLocale::c());
    }

private:
    static QString bundledNamed(const QString& name) {
        for (const QString& path : bundledExemplars())
            if (path.contains(name))
                return path;
        return bundledExemplars().front();
    }

    static void showRunning(MainWindow& window) {
        window.inspector()->output()->setOutputSize({2048, 2048});
        QSignalSpy progressed(window.desk()->controller(), &RunController::progressed);
        QSignalSpy previewed(window.desk()->controller(), &RunController::previewed);
        window.startRun(false);
        QVERIFY(previewed.wait(60'000));
        for (int i = 0; i < 12 && window.desk()->running(); ++i)
            progressed.wait(1000);
        shoot(window, "running");
        window.desk()->stopAndKeep();
        QTRY_VERIFY_WITH_TIMEOUT(!window.desk()->running(), 60'000);
        QCoreApplication::processEvents();
        shoot(window, "stopped");
        window.messages()->dismiss();
    }

    static void showResult(MainWindow& window) {
        window.inspector()->output()->setOutputSize({512, 512});
        QSignalSpy finished(window.desk()->controller(), &RunController::finished);
        window.startRun(false);
        QVERIFY(finished.wait(60'000));
        QTRY_VERIFY(window.results()->viewer(ResultView::PositionTab)->picture());
        QTRY_VERIFY(child<QAction>(window, "run")->isEnabled());
        Q_EMIT window.results()->viewer(ResultView::ResultTab)->hovered({200, 100});
        window.inspector()->rows().front()->editor()->setFocus();
        shoot(window, "result");
        trigger(window, "repeat");
        shoot(window, "repeated");
        trigger(window, "repeat");
        window.results()->setTab(ResultView::SynthesisTab);
        shoot(window, "synthesis-map");
        window.results()->setTab(ResultView::PositionTab);
        shoot(window, "position-map");
        window.results()->setTab(ResultView::ResultTab);
    }

    static void showError(MainWindow& window) {
        window.inspector()->rows().front()->setValue(512);
        Q_EMIT window.inspector()->edited();
        QTRY_VERIFY(!window.runPanel()->refusal().isEmpty());
        window.openFiles({QStringLiteral("/no/such/picture of bark.png")});
        QTRY_VERIFY(window.messages()->isVisible());
        shoot(window, "error");
        window.messages()->dismiss();
        window.inspector()->resetAll();
    }

    static void showPipeline(MainWindow& window) {
        auto* method = child<QComboBox>(window, "method");
        method->setCurrentIndex(method->findData(QStringLiteral("random-phase")));
        window.inspector()->setThen({{"quilting", {}}});
        QSignalSpy finished(window.desk()->controller(), &RunController::finished);
        window.startRun(false);
        QVERIFY(finished.wait(60'000));
        QTRY_VERIFY(child<QAction>(window, "run")->isEnabled());
        child<QComboBox>(window, "then1")->setFocus();
        shoot(window, "pipeline");
    }

    static void showCompare(MainWindow& window) {
        const ResultHistory* const history = window.desk()->history();
        const CompareView* const compare = window.compare();
        std::vector<std::string> keys;
        for (const ResultEntry& entry : history->entries())
            if (!entry.quick)
                keys.push_back(entry.key);
        window.desk()->history()->setData(history->index(0), QStringLiteral("The one for the floor"),
                                          Qt::EditRole);
        window.desk()->history()->setPinned(history->entries().back().key, true);
        window.resultPanel()->select(keys);
        trigger(window, "compareResults");
        QTRY_COMPARE(compare->pictures(), static_cast<int>(keys.size()) + 1);
        shoot(window, "compare-grid");
        trigger(window, "compareWipe");
        window.compare()->single()->setAngle(30);
        window.compare()->single()->setFocus();
        shoot(window, "compare-wipe");
        trigger(window, "compareDifference");
        QTRY_VERIFY(!compare->bar()->said().isEmpty());
        shoot(window, "compare-difference");
        trigger(window, "compareGrid");
        window.resultPanel()->select({keys[0], keys[1]});
        trigger(window, "resultDifference");
        auto* dialog = child<QDialog>(window, "differenceDialog");
        QVERIFY(QTest::qWaitForWindowExposed(dialog));
        shoot(*dialog, "differences");
        dialog->reject();
    }

    static void showSmallScreen(MainWindow& window) {
        auto* stacked = child<QAction>(window, "stackPanels");
        stacked->setChecked(true);
        window.resize(960, 510);
        shoot(window, "small-screen");
        child<QDockWidget>(window, "resultDock")->raise();
        shoot(window, "small-screen-results");
        stacked->setChecked(false);
        window.resize(1280, 800);
    }

    static void showManyRuns(MainWindow& window) {
        trigger(window, "sweep");
        auto* dialog = child<QDialog>(window, "sweepDialog");
        QVERIFY(QTest::qWaitForWindowExposed(dialog));
        shoot(*dialog, "sweep");
        dialog->reject();
        trigger(window, "trySome");
        auto* some = child<QDialog>(window, "methodsDialog");
        QVERIFY(QTest::qWaitForWindowExposed(some));
        shoot(*some, "try-some");
        some->reject();
        child<QDoubleSpinBox>(window, "exemplarWeight")->setValue(2.5);
        window.inspector()->output()->setOutputSize({128, 128});
        JobQueue* const queue = window.desk()->queue();
        child<QDockWidget>(window, "jobDock")->raise();
        trigger(window, "tryAll");
        QTRY_VERIFY(queue->waiting() > 0);
        QTRY_VERIFY_WITH_TIMEOUT(queue->waiting() <= 12, 120'000); // some cells are filled, some wait
        shoot(window, "try-all");
        queue->clear();
        window.desk()->cancel();
        QTRY_VERIFY(!window.desk()->running());
        child<QDockWidget>(window, "logDock")->raise();
        shoot(window, "log");
    }

    static void showMaps(MainWindow& window) {
        auto* method = child<QComboBox>(window, "method");
        method->setCurrentIndex(method->findData(QStringLiteral("random-phase")));
        window.inspector()->setThen({});
        QSignalSpy finished(window.desk()->controller(), &RunController::finished);
        window.startRun(true);
        QVERIFY(finished.wait(60'000));
        window.results()->setTab(ResultView::SynthesisTab);
        shoot(window, "no-map");
        child<QPushButton>(window, "synthesisViewerEstimate")->click();
        QTRY_VERIFY_WITH_TIMEOUT(window.results()->viewer(ResultView::SynthesisTab)->picture(), 60'000);
        shoot(window, "estimated-map");
        method->setCurrentIndex(method->findData(QStringLiteral("quilting")));
        window.startRun(true);
        QVERIFY(finished.wait(60'000));
        window.results()->setTab(ResultView::CopiesTab);
        QTRY_VERIFY(window.results()->viewer(ResultView::CopiesTab)->picture());
        shoot(window, "copied-pieces");
        window.results()->setTab(ResultView::ResultTab);
        ImageViewer* const exemplar = window.exemplarPanel()->viewer();
        Q_EMIT exemplar->hovered({240, 240});
        QTRY_VERIFY_WITH_TIMEOUT((Q_EMIT exemplar->hovered({240, 240}),
                                  !window.results()->viewer(ResultView::ResultTab)->rings().empty()),
                                 20'000);
        shoot(window, "copies-of-a-pixel");
        Q_EMIT exemplar->unhovered();
    }

    static void showVolume() {
        VolumePage page;
        page.resize(1000, 620);
        page.show();
        const auto rings = std::make_shared<test::FunctionSource>(
            [](std::int64_t x, std::int64_t y, std::int64_t z, int c) {
                const double far =
                    std::hypot(static_cast<double>(x) + 8 * std::sin(static_cast<double>(z) / 30),
                               static_cast<double>(y));
                return (0.35 - 0.09 * c) * (1.2 + std::sin(far / 4) * std::cos(static_cast<double>(z) / 50));
            },
            3);
        page.setVolumes({{QStringLiteral("Rings"), {rings, {}}}});
        for (const auto& [view, name] :
             {std::pair(SolidPanel::Oblique, "volume-oblique"), std::pair(SolidPanel::Block, "volume-block"),
              std::pair(SolidPanel::OnMesh, "volume-mesh")}) {
            page.solid()->setView(view);
            for (const Axis axis : {Axis::X, Axis::Y, Axis::Z})
                QTRY_VERIFY_WITH_TIMEOUT(!page.slice(axis)->busy(), 30'000);
            QTest::qWait(1500); // until what is drawn in space has come to rest
            shoot(page, name);
        }
    }

    static void showLattice(MainWindow& window) {
        QSignalSpy opened(window.store(), &ExemplarStore::opened);
        window.openFiles({bundledNamed(QStringLiteral("solar_cells"))});
        QVERIFY(opened.wait());
        trigger(window, "lattice");
        QTRY_VERIFY_WITH_TIMEOUT(window.lattice()->analysis(), 60'000);
        window.lattice()->canvas()->setHandle(LatticeCanvas::Handle::First);
        QTRY_VERIFY_WITH_TIMEOUT(!child<LatticePreviews>(window, "latticePreviews")->running(), 60'000);
        shoot(window, "lattice");
        child<QPushButton>(window, "useLattice")->click();
        QSignalSpy finished(window.desk()->controller(), &RunController::finished);
        QTRY_VERIFY(child<QAction>(window, "run")->isEnabled());
        shoot(window, "lattice-used");
        window.inspector()->resetAll();
        window.openFiles({bundledNamed(QStringLiteral("riveted_metal"))});
        QVERIFY(opened.wait());
        QTRY_VERIFY_WITH_TIMEOUT(window.lattice()->analysis(), 60'000);
        shoot(window, "lattice-of-rows");
        window.openFiles({bundledNamed(QStringLiteral("plank_wall"))});
        QVERIFY(opened.wait());
        QTRY_VERIFY_WITH_TIMEOUT(window.lattice()->analysis(), 60'000);
        shoot(window, "rows-in-order");
        window.openFiles({bundledNamed(QStringLiteral("gravel"))});
        QVERIFY(opened.wait());
        QTRY_VERIFY_WITH_TIMEOUT(window.lattice()->analysis(), 60'000);
        shoot(window, "no-lattice");
        window.startRun(true);
        QVERIFY(finished.wait(60'000));
        window.results()->setTab(ResultView::ResultTab);
        shoot(window, "notes");
    }

    static void showFigures(MainWindow& window) {
        auto* dock = child<QDockWidget>(window, "figureDock");
        dock->raise();
        auto* panel = child<FiguresPanel>(window, "figuresPanel");
        QTRY_VERIFY_WITH_TIMEOUT(!panel->titles().isEmpty(), 60'000);
        window.resizeDocks({dock}, {window.height() * 2 / 5}, Qt::Vertical);
        panel->showFigure(QStringLiteral("Patches: first component"));
        shoot(window, "figures");
        panel->plot()->setNumbers(true);
        shoot(window, "figures-numbers");
        panel->plot()->setNumbers(false);
        panel->showFigure(QStringLiteral("Autocorrelation: exemplar"));
        shoot(window, "figures-autocorrelation");
        child<QDockWidget>(window, "resultDock")->raise();
    }

    static void showTools(MainWindow& window) {
        QSignalSpy opened(window.store(), &ExemplarStore::opened);
        window.openFiles({bundledNamed(QStringLiteral("soil_clods"))});
        QVERIFY(opened.wait());
        trigger(window, "blend");
        auto* blend = child<BlendWindow>(window, "blendWindow");
        QTRY_VERIFY(!blend->message().isEmpty());
        shoot(*blend, "blend-sizes-differ");
        child<QComboBox>(*blend, "blendFirst")->setCurrentIndex(1);
        child<QComboBox>(*blend, "blendSecond")->setCurrentIndex(3);
        QTRY_VERIFY_WITH_TIMEOUT(!blend->blending(), 60'000);
        shoot(*blend, "blend");
        child<ValueEditor>(*blend, "blend-curve")->findChild<QComboBox*>()->setCurrentIndex(2);
        child<QCheckBox>(*blend, "blendWay0")->setChecked(false);
        child<QCheckBox>(*blend, "blendWay3")->setChecked(false);
        QTRY_VERIFY_WITH_TIMEOUT(!blend->blending(), 60'000);
        shoot(*blend, "blend-circular");
        child<QCheckBox>(*blend, "blendWay4")->setChecked(true);
        child<ValueEditor>(*blend, "blend-band")->findChild<QSpinBox*>()->setValue(400);
        QTRY_VERIFY_WITH_TIMEOUT(!blend->blending(), 60'000);
        shoot(*blend, "blend-wide-band");
        blend->close();
        trigger(window, "variance");
        auto* variance = child<VarianceDialog>(window, "varianceDialog");
        shoot(*variance, "variance-empty");
        child<QLineEdit>(*variance, "varianceNeighbours")->setText(QStringLiteral("5, 10, 30, 50"));
        variance->compute();
        QTRY_VERIFY_WITH_TIMEOUT(!variance->computing(), 60'000);
        shoot(*variance, "variance");
        variance->close();
        trigger(window, "stress");
        auto* stress = child<StressDialog>(window, "stressDialog");
        child<QSpinBox>(*stress, "stressRounds")->setValue(3);
        stress->start();
        QTRY_VERIFY_WITH_TIMEOUT(!stress->running(), 60'000);
        workers().waitForDone();
        shoot(*stress, "stress");
        stress->close();
    }

    static void showEditing(MainWindow& window) {
        ExemplarEditor* const editor = window.exemplarEditor();
        const int id = window.store()->current()->id;
        trigger(window, "editExemplar");
        editor->setMode(QStringLiteral("crop"));
        shoot(window, "edit-crop");
        editor->setMode(QStringLiteral("rectify"));
        QTest::keyClick(editor->canvas(), Qt::Key_N);
        QTest::keyClick(editor->canvas(), Qt::Key_Left, Qt::ControlModifier);
        shoot(window, "edit-rectify");
        window.store()->setEdits(id, {{{"rotate", 8.0}}, {{"flatten", std::string("smooth")}}}, {});
        const Size size = window.store()->current()->file().image->size();
        Image stroke(sizeAfter(ExemplarEdit{{"rotate", 8.0}}, size), 1);
        for (int y = stroke.height() / 5; y < stroke.height() / 2; ++y)
            for (int x = stroke.width() / 4; x < stroke.width() * 2 / 3; ++x)
                stroke(x, y, 0) = 1;
        window.store()->paintMask(id, std::move(stroke), true);
        QTRY_VERIFY(window.store()->current()->exemplar.mask);
        editor->setMode(QStringLiteral("hide"));
        shoot(window, "edit-mask");
        auto* targets = child<DropTargets>(window, "dropTargets");
        targets->open(DropTargets::Dragged::Files, true, window.inspector()->output()->ports());
        shoot(window, "drop-targets");
        targets->hide();
        trigger(window, "editExemplar");
        window.store()->setEdits(id, {}, {});
        window.store()->clearMask(id);
        QTRY_VERIFY(!window.store()->current()->exemplar.mask);
    }

    static void showSessions(MainWindow& window) {
        MissingFilesDialog missing(window.session(),
                                   {QStringLiteral("materials/a long folder name/bark_albedo.png"),
                                    QStringLiteral("materials/bark_normal.png")},
                                   &window);
        missing.show();
        QVERIFY(QTest::qWaitForWindowExposed(&missing));
        shoot(missing, "missing-files");
    }

    static void showBrokenRun(MainWindow& window) {
        const QTemporaryDir folder;
        const RunPlan plan = planRun(window.input(false));
        writeCheckpoint(toPath(folder.filePath(QStringLiteral("one.checkpoint"))), plan.recipe,
                        {0, 0.43, "state"});
        window.document()->recovery()->setFolder(folder.path());
        window.offerRecovery();
        QTRY_VERIFY(window.findChild<QDialog*>(QStringLiteral("brokenRunDialog")) != nullptr);
        auto* dialog = child<QDialog>(window, "brokenRunDialog");
        QVERIFY(QTest::qWaitForWindowExposed(dialog));
        shoot(*dialog, "broken-run");
        dialog->reject();
    }

    static void showExport(MainWindow& window) {
        trigger(window, "export");
        auto* dialog = window.findChild<ExportDialog*>();
        QVERIFY(dialog != nullptr);
        QVERIFY(QTest::qWaitForWindowExposed(dialog));
        shoot(*dialog, "export");
        child<QToolButton>(*dialog, "exportEditPresets")->click();
        auto* presets = child<PresetEditor>(*dialog, "presetEditor");
        child<QListWidget>(*presets, "presetList")->setCurrentRow(2);
        child<QPushButton>(*presets, "addPreset")->click();
        QVERIFY(QTest::qWaitForWindowExposed(presets));
        shoot(*presets, "export-presets");
        presets->reject();
        dialog->reject();
        trigger(window, "shortcuts");
        auto* keys = child<QDialog>(window, "shortcutsDialog");
        QVERIFY(QTest::qWaitForWindowExposed(keys));
        shoot(*keys, "shortcuts");
        keys->reject();
    }
};

TEXLOOM_UI_TESTS(ScreenshotsTest)
#include "screenshots_test.moc"
