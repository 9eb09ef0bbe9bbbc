#include "core/io/image_file.h"
#include "tests/ui/window_fixture.h"
#include "ui/common/message_bar.h"
#include "ui/common/text.h"
#include "ui/exemplar/exemplar_panel.h"
#include "ui/inspector/inspector.h"
#include "ui/inspector/output_group.h"
#include "ui/log/log_panel.h"
#include "ui/maps/result_view.h"
#include "ui/results/limits_dialog.h"
#include "ui/session/undo_history.h"

#include <QAction>
#include <QDir>
#include <QDoubleSpinBox>
#include <QElapsedTimer>
#include <QLineEdit>
#include <QListView>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTableWidget>

using namespace texloom;
using namespace texloom::ui;
using namespace std::chrono_literals;

namespace {

/// A finished run of 48 × 40 px made without a window.
std::shared_ptr<const Result> smallResult(const QString& exemplar, std::uint64_t seed) {
    RunInput input;
    input.steps.front().method = "random-phase";
    input.exemplars.push_back({loadExemplar(toPath(exemplar)), {}, {}});
    input.size = {48, 40};
    input.seed = seed;
    input.threads = 1;
    return std::make_shared<const Result>(std::get<Result>(startRun(planRun(input), false)->take()));
}

QImage plain(QRgb color) {
    QImage image(48, 40, QImage::Format_RGB32);
    image.fill(color);
    return image;
}

} // namespace

/// The dock of earlier results: what is kept, found again, shown and taken up.
class ResultsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { m_exemplar = writeTexture(m_folder, QStringLiteral("weave.png"), {96, 80}); }

    void init() { QDir(resultFolder()).removeRecursively(); }

    void everyRunIsKeptAndSurvivesTheWindow() {
        std::shared_ptr<const Result> made;
        std::string key;
        {
            MainWindow window;
            window.show();
            QVERIFY(openAndFinish(window, m_exemplar));
            made = window.desk()->result();
            ResultHistory* const history = window.desk()->history();
            QCOMPARE(history->rowCount(), 1);
            key = history->entries().back().key;
            QVERIFY(history->setData(history->indexOf(key), QStringLiteral("My weave"), Qt::EditRole));
            history->setPinned(key, true);
        }
        MainWindow again;
        again.show();
        ResultHistory* const history = again.desk()->history();
        QTRY_COMPARE(history->rowCount(), 1);
        const QModelIndex row = history->index(0);
        QCOMPARE(row.data().toString(), QStringLiteral("My weave"));
        QVERIFY(row.data(ResultHistory::PinnedRole).toBool());
        QTRY_VERIFY(!row.data(Qt::DecorationRole).value<QImage>().isNull());
        QVERIFY(history->entries().front().quick);

        again.desk()->show(key);
        QTRY_VERIFY(again.desk()->result());
        QVERIFY(again.results()->isVisible());
        QVERIFY(samePixels(again.desk()->result()->synthesis.image, made->synthesis.image));
        QVERIFY(again.desk()->result()->synthesis.map == made->synthesis.map);
        QVERIFY(again.results()->title().contains(QStringLiteral("Quick preview")));
        QVERIFY(child<QAction>(again, "export")->isEnabled());

        QSignalSpy opened(again.store(), &ExemplarStore::opened);
        again.openFiles({m_exemplar});
        QVERIFY(opened.wait());
        again.desk()->show(key);
        QTRY_VERIFY(again.desk()->result() != nullptr && !again.desk()->running());
        const Source source = made->synthesis.map.at(9, 7);
        QTRY_VERIFY2((Q_EMIT again.results()->viewer(ResultView::ResultTab)->hovered({9, 7}),
                      again.exemplarPanel()->viewer()->marker() == QPoint(source.x, source.y)),
                     "a result that was read back is linked with the exemplar that is open");
    }

    void twoHundredResultsStayFluid() {
        const auto result = smallResult(m_exemplar, 1);
        MainWindow window;
        window.resize(1200, 800);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        ResultHistory* const history = window.desk()->history();
        QTRY_VERIFY(history->ready());
        for (int i = 0; i < 200; ++i)
            history->add(result, false, plain(qRgb(i, 255 - i, 80)));
        auto* list = child<QListView>(window, "resultList");
        QElapsedTimer clock;
        clock.start();
        for (int i = 0; i < 40; ++i) {
            list->scrollTo(list->model()->index(i * 5, 0));
            list->viewport()->repaint();
        }
        qInfo("%.2f ms for each of 40 pages", static_cast<double>(clock.elapsed()) / 40);
        QVERIFY(inTime(clock.elapsed(), 40 * 33ms));
        history->waitForDisk();
        const auto folders = QDir(resultFolder()).entryList(QDir::Dirs | QDir::NoDotAndDotDot);
        QCOMPARE(folders.size(), 200);
    }

    void whatLeftTheMemoryIsReadBack() {
        ResultHistory history(resultFolder());
        QTRY_VERIFY(history.ready());
        const auto first = smallResult(m_exemplar, 1);
        const std::string key = history.add(first, false, plain(Qt::red));
        history.add(smallResult(m_exemplar, 2), false, plain(Qt::green));
        history.setMemoryBudget(first->synthesis.image.size().area() * 3 * 4 + 4096);
        QTRY_VERIFY(history.store().memoryUsed() <= history.store().memoryBudget());
        std::shared_ptr<const Result> back;
        history.want(
            key, [&](const auto& result) { back = result; },
            [](const QString& why) { QFAIL(qPrintable(why)); });
        QVERIFY(!back);
        QTRY_VERIFY(back);
        QVERIFY(back != first);
        QVERIFY(samePixels(back->synthesis.image, first->synthesis.image));
    }

    void damagedResultsAreLeftOutAndNoted() {
        std::string key;
        {
            ResultHistory history(resultFolder());
            key = history.add(smallResult(m_exemplar, 1), false, plain(Qt::red));
            history.add(smallResult(m_exemplar, 2), false, plain(Qt::red));
        }
        QFile entry(QStringLiteral("%1/%2/entry.json").arg(resultFolder(), QString::fromStdString(key)));
        QVERIFY(entry.open(QIODevice::WriteOnly));
        entry.write("{");
        entry.close();
        MainWindow window;
        QTRY_COMPARE(window.desk()->history()->rowCount(), 1);
        QTRY_VERIFY(window.log()->text().contains(QString::fromStdString(key)));
    }

    void oldestUnpinnedOnesMakeRoomOnTheDisk() {
        ResultHistory history(resultFolder());
        QTRY_VERIFY(history.ready());
        const auto result = smallResult(m_exemplar, 1);
        std::vector<std::string> keys;
        for (int i = 0; i < 4; ++i)
            keys.push_back(history.add(result, false, plain(Qt::red)));
        history.setPinned(keys[0], true);
        history.waitForDisk();
        QCoreApplication::processEvents();
        history.setDiskBudget(history.store().diskUsed() * 3 / 4 - 1);
        QVERIFY(history.find(keys[0]) && !history.find(keys[1]) && history.find(keys[3]));
        history.waitForDisk();
        QVERIFY(!QDir(QStringLiteral("%1/%2").arg(resultFolder(), QString::fromStdString(keys[1]))).exists());
    }

    void deletedResultsComeBackWithUndo() {
        MainWindow window;
        window.show();
        QVERIFY(openAndFinish(window, m_exemplar));
        ResultHistory* const history = window.desk()->history();
        const std::string key = history->entries().back().key;
        auto* list = child<QListView>(window, "resultList");
        QVERIFY(QTest::qWaitForWindowActive(&window));
        ImageViewer* const viewer = window.results()->viewer(ResultView::ResultTab);
        viewer->setFocus();
        QTest::keyClick(viewer, Qt::Key_P);
        QVERIFY2(history->find(key)->pinned, "what is shown is chosen");
        QTest::keyClick(viewer, Qt::Key_Delete);
        QCOMPARE(history->rowCount(), 1);
        list->setFocus();
        QTest::keyClick(viewer, Qt::Key_P); // a pinned one would ask first
        QTest::keyClick(list, Qt::Key_Delete);
        QCOMPARE(history->rowCount(), 0);
        QVERIFY(window.messages()->text().contains(QStringLiteral("was deleted")));
        child<QPushButton>(window, "messageAction")->click();
        QCOMPARE(history->rowCount(), 1);
        QVERIFY(!history->find(key)->pinned);
        std::shared_ptr<const Result> back;
        history->want(
            key, [&](const auto& result) { back = result; },
            [](const QString& why) { QFAIL(qPrintable(why)); });
        QTRY_VERIFY(back);
    }

    void aClickShowsAResultAndNamesIt() {
        MainWindow window;
        window.resize(1400, 900);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        ResultHistory* const history = window.desk()->history();
        QTRY_VERIFY(history->ready());
        const std::string first = history->add(smallResult(m_exemplar, 31), false, plain(Qt::red));
        const std::string second = history->add(smallResult(m_exemplar, 32), false, plain(Qt::blue));
        auto* list = child<QListView>(window, "resultList");
        const auto click = [&](int row, Qt::KeyboardModifiers keys = {}) {
            settle();
            const QPoint centre = list->visualRect(list->model()->index(row, 0)).center();
            QTest::mouseClick(list->viewport(), Qt::LeftButton, keys, centre);
        };
        const auto shown = [&](const std::string& key) {
            return history->indexOf(key).data(ResultHistory::ShownRole).toBool();
        };
        click(1);
        QTRY_COMPARE(window.desk()->last().key, first);
        QVERIFY(window.desk()->resultShown() && shown(first) && !shown(second));
        QVERIFY(history->indexOf(first)
                    .data(Qt::AccessibleTextRole)
                    .toString()
                    .endsWith(QStringLiteral("shown")));
        click(0);
        QTRY_COMPARE(window.desk()->last().key, second);
        QVERIFY(!shown(first) && shown(second));
        const auto* remove = child<QAction>(window, "removeResult");
        QVERIFY(remove->text().contains(history->indexOf(second).data().toString()));
        QCOMPARE(remove->iconText(), QStringLiteral("Delete"));

        click(1, Qt::ControlModifier);
        QTest::qWait(50);
        QVERIFY2(shown(second), "while several are being chosen, none of them is shown");
        QVERIFY(remove->text().contains(QLatin1Char('2')));

        window.results()->setTab(ResultView::SynthesisTab);
        click(1);
        QTRY_COMPARE(window.desk()->last().key, first);
        QVERIFY(window.results()->viewer(ResultView::ResultTab)->isVisible());
        trigger(window, "renameResult");
        auto* editor = list->viewport()->findChild<QLineEdit*>();
        QVERIFY(editor != nullptr);
        QTest::keyClicks(editor, QStringLiteral("red"));
        QTest::keyClick(editor, Qt::Key_Return);
        QTRY_COMPARE(QString::fromStdString(history->find(first)->title), QStringLiteral("red"));
    }

    void undoBringsDeletedResultsBackInTheirTurn() {
        MainWindow window;
        window.show();
        ResultHistory* const history = window.desk()->history();
        QTRY_VERIFY(history->ready());
        std::vector<std::string> keys;
        for (int i = 0; i < 3; ++i)
            keys.push_back(history->add(smallResult(m_exemplar, 41), false, plain(Qt::red)));
        history->waitForDisk();
        const auto folder = [&](const std::string& key) {
            return QDir(QStringLiteral("%1/%2").arg(resultFolder(), QString::fromStdString(key)));
        };
        auto* undo = child<QAction>(window, "undo");
        auto* redo = child<QAction>(window, "redo");
        auto* remove = child<QAction>(window, "removeResult");
        window.resultPanel()->select({keys[0]});
        remove->trigger();
        window.inspector()->output()->setSeed(77);
        window.resultPanel()->select({keys[1], keys[2]});
        remove->trigger();
        QCOMPARE(history->rowCount(), 0);
        QVERIFY(undo->text().contains(QStringLiteral("Delete results")));
        undo->trigger();
        QCOMPARE(history->rowCount(), 2);
        QVERIFY2(window.messages()->text().isEmpty(), "what was undone is no longer offered to be");
        undo->trigger();
        QVERIFY(window.inspector()->output()->seed() != 77U);
        undo->trigger();
        QCOMPARE(history->rowCount(), 3);
        redo->trigger();
        QCOMPARE(history->rowCount(), 2);
        history->waitForDisk();
        QVERIFY2(folder(keys[0]).exists(), "it can still come back");
        window.undoHistory()->clear();
        history->waitForDisk();
        QVERIFY2(!folder(keys[0]).exists() && folder(keys[1]).exists(), "now it cannot");
    }

    void searchAndRenameByKeyboard() {
        MainWindow window;
        window.show();
        QVERIFY(QTest::qWaitForWindowActive(&window));
        ResultHistory* const history = window.desk()->history();
        QTRY_VERIFY(history->ready());
        history->add(smallResult(m_exemplar, 11), false, plain(Qt::red));
        history->add(smallResult(m_exemplar, 22), false, plain(Qt::blue));
        auto* list = child<QListView>(window, "resultList");
        auto* search = child<QLineEdit>(window, "resultSearch");
        search->setText(QStringLiteral("seed 11"));
        QCOMPARE(list->model()->rowCount(), 1);
        list->setFocus();
        list->setCurrentIndex(list->model()->index(0, 0));
        QTest::keyClick(list, Qt::Key_F2);
        auto* editor = list->viewport()->findChild<QLineEdit*>();
        QVERIFY(editor != nullptr);
        QTest::keyClicks(editor, QStringLiteral("seed 11, the good one"));
        QTest::keyClick(editor, Qt::Key_Return);
        QTRY_COMPARE(QString::fromStdString(history->entries().front().title),
                     QStringLiteral("seed 11, the good one"));
        search->setText(QStringLiteral("nothing like this"));
        QCOMPARE(list->model()->rowCount(), 0);
        QVERIFY(!list->isVisible());
    }

    void settingsComeBackFromAResult() {
        MainWindow window;
        window.show();
        QVERIFY(openAndFinish(window, m_exemplar));
        Inspector* const inspector = window.inspector();
        inspector->setValues({{"patch", 20}});
        inspector->output()->setSeed(7);
        inspector->output()->setOutputSize({70, 60});
        QSignalSpy finished(window.desk()->controller(), &RunController::finished);
        window.startRun(false);
        QVERIFY(finished.wait(kPatience));
        const ResultHistory* const history = window.desk()->history();
        const std::string full = history->entries().back().key;
        const std::string quick = history->entries().front().key;
        inspector->setValues({{"patch", 30}});
        inspector->output()->setSeed(8);
        inspector->output()->setOutputSize({90, 90});
        window.restoreResult(full);
        QCOMPARE(std::get<int>(inspector->values().at("patch")), 20);
        QCOMPARE(inspector->output()->seed(), 7U);
        QVERIFY((inspector->output()->outputSize() == Size{70, 60}));
        inspector->output()->setOutputSize({90, 90});
        window.restoreResult(quick);
        QVERIFY2((inspector->output()->outputSize() == Size{90, 90}), "a preview's size is not taken over");

        auto* list = child<QListView>(window, "resultList");
        list->selectAll();
        trigger(window, "resultDifference");
        auto* table = child<QTableWidget>(window, "differenceTable");
        QStringList rows;
        for (int row = 0; row < table->rowCount(); ++row)
            rows += table->item(row, 0)->text() + QLatin1Char(':') + table->item(row, 2)->text();
        QVERIFY2(rows.contains(QStringLiteral("Patch size:20 px")), qPrintable(rows.join(QLatin1Char('|'))));
        QVERIFY(rows.contains(QStringLiteral("Seed:7")));
    }

    void settingsOfAResultWhoseExemplarIsClosedReadItAgain() {
        MainWindow window;
        window.show();
        QTRY_VERIFY(window.desk()->history()->ready());
        const std::string key =
            window.desk()->history()->add(smallResult(m_exemplar, 5), false, plain(Qt::red));
        window.restoreResult(key);
        QTRY_COMPARE(window.store()->entries().size(), std::size_t{1});
        QTRY_COMPARE(window.inspector()->output()->seed(), 5U);
        QCOMPARE(window.inspector()->method()->id(), std::string("random-phase"));
    }

    void limitsAreStatedAndSettable() {
        MainWindow window;
        window.show();
        trigger(window, "resultLimits");
        auto* dialog = child<LimitsDialog>(window, "limitsDialog");
        child<QDoubleSpinBox>(*dialog, "memoryLimit")->setValue(0.5);
        dialog->accept();
        QCOMPARE(window.desk()->history()->store().memoryBudget(), std::uint64_t{512} << 20);
        QSettings().remove(QStringLiteral("results/memory"));
    }

private:
    QTemporaryDir m_folder;
    QString m_exemplar;
};

TEXLOOM_UI_TESTS(ResultsTest)
#include "results_test.moc"
