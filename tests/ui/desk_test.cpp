#include "core/image/image.h"
#include "ui/runs/quick_run.h"
#include "ui/runs/run_desk.h"

#include <QCoreApplication>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cmath>

using namespace texloom;
using namespace texloom::ui;

namespace {

ExemplarFile waves(Size size) {
    Image image(size, 3);
    for (int c = 0; c < 3; ++c)
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
                image(x, y, c) =
                    static_cast<float>(0.5 + 0.4 * std::sin(x * 0.31 + c) * std::cos(y * 0.23 * x));
    ExemplarFile file;
    file.path = "waves.png";
    file.image = std::make_shared<const Image>(std::move(image));
    return file;
}

RunInput runOf(std::uint64_t seed, Size size = {64, 48}) {
    RunInput input;
    input.steps.front().method = "quilting";
    input.steps.front().parameters = {{"patch", 16}};
    input.exemplars.push_back({waves({96, 80}), {}, {}});
    input.size = size;
    input.seed = seed;
    return input;
}

/// A run that is not over before it can be stopped.
RunInput longRun(std::uint64_t seed) {
    RunInput input = runOf(seed, {1500, 1500});
    input.steps.front().method = "texture-optimization";
    input.steps.front().parameters = {};
    return input;
}

} // namespace

/// The desk of runs, in a program that could not show a widget if one were made.
class DeskTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { qputenv("TEXLOOM_RESOURCES", TEXLOOM_RESOURCES); }

    void looksAhead() {
        RunDesk desk(m_folder.filePath(QStringLiteral("ahead")));
        QSignalSpy told(&desk, &RunDesk::outlookChanged);
        QVERIFY(!desk.canRun() && !desk.canQuick());
        desk.lookAhead(runOf(1));
        QVERIFY(told.wait());
        QVERIFY(desk.canRun() && desk.canQuick());
        const auto outlook = told.back().front().value<Outlook>();
        QVERIFY(outlook.estimate && outlook.estimate->bytes > 0 && outlook.refusal.isEmpty());

        RunInput wrong = runOf(1);
        wrong.steps.front().parameters = {{"patch", 90}};
        desk.lookAhead(wrong);
        QVERIFY(told.wait());
        QVERIFY(!desk.canRun() && !desk.canQuick());
        QVERIFY(!told.back().front().value<Outlook>().refusal.isEmpty());

        desk.lookAhead(runOf(1));
        desk.lookAway();
        QTest::qWait(100);
        QVERIFY2(!desk.canRun(), "what was asked for before there was nothing to run is not answered");
    }

    void aRunIsShownAndKept() {
        RunDesk desk(m_folder.filePath(QStringLiteral("kept")));
        QStringList order;
        connect(&desk, &RunDesk::accepted, this, [&] { order += QStringLiteral("accepted"); });
        connect(&desk, &RunDesk::watching, this, [&] { order += QStringLiteral("watching"); });
        connect(&desk, &RunDesk::kept, this, [&] { order += QStringLiteral("kept"); });
        connect(&desk, &RunDesk::shown, this, [&] { order += QStringLiteral("shown"); });
        QSignalSpy noted(&desk, &RunDesk::noted);
        desk.run(runOf(3), false);
        desk.run(runOf(4), false); // one at a time is planned
        QTRY_VERIFY_WITH_TIMEOUT(desk.resultShown(), kPatience);
        QCOMPARE(order, (QStringList{"accepted", "watching", "kept", "shown"}));
        QCOMPARE(desk.history()->rowCount(), 1);
        QCOMPARE(desk.last().key, desk.history()->entries().front().key);
        QCOMPARE(desk.result()->plan.request.seed, 3U);
        QVERIFY(desk.shownPlan()->request.exemplars.front().image ==
                desk.result()->plan.request.exemplars.front().image);
        const auto told = [&](const QString& begin) {
            return std::any_of(noted.begin(), noted.end(), [&](const QVariantList& line) {
                return line.front().toString().startsWith(begin);
            });
        };
        QVERIFY(told(QStringLiteral("Started: ")) && told(QStringLiteral("Finished in ")));
    }

    void aQueuedRunIsKeptButNotShown() {
        RunDesk desk(m_folder.filePath(QStringLiteral("queued")));
        QSignalSpy shown(&desk, &RunDesk::shown), kept(&desk, &RunDesk::kept),
            unseen(&desk, &RunDesk::endedUnseen);
        desk.enqueue(runOf(5));
        QVERIFY(kept.wait(kPatience));
        QVERIFY(shown.isEmpty() && unseen.isEmpty() && !desk.result() && !desk.shownPlan());
        desk.show(desk.history()->entries().front().key);
        QTRY_COMPARE(shown.size(), 1);
        QCOMPARE(desk.result()->plan.request.seed, 5U);
        QVERIFY(!desk.last().quick);
    }

    void theLastResultAskedForIsShown() {
        RunDesk desk(m_folder.filePath(QStringLiteral("asked")));
        QSignalSpy kept(&desk, &RunDesk::kept);
        for (const std::uint64_t seed : {1U, 2U, 3U}) {
            desk.enqueue(runOf(seed));
            QVERIFY(kept.wait(kPatience));
        }
        QSignalSpy shown(&desk, &RunDesk::shown);
        for (const ResultEntry& entry : desk.history()->entries())
            desk.show(entry.key);
        QTRY_COMPARE(shown.size(), 1);
        QTest::qWait(100);
        QCOMPARE(shown.size(), 1);
        QCOMPARE(desk.last().key, desk.history()->entries().back().key);
    }

    void aCancelledRunLeavesWhatWasBefore() {
        RunDesk desk(m_folder.filePath(QStringLiteral("stopped")));
        desk.run(runOf(1), false);
        QTRY_VERIFY_WITH_TIMEOUT(desk.resultShown(), kPatience);
        QSignalSpy cancelled(&desk, &RunDesk::cancelled), previewed(&desk, &RunDesk::previewed);
        desk.run(longRun(2), false);
        QTRY_VERIFY_WITH_TIMEOUT(!previewed.isEmpty(), kPatience);
        QVERIFY(!desk.resultShown() && desk.running());
        QCOMPARE(desk.shownPlan()->request.seed, 2U);
        desk.cancel();
        QVERIFY(cancelled.wait(kPatience));
        QVERIFY(!desk.running() && desk.resultShown());
        QCOMPARE(desk.result()->plan.request.seed, 1U);
        QCOMPARE(desk.shownPlan()->request.seed, 1U);
        QCOMPARE(desk.history()->rowCount(), 1);
    }

    void aStoppedRunIsKeptAndTheNextBegins() {
        RunDesk desk(m_folder.filePath(QStringLiteral("stopped and kept")));
        QSignalSpy previewed(&desk, &RunDesk::previewed), kept(&desk, &RunDesk::kept);
        desk.run(longRun(2), false);
        QTRY_VERIFY_WITH_TIMEOUT(!previewed.isEmpty(), kPatience);
        desk.enqueue(runOf(3));
        desk.stopAndKeep();
        QTRY_COMPARE_WITH_TIMEOUT(kept.size(), 2, kPatience);
        const std::vector<ResultEntry>& entries = desk.history()->entries();
        QVERIFY(entries.front().stoppedAt && *entries.front().stoppedAt < 1 && !entries.back().stoppedAt);
        QCOMPARE(desk.result()->plan.request.seed, 2U);
        QCOMPARE(desk.result()->stoppedAt, entries.front().stoppedAt);
        QVERIFY(expectedSeconds(planRun(runOf(3)), entries).has_value());
        QVERIFY2(!expectedSeconds(planRun(longRun(2)), entries),
                 "a part tells nothing of how long all takes");
    }

    void whatCannotBeRunIsRefusedOnce() {
        RunDesk desk(m_folder.filePath(QStringLiteral("refused")));
        QSignalSpy refused(&desk, &RunDesk::refused), noted(&desk, &RunDesk::noted),
            accepted(&desk, &RunDesk::accepted);
        RunInput wrong = runOf(1);
        wrong.exemplars.clear();
        desk.run(wrong, false);
        QVERIFY(refused.wait());
        QCOMPARE(refused.size(), 1);
        QCOMPARE(noted.size(), 1);
        QVERIFY(accepted.isEmpty() && !desk.running());
        desk.run(runOf(2), false);
        QTRY_VERIFY_WITH_TIMEOUT(desk.resultShown(), kPatience);
    }

    void aWatchedRunIsShownAndHaltingWaits() {
        RunDesk desk(m_folder.filePath(QStringLiteral("watched")));
        QSignalSpy watching(&desk, &RunDesk::watching);
        desk.enqueue(longRun(8));
        QTRY_VERIFY_WITH_TIMEOUT(desk.running(), kPatience);
        QVERIFY(watching.isEmpty());
        desk.watch(desk.queue()->current()->id);
        QCOMPARE(watching.size(), 1);
        QSignalSpy previewed(&desk, &RunDesk::previewed);
        QTRY_VERIFY_WITH_TIMEOUT(!previewed.isEmpty(), kPatience);
        desk.halt();
        QVERIFY(!desk.running());
    }

    void aPreviewIsTheWholeOutputMadeSmall() {
        RunInput input = runOf(1, {800, 400});
        input.region = Region{10, 10, {50, 50}};
        input.inputs["initial"] = {waves({800, 400})};
        const RunInput quick = quickOf(input);
        QVERIFY((quick.size == Size{384, 192}));
        QVERIFY((pictureOf(quick.inputs, "initial")->image->size() == Size{384, 192}));
        QVERIFY(!quick.region);
        QCOMPARE((*pictureOf(quick.inputs, "initial")->image)(100, 50, 1),
                 (*pictureOf(input.inputs, "initial")->image)(100, 50, 1));
        QVERIFY((quickSize({300, 384}) == Size{300, 384}));
        QVERIFY((quickSize({100'000, 10}) == Size{384, 1}));
    }

private:
    QTemporaryDir m_folder;
};

QTEST_GUILESS_MAIN(DeskTest)
#include "desk_test.moc"
