#include "core/analysis/map_pictures.h"
#include "tests/ui/window_fixture.h"
#include "ui/common/message_bar.h"
#include "ui/exemplar/exemplar_panel.h"
#include "ui/inspector/inspector.h"
#include "ui/inspector/output_group.h"
#include "ui/jobs/run_panel.h"
#include "ui/maps/result_view.h"
#include "ui/window/readout.h"
#include "ui/window/run_notice.h"

#include <QAction>
#include <QDialog>
#include <QElapsedTimer>
#include <QSignalSpy>
#include <QTableWidget>

#include <algorithm>

using namespace texloom;
using namespace texloom::ui;
using namespace std::chrono_literals;

namespace {

/// Settings whose run lasts for many seconds.
void chooseLongRun(MainWindow& window) {
    window.inspector()->setValues({{"patch", 16}});
    window.inspector()->output()->setOutputSize({2048, 2048});
}

/// The longest time between two turns of the event loop, in milliseconds.
class Heartbeat : public QObject {
public:
    Heartbeat() {
        m_timer.setInterval(1);
        m_timer.setTimerType(Qt::PreciseTimer);
        connect(&m_timer, &QTimer::timeout, this,
                [this] { m_longest = std::max(m_longest, m_clock.restart()); });
        m_clock.start();
        m_timer.start();
    }

    qint64 longest() const { return m_longest; }

private:
    QTimer m_timer;
    QElapsedTimer m_clock;
    qint64 m_longest = 0;
};

} // namespace

class RunTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() {
        m_exemplar = writeTexture(m_folder, QStringLiteral("weave.png"), {96, 80});
        m_large = writeTexture(m_folder, QStringLiteral("large weave.png"), {512, 512});
    }

    void longRunsThatNobodyWatchedAreTold() {
        QWidget window; // never active, since it is not shown
        RunDesk desk(m_folder.filePath(QStringLiteral("told")));
        RunNotice notice(&desk, &window);
        QStringList told;
        notice.setPost([&](const QString& title, const QString& text) { told += title + u' ' + text; });
        QueuedJob job;
        job.label = QStringLiteral("Image quilting");
        const auto end = [&](double seconds) {
            auto result = std::make_shared<Result>();
            result->seconds = seconds;
            RunPictures pictures;
            pictures.run = result;
            Q_EMIT desk.kept(job, "key", pictures);
        };
        end(RunNotice::kLong - 1);
        QVERIFY(told.isEmpty());
        end(RunNotice::kLong + 1);
        QCOMPARE(told, QStringList{QStringLiteral("Finished Image quilting")});
        job.problem = QStringLiteral("No memory.");
        job.progress.seconds = RunNotice::kLong + 1;
        Q_EMIT desk.queue()->failed(job);
        QCOMPARE(told.back(), QStringLiteral("Failed Image quilting: No memory."));
    }

    void firstExemplarStartsAQuickRunByItself() {
        MainWindow window;
        window.show();
        QVERIFY(child<QWidget>(window, "startPage")->isVisible());
        QVERIFY(openAndFinish(window, m_exemplar));
        QVERIFY(window.results()->isVisible());
        QVERIFY(window.desk()->controller()->quick());
        QVERIFY(window.results()->title().contains(QStringLiteral("Quick preview")));

        const Result& result = *window.desk()->result();
        const ImageViewer* viewer = window.results()->viewer(ResultView::ResultTab);
        QVERIFY(viewer->picture());
        QVERIFY(&viewer->picture()->values() == &result.synthesis.image);
        QCOMPARE(result.synthesis.mapKind, MapKind::Exact);
        QVERIFY(samePixels(result.synthesis.map.apply(result.plan.request.exemplars.front().image->view()),
                           result.synthesis.image));
        QVERIFY(samePixels(window.results()->viewer(ResultView::SynthesisTab)->picture()->values(),
                           synthesisPicture(result.synthesis.map)));
        QTRY_VERIFY(window.results()->viewer(ResultView::PositionTab)->picture());
        QVERIFY(samePixels(window.results()->viewer(ResultView::PositionTab)->picture()->values(),
                           positionPicture({96, 80})));
    }

    void quickIsSmallAndRunIsFull() {
        MainWindow window;
        window.show();
        QVERIFY(openAndFinish(window, m_exemplar));
        window.inspector()->output()->setOutputSize({800, 400});
        QVERIFY((window.input(true).size == Size{384, 192}));
        QVERIFY((window.input(false).size == Size{800, 400}));
        QVERIFY(window.input(true).steps.front().parameters == window.input(false).steps.front().parameters);
        QCOMPARE(window.input(true).seed, window.input(false).seed);
    }

    void runBringsItsPictureToTheFront() {
        MainWindow window;
        window.show();
        QVERIFY(openAndFinish(window, m_exemplar));
        const ImageViewer* const result = window.results()->viewer(ResultView::ResultTab);
        QSignalSpy finished(window.desk()->controller(), &RunController::finished);
        for (const char* place : {"showSynthesisMap", "lattice", "editExemplar", "compareGrid"}) {
            trigger(window, place);
            QTRY_VERIFY2(!result->isVisible(), place);
            trigger(window, "run");
            QVERIFY(finished.wait(kPatience));
            QVERIFY2(result->isVisible(), place);
        }
    }

    void secondExemplarStartsNothing() {
        MainWindow window;
        window.show();
        QVERIFY(openAndFinish(window, m_exemplar));
        QSignalSpy started(window.desk()->controller(), &RunController::started);
        QSignalSpy opened(window.store(), &ExemplarStore::opened);
        window.openFiles({m_large});
        QVERIFY(opened.wait());
        QTest::qWait(0);
        QVERIFY(started.isEmpty() && !window.desk()->running());
    }

    void hoverMarksTheSource() {
        MainWindow window;
        window.show();
        QVERIFY(openAndFinish(window, m_exemplar));
        QTRY_VERIFY(window.results()->viewer(ResultView::PositionTab)->picture());
        const QPoint pixel(31, 17);
        const Source source = window.desk()->result()->synthesis.map.at(pixel.x(), pixel.y());
        Q_EMIT window.results()->viewer(ResultView::ResultTab)->hovered(pixel);
        const QPoint expected(source.x, source.y);
        QVERIFY(window.exemplarPanel()->viewer()->marker() == expected);
        QVERIFY(window.results()->viewer(ResultView::PositionTab)->marker() == expected);
        const QString text = child<Readout>(window, "readout")->text();
        const QString place = QStringLiteral("x 31, y 17 → weave x %1, y %2").arg(source.x).arg(source.y);
        QVERIFY2(text.startsWith(place), qPrintable(text));
        Q_EMIT window.results()->viewer(ResultView::ResultTab)->unhovered();
        QVERIFY(!window.exemplarPanel()->viewer()->marker());
    }

    void stoppedRunLeavesItsPictureAsAResult() {
        MainWindow window;
        window.show();
        QVERIFY(openAndFinish(window, m_large));
        chooseLongRun(window);
        QSignalSpy previewed(window.desk()->controller(), &RunController::previewed);
        QSignalSpy finished(window.desk()->controller(), &RunController::finished);
        window.startRun(false);
        QVERIFY(previewed.wait(kPatience));
        QVERIFY(child<QAction>(window, "stop")->isEnabled());
        trigger(window, "stop");
        QVERIFY(finished.wait(kPatience));
        QVERIFY(!window.desk()->running());
        const ImageViewer* viewer = window.results()->viewer(ResultView::ResultTab);
        QVERIFY((viewer->picture()->size() == Size{2048, 2048}));
        QVERIFY2(viewer->picture()->transparent(),
                 "what was not made yet is not shown as though it were black");
        QVERIFY2(viewer->badge().startsWith(QStringLiteral("Stopped at ")), qPrintable(viewer->badge()));
        QVERIFY(child<QAction>(window, "export")->isEnabled());
        QTRY_VERIFY(child<QAction>(window, "run")->isEnabled());
    }

    void cancelledRunEndsAtOnceAndTheFormerResultIsBack() {
        MainWindow window;
        window.show();
        QVERIFY(openAndFinish(window, m_large));
        const auto before = window.desk()->result();
        chooseLongRun(window);
        QSignalSpy previewed(window.desk()->controller(), &RunController::previewed);
        QSignalSpy cancelled(window.desk()->controller(), &RunController::cancelled);
        window.startRun(false);
        QVERIFY(previewed.wait(kPatience));
        QElapsedTimer clock;
        clock.start();
        trigger(window, "cancelRun");
        QVERIFY(cancelled.wait());
        QVERIFY(inTime(clock.elapsed(), 500ms));
        QVERIFY(!window.desk()->running());
        const ImageViewer* viewer = window.results()->viewer(ResultView::ResultTab);
        QVERIFY(&viewer->picture()->values() == &before->synthesis.image);
        QVERIFY(child<QAction>(window, "export")->isEnabled());
    }

    void synthesisMapFillsInLive() {
        MainWindow window;
        window.show();
        QVERIFY(openAndFinish(window, m_large));
        chooseLongRun(window);
        QSignalSpy previewed(window.desk()->controller(), &RunController::previewed);
        window.startRun(false);
        QVERIFY(previewed.wait(kPatience));
        const ImageViewer* map = window.results()->viewer(ResultView::SynthesisTab);
        QVERIFY(map->picture() && map->picture()->transparent());
        QCOMPARE(map->badge(), QStringLiteral("Preview 1:%1").arg(map->picture()->step()));
    }

    void shortcutsSayWhatKeysDoEvenWhileTheyCannot() {
        MainWindow window;
        window.show();
        QVERIFY(openAndFinish(window, m_exemplar));
        window.inspector()->setValues({{"patch", 500}});
        QTRY_VERIFY(!child<QAction>(window, "quick")->isEnabled());
        trigger(window, "shortcuts");
        auto* table = child<QTableWidget>(*child<QDialog>(window, "shortcutsDialog"), "shortcutsTable");
        for (int row = 0; row < table->rowCount(); ++row)
            QVERIFY2(!table->item(row, 1)->text().contains(QStringLiteral("500 px")),
                     qPrintable(table->item(row, 0)->text()));
    }

    void tooLargeAPatchIsSaidInPlaceAndTheResultStays() {
        MainWindow window;
        window.show();
        QVERIFY(openAndFinish(window, m_exemplar));
        const auto before = window.desk()->result();
        window.inspector()->setValues({{"patch", 500}});
        QTRY_VERIFY(!window.runPanel()->refusal().isEmpty());
        QVERIFY2(window.runPanel()->refusal().contains(QStringLiteral("500 px")),
                 qPrintable(window.runPanel()->refusal()));
        QVERIFY(!child<QAction>(window, "run")->isEnabled());
        window.startRun(false);
        QTRY_VERIFY(window.messages()->isVisible());
        QCOMPARE(window.messages()->kind(), MessageBar::Kind::Error);
        QVERIFY(window.messages()->text().contains(QStringLiteral("500 px")));
        QVERIFY(window.desk()->result() == before);
        QVERIFY(&window.results()->viewer(ResultView::ResultTab)->picture()->values() ==
                &before->synthesis.image);
        window.inspector()->resetAll();
        QTRY_VERIFY(child<QAction>(window, "run")->isEnabled());
        QVERIFY(window.runPanel()->refusal().isEmpty());
    }

    void closingWhileRunningEndsAtOnce() {
        auto window = std::make_unique<MainWindow>();
        window->show();
        QVERIFY(openAndFinish(*window, m_large));
        chooseLongRun(*window);
        QSignalSpy previewed(window->desk()->controller(), &RunController::previewed);
        window->startRun(false);
        QVERIFY(previewed.wait(kPatience));
        QElapsedTimer clock;
        clock.start();
        window->close();
        window.reset();
        QVERIFY(inTime(clock.elapsed(), 1000ms));
    }

    void aRunAskedForDuringAnotherComesNext() {
        MainWindow window;
        window.show();
        QVERIFY(openAndFinish(window, m_large));
        chooseLongRun(window);
        const JobQueue* const queue = window.desk()->queue();
        QSignalSpy started(queue, &JobQueue::started);
        QSignalSpy changed(queue, &JobQueue::changed);
        QSignalSpy finished(window.desk()->controller(), &RunController::finished);
        window.startRun(false);
        QVERIFY(started.wait(kPatience));
        window.inspector()->output()->setOutputSize({64, 64});
        changed.clear();
        window.startRun(false);
        QVERIFY(changed.wait());
        QCOMPARE(queue->waiting(), 1);
        QVERIFY((queue->current()->plan.request.size == Size{2048, 2048}));
        trigger(window, "cancelRun");
        QVERIFY(finished.wait(kPatience));
        QVERIFY((window.desk()->result()->plan.request.size == Size{64, 64}));
    }

    void aQuickPreviewGivesWay() {
        MainWindow window;
        window.show();
        QSignalSpy started(window.desk()->controller(), &RunController::started);
        window.openFiles({m_large});
        QVERIFY(started.wait(kPatience));
        QVERIFY(window.desk()->controller()->quick());
        QSignalSpy finished(window.desk()->controller(), &RunController::finished);
        window.inspector()->output()->setOutputSize({128, 128});
        window.startRun(false);
        QVERIFY(finished.wait(kPatience));
        QTRY_VERIFY((window.desk()->result()->plan.request.size == Size{128, 128}));
        QVERIFY(!window.messages()->isVisible());
    }

    void keysWork() {
        MainWindow window;
        window.show();
        QVERIFY(QTest::qWaitForWindowActive(&window));
        QVERIFY(openAndFinish(window, m_exemplar));
        ImageViewer* const viewer = window.results()->viewer(ResultView::ResultTab);
        for (QWidget* focused : {static_cast<QWidget*>(viewer), static_cast<QWidget*>(&window)}) {
            focused->setFocus();
            QTest::keyClick(focused, Qt::Key_W);
            QVERIFY(viewer->repeats());
            QVERIFY(child<QAction>(window, "repeat")->isChecked());
            QTest::keyClick(focused, Qt::Key_W);
            QVERIFY(!viewer->repeats());
        }
        auto* width = child<QWidget>(*window.inspector(), "outputWidth");
        width->setFocus();
        QTest::keyClick(width, Qt::Key_1);
        QVERIFY(viewer->fitted());
        QTest::keyClick(viewer, Qt::Key_1);
        QVERIFY(!viewer->fitted());
        QSignalSpy started(window.desk()->controller(), &RunController::started);
        QTRY_VERIFY(child<QAction>(window, "run")->isEnabled());
        QTest::keyClick(&window, Qt::Key_Return, Qt::ControlModifier);
        QVERIFY(started.wait());
        QVERIFY(!window.desk()->controller()->quick());
        QTest::keyClick(&window, Qt::Key_2, Qt::ControlModifier);
        QCOMPARE(window.results()->currentViewer(), window.results()->viewer(ResultView::SynthesisTab));
    }

    void whatQuickCannotDoIsSaid() {
        MainWindow window;
        window.show();
        QVERIFY(openAndFinish(window, m_large));
        window.inspector()->setValues({{"patch", 400}});
        window.inspector()->output()->setOutputSize({1024, 1024});
        window.inspector()->output()->setWrap({true, true});
        QTRY_VERIFY(!child<QAction>(window, "quick")->isEnabled());
        QTRY_VERIFY(child<QAction>(window, "run")->isEnabled());
        QTRY_VERIFY(child<QAction>(window, "quick")->toolTip().contains(QStringLiteral("400 px")));
    }

    void unlockedSeedChangesWithEachRun() {
        MainWindow window;
        window.show();
        QVERIFY(openAndFinish(window, m_exemplar));
        QSignalSpy finished(window.desk()->controller(), &RunController::finished);
        const std::uint64_t seed = window.inspector()->output()->seed();
        trigger(window, "run");
        QVERIFY(finished.wait(kPatience));
        QCOMPARE(window.desk()->result()->plan.request.seed, seed);
        trigger(window, "newSeedRun");
        QVERIFY(finished.wait(kPatience));
        QVERIFY(window.desk()->result()->plan.request.seed != seed);
        QCOMPARE(window.desk()->result()->plan.request.seed, window.inspector()->output()->seed());
    }

    void eventLoopIsNeverBlocked() {
        MainWindow window;
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        QCoreApplication::processEvents();
        Heartbeat heart;
        QVERIFY(openAndFinish(window, m_large));
        QSignalSpy finished(window.desk()->controller(), &RunController::finished);
        window.inspector()->output()->setOutputSize({1024, 1024});
        window.startRun(false);
        QVERIFY(finished.wait(kPatience));
        qInfo("longest pause of the event loop: %lld ms", heart.longest());
        QVERIFY(heart.longest() > 0);
        QVERIFY(inTime(heart.longest(), 250ms));
    }

private:
    QTemporaryDir m_folder;
    QString m_exemplar;
    QString m_large;
};

TEXLOOM_UI_TESTS(RunTest)
#include "run_test.moc"
