#include "core/base/version.h"
#include "core/session/export/export.h"
#include "tests/ui/window_fixture.h"
#include "ui/common/background.h"
#include "ui/common/message_bar.h"
#include "ui/common/text.h"
#include "ui/exemplar/files.h"
#include "ui/inspector/inspector.h"
#include "ui/inspector/output_group.h"
#include "ui/log/log_panel.h"
#include "ui/maps/result_view.h"
#include "ui/plots/figures_panel.h"
#include "ui/runs/run_checkpoint.h"
#include "ui/session/document.h"
#include "ui/window/drop_targets.h"

#include <QAction>
#include <QComboBox>
#include <QDateTime>
#include <QDir>
#include <QDockWidget>
#include <QDropEvent>
#include <QElapsedTimer>
#include <QFile>
#include <QMessageBox>
#include <QMimeData>
#include <QProcess>
#include <QPushButton>
#include <QSignalSpy>
#include <QToolButton>

#include <nlohmann/json.hpp>

using namespace texloom;
using namespace texloom::ui;

namespace {

const char* const kKilledFolder = "TEXLOOM_TEST_KILLED";

/// A run in rounds, each of which is shown, adds to a curve, and can be taken up again.
RunInput roundsOf(const QString& exemplar, int rounds, int pause) {
    RunInput input;
    input.steps.front() = {"slow-diffusion", {{"rounds", rounds}, {"pause", pause}}};
    input.exemplars.push_back({loadExemplar(toPath(exemplar)), {}, {}});
    input.size = {80, 64};
    input.seed = 5;
    return input;
}

QStringList checkpointsIn(const QString& folder) {
    return QDir(folder).entryList({QStringLiteral("*.checkpoint")}, QDir::Files);
}

/// What is killed: a program with a run that leaves checkpoints.
int runUntilKilled(const QString& folder) {
    RunDesk desk(folder + QStringLiteral("/results"));
    desk.setCheckpointFolder(folder);
    desk.run(roundsOf(folder + QStringLiteral("/weave.png"), 100, 50), false);
    return QApplication::exec();
}

} // namespace

/// That work is worth keeping: runs that are stopped, or broken off by a crash, and results that become
/// inputs.
class KeptTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() {
        m_folder = std::make_unique<QTemporaryDir>();
        m_exemplar = writeTexture(*m_folder, QStringLiteral("weave.png"), {64, 48});
        m_window = std::make_unique<MainWindow>();
        m_window->document()->recovery()->setFolder(m_folder->path());
        m_window->desk()->setCheckpointFolder(m_folder->path());
        m_window->show();
        QTRY_VERIFY(m_window->desk()->history()->ready());
    }
    void cleanup() { m_window.reset(); }

    void aStoppedRunBecomesAResult() {
        startRounds(500, 10);
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
        QSignalSpy finished(controller(), &RunController::finished);
        QTest::keyClick(m_window.get(), Qt::Key_Escape);
        QVERIFY(finished.wait(kPatience));
        const Result& result = *m_window->desk()->result();
        QVERIFY(result.stoppedAt && *result.stoppedAt > 0 && *result.stoppedAt < 1);
        const QString share = percentText(*result.stoppedAt);
        QVERIFY(m_window->desk()->resultShown());
        QCOMPARE(m_window->results()->viewer(ResultView::ResultTab)->badge(),
                 QStringLiteral("Stopped at ") + share);
        QVERIFY(m_window->results()->title().startsWith(QStringLiteral("Stopped at ") + share));

        const ResultHistory* const history = m_window->desk()->history();
        const QModelIndex newest = history->index(0);
        QCOMPARE(history->entries().back().stoppedAt, result.stoppedAt);
        const QString mark = QStringLiteral("stopped at ") + share;
        QVERIFY(newest.data(ResultHistory::ChipsRole).toStringList().contains(mark));
        QVERIFY(newest.data(Qt::AccessibleTextRole).toString().contains(mark));
        QVERIFY(
            newest.data(Qt::ToolTipRole).toString().contains(QStringLiteral("at %1 of the work").arg(share)));
        QVERIFY(m_window->log()->text().contains(QStringLiteral("Stopped at %1 and kept").arg(share)));

        QVERIFY(child<QAction>(*m_window, "export")->isEnabled());
        ExportOptions options;
        options.image = toPath(m_folder->filePath(QStringLiteral("part.png")));
        exportResult(result, options);
        const auto sidecar = toPath(m_folder->filePath(QStringLiteral("part.json")));
        QCOMPARE(nlohmann::json::parse(readText(sidecar)).at("outputs").at(0).at("stoppedAt").get<double>(),
                 *result.stoppedAt);
        QCOMPARE(readRecipe(sidecar).steps.front().method, std::string("slow-diffusion"));
    }

    void aRunThatIsCancelledLeavesNothing() {
        startRounds(500, 10);
        const auto before = m_window->desk()->result();
        const int kept = m_window->desk()->history()->rowCount();
        QTRY_VERIFY(!checkpointsIn(m_folder->path()).isEmpty());
        QSignalSpy cancelled(controller(), &RunController::cancelled);
        QTest::keyClick(m_window.get(), Qt::Key_Escape, Qt::ShiftModifier);
        QVERIFY(cancelled.wait(kPatience));
        QCOMPARE(m_window->desk()->history()->rowCount(), kept);
        QVERIFY(m_window->desk()->resultShown() && m_window->desk()->result() == before);
        QVERIFY(m_window->messages()->text().startsWith(QStringLiteral("Cancelled at ")));
        QVERIFY(checkpointsIn(m_folder->path()).isEmpty());
    }

    void theJobsDockStopsAndCancels() {
        startRounds(500, 10);
        QSignalSpy finished(controller(), &RunController::finished);
        QVERIFY(child<QAction>(*m_window, "stopJob")->isEnabled());
        trigger(*m_window, "stopJob");
        QVERIFY(finished.wait(kPatience));
        QVERIFY(m_window->desk()->result()->stoppedAt);
        QVERIFY(!child<QAction>(*m_window, "stopJob")->isEnabled());
    }

    void whereThereIsNothingToKeepYetThatIsSaid() {
        QVERIFY(openAndFinish(*m_window, m_exemplar));
        chooseRounds(3, 1000);
        QSignalSpy started(controller(), &RunController::started),
            finished(controller(), &RunController::finished),
            cancelled(controller(), &RunController::cancelled);
        const auto stopAtOnce = [&] {
            started.clear();
            m_window->startRun(false);
            QVERIFY(started.wait(kPatience));
            trigger(*m_window, "stop");
            QVERIFY(m_window->messages()->text().startsWith(QStringLiteral("There is no picture yet")));
        };
        stopAtOnce();
        QVERIFY(finished.wait(kPatience));
        QVERIFY(m_window->desk()->result()->stoppedAt);
        QVERIFY(m_window->messages()->text().isEmpty());
        stopAtOnce();
        child<QPushButton>(*m_window, "messageAction")->click();
        QVERIFY(cancelled.wait(kPatience));
    }

    void curvesGrowInTheFigures() {
        auto* panel = child<FiguresPanel>(*m_window, "figuresPanel");
        QVERIFY(openAndFinish(*m_window, m_exemplar));
        child<QDockWidget>(*m_window, "figureDock")->raise();
        QTRY_VERIFY(panel->titles().contains(QStringLiteral("Numbers")));
        QSignalSpy grew(controller(), &RunController::curvesGrew),
            previewed(controller(), &RunController::previewed),
            finished(controller(), &RunController::finished);
        chooseRounds(400, 5);
        m_window->startRun(false);
        QElapsedTimer clock;
        clock.start();
        QTRY_COMPARE_WITH_TIMEOUT(panel->titles(), QStringList{QStringLiteral("Round")}, kPatience);
        const auto drawn = [&] {
            return panel->plot()->data().empty() ? 0U : panel->plot()->data().series.front().points.size();
        };
        const std::size_t first = drawn();
        QVERIFY(first > 0);
        QTRY_VERIFY_WITH_TIMEOUT(drawn() > first, kPatience);
        QVERIFY(m_window->desk()->running());
        QVERIFY2(grew.size() <= previewed.size() + 2 + clock.elapsed() / 500,
                 "no more often than pictures come");
        trigger(*m_window, "stop");
        QVERIFY(finished.wait(kPatience));
        QTRY_VERIFY(panel->titles().contains(QStringLiteral("Numbers")));
        QVERIFY(panel->titles().contains(QStringLiteral("Round")));
        QCOMPARE(panel->plot()->data().title, QStringLiteral("Round")); // still the one looked at
        QCOMPARE(drawn(), m_window->desk()->result()->synthesis.curves.front().values.size());
    }

    void aKilledRunGoesOnToTheSameBits() {
        QProcess program;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QLatin1String(kKilledFolder), m_folder->path());
        program.setProcessEnvironment(environment);
        program.setProcessChannelMode(QProcess::ForwardedChannels);
        program.start(QCoreApplication::applicationFilePath(), {});
        const auto progress = [&] {
            const QStringList files = checkpointsIn(m_folder->path());
            return files.isEmpty()
                       ? 0
                       : readCheckpoint(toPath(m_folder->filePath(files.front()))).checkpoint.progress;
        };
        QTRY_VERIFY_WITH_TIMEOUT(progress() > 0.1, kPatience);
        QVERIFY2(!newestBrokenRun(m_folder->path()), "its program is still there");
        program.kill();
        QVERIFY(program.waitForFinished());
        const double reached = progress();
        QVERIFY(reached < 1);

        m_window->offerRecovery();
        QMessageBox* const box = question();
        QVERIFY(box != nullptr);
        auto* goOn = child<QPushButton>(*box, "goOn");
        QVERIFY2(goOn->text().contains(percentText(reached)), qPrintable(goOn->text()));
        QSignalSpy finished(controller(), &RunController::finished);
        std::size_t drawnFirst = 0;
        const QObject whileThisGoes;
        connect(controller(), &RunController::curvesGrew, &whileThisGoes,
                [&](const std::vector<Curve>& curves) {
                    if (drawnFirst == 0)
                        drawnFirst = curves.front().values.size();
                });
        goOn->click();
        QVERIFY(finished.wait(kPatience));
        const RunInput whole = roundsOf(m_exemplar, 100, 0);
        const Result straight = std::get<Result>(startRun(planRun(whole), false)->take());
        QVERIFY(samePixels(m_window->desk()->result()->synthesis.image, straight.synthesis.image));
        QVERIFY(m_window->desk()->result()->synthesis.curves.front().values ==
                straight.synthesis.curves.front().values);
        QVERIFY2(static_cast<double>(drawnFirst) >= 100 * reached - 0.5,
                 "the first rounds were not made again, and are drawn from the start");
        QVERIFY(checkpointsIn(m_folder->path()).isEmpty());
        QTRY_COMPARE(m_window->store()->entries().size(), 1U); // its settings are there to be changed
        QCOMPARE(m_window->inspector()->method()->id(), std::string("slow-diffusion"));
    }

    void aClosedWindowLeavesItsRunForAnotherTime() {
        startRounds(500, 10);
        QTRY_VERIFY(!checkpointsIn(m_folder->path()).isEmpty());
        m_window->close();
        m_window.reset();
        QCOMPARE(checkpointsIn(m_folder->path()).size(), 1);
        m_window = std::make_unique<MainWindow>();
        m_window->document()->recovery()->setFolder(m_folder->path());
        m_window->show();
        m_window->offerRecovery();
        QMessageBox* const box = question();
        QVERIFY(box != nullptr);
        child<QPushButton>(*box, "discardBroken")->click();
        QVERIFY(checkpointsIn(m_folder->path()).isEmpty());
    }

    void aFinishedRunLeavesNoCheckpoint() {
        startRounds(20, 10);
        QTRY_COMPARE(checkpointsIn(m_folder->path()).size(), 1);
        QTRY_VERIFY_WITH_TIMEOUT(m_window->desk()->resultShown(), kPatience);
        QVERIFY(!m_window->desk()->result()->stoppedAt);
        QVERIFY(QDir(m_folder->path()).entryList({QStringLiteral("*checkpoint*")}, QDir::Files).isEmpty());
    }

    void whatCannotGoOnIsRefusedInOneSentence_data() {
        QTest::addColumn<QString>("what");
        QTest::addColumn<QString>("sentence");
        QTest::newRow("exemplar") << "exemplar"
                                  << "weave.png";
        QTest::newRow("build") << "build"
                               << "0.0.1";
        QTest::newRow("damage") << "damage"
                                << "damaged";
        QTest::newRow("gone") << "gone"
                              << "weave.png";
    }

    void whatCannotGoOnIsRefusedInOneSentence() {
        QFETCH(QString, what);
        QFETCH(QString, sentence);
        const QString file = m_folder->filePath(QStringLiteral("one.checkpoint"));
        const RunPlan plan = planRun(roundsOf(m_exemplar, 10, 0));
        writeCheckpoint(toPath(file), plan.recipe, {0, 0.43, "state"});
        if (what == QLatin1String("exemplar"))
            writeTexture(*m_folder, QStringLiteral("weave.png"), {64, 48}, 9);
        else if (what == QLatin1String("gone"))
            QFile::remove(m_exemplar);
        else if (what == QLatin1String("damage"))
            writeText(toPath(file), readText(toPath(file)).substr(0, 40));
        else
            writeText(toPath(file), QString::fromStdString(readText(toPath(file)))
                                        .replace(QLatin1String(kVersion), QStringLiteral("0.0.1"))
                                        .toStdString());
        const QString other = writeTexture(*m_folder, QStringLiteral("other.png"), {40, 40});
        QVERIFY(openAndFinish(*m_window, other));
        m_window->offerRecovery();
        QMessageBox* const box = question();
        QVERIFY(box != nullptr);
        QVERIFY2(box->text().contains(sentence), qPrintable(box->text()));
        QVERIFY(box->findChild<QPushButton*>(QStringLiteral("goOn")) == nullptr);
        QCOMPARE(toQString(m_window->store()->current()->file().path), other);
        const bool known = what == QLatin1String("exemplar") || what == QLatin1String("build");
        auto* restore = box->findChild<QPushButton*>(QStringLiteral("restoreBroken"));
        QCOMPARE(restore != nullptr, known);
        if (restore != nullptr) {
            restore->click();
            QTRY_COMPARE(toQString(m_window->store()->current()->file().path), m_exemplar);
            QTRY_COMPARE(m_window->inspector()->method()->id(), std::string("slow-diffusion"));
        } else {
            child<QPushButton>(*box, "discardBroken")->click();
        }
        QVERIFY(!QFile::exists(file));
    }

    void aRunGoesOnWhereNoCheckpointCanBeWritten() {
        QFile blocked(m_folder->filePath(QStringLiteral("blocked")));
        QVERIFY(blocked.open(QIODevice::WriteOnly)); // a file where the folder should be
        m_window->desk()->setCheckpointFolder(blocked.fileName());
        QSignalSpy told(controller(), &RunController::unprotected);
        startRounds(40, 10);
        QTRY_VERIFY_WITH_TIMEOUT(m_window->desk()->resultShown(), kPatience);
        QCOMPARE(told.size(), 1);
        QVERIFY(!m_window->desk()->result()->stoppedAt);
    }

    void theShownResultGoesIntoAPort() {
        choose("stipple");
        const auto* const without = child<QToolButton>(*m_window, "useResult_target");
        QVERIFY(!without->isEnabled());
        QVERIFY(without->toolTip().startsWith(QStringLiteral("There is no result yet")));
        QVERIFY(openAndFinishWith("quilting"));
        choose("stipple");
        child<QToolButton>(*m_window, "useResult_target")->click();
        QTRY_VERIFY(pictureOf(m_window->input(false).inputs, "target") != nullptr);
        const ExemplarFile target = *pictureOf(m_window->input(false).inputs, "target");
        const Result& used = *m_window->desk()->result();
        QVERIFY(samePixels(*target.image, used.synthesis.image));
        QCOMPARE(target.hash, fileHash(target.path));
        const RecipeFile named = m_window->session().settings.inputs.at("target").front();
        QCOMPARE(named.hash, target.hash);

        m_window->inspector()->output()->setOutputSize(used.synthesis.image.size());
        QSignalSpy finished(controller(), &RunController::finished);
        m_window->startRun(false);
        QVERIFY(finished.wait(kPatience));
        const Recipe recipe = m_window->desk()->result()->plan.recipe;
        QCOMPARE(recipe.inputs.at("target").front().hash, target.hash);
        const RunInput again = loadRecipe(recipe);
        QVERIFY(samePixels(*pictureOf(again.inputs, "target")->image, *target.image));
    }

    void aResultIsDraggedIntoAPortOrBesideTheExemplar() {
        QVERIFY(openAndFinishWith("quilting"));
        const auto used = m_window->desk()->result();
        choose("stipple");
        const ResultHistory* const history = m_window->desk()->history();
        const std::unique_ptr<QMimeData> data(history->mimeData({history->index(0)}));
        const auto drag = [&](QWidget* over, QPoint point) {
            QDragEnterEvent enter(point, Qt::CopyAction, data.get(), Qt::LeftButton, Qt::NoModifier);
            QApplication::sendEvent(over, &enter);
        };
        const auto drop = [&](QWidget* over, QPoint point) {
            drag(over, point); // a drop goes to where the drag is
            QDropEvent event(point, Qt::CopyAction, data.get(), Qt::LeftButton, Qt::NoModifier);
            QApplication::sendEvent(over, &event);
        };
        drag(m_window.get(), QPoint(9, 9));
        auto* targets = child<DropTargets>(*m_window, "dropTargets");
        QVERIFY(targets->isVisible());
        QVERIFY(!targets->targetAt(targets->placeOf(DropTargets::Target::Companion).center()));
        QCOMPARE(targets->portAt(targets->placeOf("target").center()), std::string("target"));
        drop(targets, targets->placeOf("target").center());
        QTRY_VERIFY(pictureOf(m_window->input(false).inputs, "target") != nullptr);
        QVERIFY(
            samePixels(*pictureOf(m_window->input(false).inputs, "target")->image, used->synthesis.image));

        targets->open(DropTargets::Dragged::Result, true);
        drop(targets, targets->placeOf(DropTargets::Target::Add).center());
        QTRY_COMPARE(m_window->store()->entries().size(), 2U);
        QVERIFY(samePixels(*m_window->store()->current()->file().image, used->synthesis.image));

        drop(m_window.get(), QPoint(9, m_window->height() - 9)); // beside all targets
        workers().waitForDone();
        settle();
        QCOMPARE(m_window->store()->entries().size(), 2U);
    }

    void filesMadeHereStayAsLongAsARunCanGoOnFromThem() {
        RunInput input = roundsOf(m_exemplar, 10, 0);
        const RunPlan plan = planRun(input);
        const QString named = saveResult(testTexture({8, 8}), "named", "srgb", plan.recipe),
                      other = saveResult(testTexture({8, 8}), "other", "srgb", plan.recipe);
        for (const QString& path : {named, other}) {
            QFile file(path);
            QVERIFY(file.open(QIODevice::ReadWrite));
            QVERIFY(file.setFileTime(QDateTime::currentDateTime().addDays(-30),
                                     QFileDevice::FileModificationTime));
        }
        Recipe recipe = plan.recipe;
        recipe.inputs["target"] = {{toPath(named), "srgb", ""}};
        writeCheckpoint(toPath(m_folder->filePath(QStringLiteral("one.checkpoint"))), recipe,
                        {0, 0.5, "state"});
        removeOldFiles({}, m_folder->path());
        QVERIFY(QFile::exists(named));
        QVERIFY(!QFile::exists(other));
        QFile::remove(m_folder->filePath(QStringLiteral("one.checkpoint")));
        removeOldFiles({}, m_folder->path());
        QVERIFY(!QFile::exists(named));
    }

private:
    const RunController* controller() const { return m_window->desk()->controller(); }

    void choose(const char* id) {
        auto* method = child<QComboBox>(*m_window, "method");
        const int index = method->findData(QLatin1String(id));
        QVERIFY(index >= 0);
        method->setCurrentIndex(index);
    }

    bool openAndFinishWith(const char* id) {
        choose(id);
        return openAndFinish(*m_window, m_exemplar);
    }

    void chooseRounds(int rounds, int pause) {
        choose("slow-diffusion");
        m_window->inspector()->setValues({{"rounds", rounds}, {"pause", pause}});
        m_window->inspector()->output()->setOutputSize({80, 64});
    }

    /// Begins a run in rounds that has a picture.
    void startRounds(int rounds, int pause) {
        QVERIFY(openAndFinish(*m_window, m_exemplar));
        chooseRounds(rounds, pause);
        QSignalSpy previewed(controller(), &RunController::previewed);
        m_window->startRun(false);
        QVERIFY(previewed.wait(kPatience));
        QVERIFY(!m_window->desk()->resultShown());
    }

    /// The question about a broken run, once it is asked.
    QMessageBox* question() {
        QMessageBox* box = nullptr;
        const auto asked = [&] {
            box = m_window->findChild<QMessageBox*>(QStringLiteral("brokenRunDialog"));
            return box != nullptr;
        };
        return QTest::qWaitFor(asked, kPatience) ? box : nullptr;
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<MainWindow> m_window;
    QString m_exemplar;
};

int main(int argc, char** argv) {
    return runTests(argc, argv, [](int count, char** values) {
        if (const QString folder = qEnvironmentVariable(kKilledFolder); !folder.isEmpty())
            return runUntilKilled(folder);
        KeptTest tests;
        return QTest::qExec(&tests, count, values);
    });
}

#include "kept_test.moc"
