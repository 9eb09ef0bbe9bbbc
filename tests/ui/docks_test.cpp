#include "core/io/image_file.h"
#include "tests/ui/window_fixture.h"
#include "ui/common/text.h"
#include "ui/inspector/inspector.h"
#include "ui/inspector/output_group.h"
#include "ui/log/log_panel.h"
#include "ui/maps/result_view.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QDir>
#include <QDockWidget>
#include <QSignalSpy>
#include <QToolButton>
#include <QTreeWidget>

using namespace texloom;
using namespace texloom::ui;

namespace {

RunPlan planFor(const QString& exemplar, Size size, std::uint64_t seed) {
    RunInput input;
    input.steps.front().method = "quilting";
    input.steps.front().parameters = {{"patch", 16}};
    input.exemplars.push_back({loadExemplar(toPath(exemplar)), {}, {}});
    input.size = size;
    input.seed = seed;
    return planRun(input);
}

std::vector<std::uint64_t> seedsOf(const JobQueue& queue) {
    std::vector<std::uint64_t> seeds;
    for (const QueuedJob& job : queue.jobs())
        seeds.push_back(job.plan.request.seed);
    return seeds;
}

} // namespace

/// The other docks at the bottom: jobs and log, and how docks are laid out.
class DocksTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() {
        m_exemplar = writeTexture(m_folder, QStringLiteral("weave.png"), {96, 80});
        m_large = writeTexture(m_folder, QStringLiteral("large weave.png"), {512, 512});
    }

    void init() { QDir(resultFolder()).removeRecursively(); }

    void queueKeepsItsOrder() {
        RunController controller;
        JobQueue queue(&controller);
        queue.setPaused(true);
        std::vector<int> ids;
        for (std::uint64_t seed = 1; seed <= 4; ++seed)
            ids.push_back(
                queue.add(planFor(m_exemplar, {64, 64}, seed), false, false, JobQueue::Place::Last));
        QVERIFY(!controller.running());
        queue.move(ids[3], -1);
        queue.move(ids[0], -1); // it is the first already
        queue.cancel(ids[1]);
        QVERIFY((seedsOf(queue) == std::vector<std::uint64_t>{1, 4, 3}));
        std::vector<std::uint64_t> made;
        connect(&queue, &JobQueue::finished, this,
                [&](const QueuedJob& job) { made.push_back(job.plan.request.seed); });
        queue.setPaused(false);
        QTRY_COMPARE_WITH_TIMEOUT(made.size(), std::size_t{3}, kPatience);
        QVERIFY((made == std::vector<std::uint64_t>{1, 4, 3}));
        QVERIFY(queue.jobs().empty());
    }

    void pauseLetsTheRunUnderWayEndAndRunStillWorks() {
        RunController controller;
        JobQueue queue(&controller);
        std::vector<std::uint64_t> made;
        connect(&queue, &JobQueue::finished, this,
                [&](const QueuedJob& job) { made.push_back(job.plan.request.seed); });
        queue.add(planFor(m_large, {160, 160}, 1), false, false, JobQueue::Place::Last);
        QVERIFY(controller.running());
        queue.setPaused(true);
        queue.add(planFor(m_exemplar, {64, 64}, 2), false, false, JobQueue::Place::Last);
        queue.add(planFor(m_exemplar, {64, 64}, 3), false, true, JobQueue::Place::Next);
        QTRY_COMPARE_WITH_TIMEOUT(made.size(), std::size_t{2}, kPatience);
        QTest::qWait(50);
        QVERIFY((made == std::vector<std::uint64_t>{1, 3}));
        QVERIFY(!controller.running());
        QCOMPARE(queue.waiting(), 1);
    }

    void cancellingStopsOneAndTheNextBegins() {
        RunController controller;
        JobQueue queue(&controller);
        const int first = queue.add(planFor(m_large, {2048, 2048}, 1), false, false, JobQueue::Place::Last);
        queue.add(planFor(m_exemplar, {64, 64}, 2), false, false, JobQueue::Place::Last);
        QSignalSpy cancelled(&queue, &JobQueue::cancelled);
        QSignalSpy finished(&queue, &JobQueue::finished);
        queue.cancel(first);
        QVERIFY(cancelled.wait());
        QTRY_COMPARE_WITH_TIMEOUT(finished.size(), 1, kPatience);
        QVERIFY(queue.jobs().empty());
    }

    void aRunThatDoesNotFitAnyMoreIsRefusedWithTheFigure() {
        RunController controller;
        JobQueue queue(&controller);
        queue.setPaused(true);
        RunPlan plan = planFor(m_exemplar, {64, 64}, 1);
        plan.estimate.bytes = std::uint64_t{3000} << 30; // free memory shrank since it was planned
        queue.add(std::move(plan), false, false, JobQueue::Place::Last);
        queue.add(planFor(m_exemplar, {64, 64}, 2), false, false, JobQueue::Place::Last);
        QSignalSpy finished(&queue, &JobQueue::finished);
        queue.setPaused(false);
        QVERIFY(finished.wait(kPatience));
        QCOMPARE(queue.jobs().size(), std::size_t{1});
        QVERIFY(queue.jobs().front().state == QueuedJob::State::Failed);
        QVERIFY2(queue.jobs().front().problem.contains(QStringLiteral("3000.0 GiB")),
                 qPrintable(queue.jobs().front().problem));
        queue.clear();
        QVERIFY(queue.jobs().empty());
    }

    void jobsDockShowsAndMovesWhatWaits() {
        MainWindow window;
        window.show();
        JobQueue* const queue = window.desk()->queue();
        queue->setPaused(true);
        for (std::uint64_t seed = 1; seed <= 3; ++seed)
            queue->add(planFor(m_exemplar, {64, 64}, seed), false, false, JobQueue::Place::Last);
        auto* list = child<QTreeWidget>(window, "jobList");
        QCOMPARE(list->topLevelItemCount(), 3);
        list->setCurrentItem(list->topLevelItem(2));
        trigger(window, "jobUp");
        QVERIFY((seedsOf(*queue) == std::vector<std::uint64_t>{1, 3, 2}));
        QCOMPARE(list->indexOfTopLevelItem(list->selectedItems().front()), 1);
        trigger(window, "cancelJob");
        QCOMPARE(list->topLevelItemCount(), 2);
        trigger(window, "clearJobs");
        QCOMPARE(list->topLevelItemCount(), 0);
        QVERIFY(queue->jobs().empty());
    }

    void queuedSettingsAreFrozen() {
        MainWindow window;
        window.show();
        QVERIFY(openAndFinish(window, m_exemplar));
        JobQueue* const queue = window.desk()->queue();
        queue->setPaused(true);
        window.inspector()->output()->setOutputSize({64, 48});
        window.inspector()->output()->setSeed(41);
        trigger(window, "addToQueue");
        QTRY_COMPARE(queue->waiting(), 1);
        window.inspector()->output()->setSeed(42);
        const auto before = window.desk()->result();
        QSignalSpy finished(queue, &JobQueue::finished);
        queue->setPaused(false);
        QVERIFY(finished.wait(kPatience));
        const ResultEntry& entry = window.desk()->history()->entries().back();
        QCOMPARE(entry.recipe.seed, 41U);
        QVERIFY((entry.recipe.size == Size{64, 48}));
        QVERIFY2(window.desk()->result() == before, "the queue works behind what is shown");
    }

    void aQueuedRunCanBeWatched() {
        MainWindow window;
        window.show();
        QVERIFY(openAndFinish(window, m_exemplar));
        JobQueue* const queue = window.desk()->queue();
        QSignalSpy finished(queue, &JobQueue::finished);
        queue->add(planFor(m_large, {120, 120}, 3), false, false, JobQueue::Place::Last);
        auto* list = child<QTreeWidget>(window, "jobList");
        Q_EMIT list->itemActivated(list->topLevelItem(0), 0);
        QVERIFY(window.results()->title().startsWith(QStringLiteral("Under way")));
        QVERIFY(finished.wait(kPatience));
        QVERIFY((window.desk()->result()->plan.request.size == Size{120, 120}));
    }

    void threadBudgetHolds() {
        RunController controller;
        JobQueue queue(&controller);
        queue.setThreads(1);
        RunPlan plan = planFor(m_exemplar, {64, 64}, 1);
        plan.threads = 2;
        std::shared_ptr<const Result> made;
        connect(&queue, &JobQueue::finished, this,
                [&](const QueuedJob&, const std::shared_ptr<const Result>& result) { made = result; });
        queue.add(std::move(plan), false, false, JobQueue::Place::Last);
        QTRY_VERIFY_WITH_TIMEOUT(made, kPatience);
        QCOMPARE(made->plan.threads, 1);
    }

    void logNotesRunsAndCanBeCopied() {
        MainWindow window;
        window.show();
        QVERIFY(openAndFinish(window, m_exemplar));
        const QString log = window.log()->text();
        QVERIFY2(log.contains(QStringLiteral("Started: ")) && log.contains(QStringLiteral("Finished in ")),
                 qPrintable(log));
        child<QToolButton>(window, "copyLog")->click();
        QCOMPARE(QApplication::clipboard()->text(), log);
        window.openFiles({QStringLiteral("/no/such/picture.png")});
        QTRY_VERIFY(window.log()->text().contains(QStringLiteral("/no/such/picture.png")));
    }

    void layoutIsResetWithTheDocks() {
        MainWindow window;
        window.show();
        auto* docks = child<QDockWidget>(window, "jobDock");
        docks->setFloating(true);
        docks->hide();
        trigger(window, "resetLayout");
        QVERIFY(!docks->isFloating());
        QVERIFY(docks->toggleViewAction()->isChecked());
    }

private:
    QTemporaryDir m_folder;
    QString m_exemplar;
    QString m_large;
};

TEXLOOM_UI_TESTS(DocksTest)
#include "docks_test.moc"
