// The window as people use it from end to end, and what holds for all of it: room for every text, a way by
// keys to everything, nothing lost where the program is killed.

#include "core/session/run/exemplar_file.h"
#include "tests/ui/window_fixture.h"
#include "ui/common/background.h"
#include "ui/common/language.h"
#include "ui/common/shortcuts.h"
#include "ui/common/text.h"
#include "ui/compare/compare_view.h"
#include "ui/compare/contact_sheet.h"
#include "ui/exemplar/exemplar_editor.h"
#include "ui/exemplar/exemplar_panel.h"
#include "ui/export/export_dialog.h"
#include "ui/inspector/inspector.h"
#include "ui/inspector/output_group.h"
#include "ui/inspector/param_row.h"
#include "ui/jobs/run_panel.h"
#include "ui/maps/result_view.h"
#include "ui/plots/figures_panel.h"
#include "ui/session/document.h"
#include "ui/session/recovery_dialog.h"
#include "ui/viewers/viewer_keys.h"
#include "ui/window/start_page.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QDropEvent>
#include <QKeyEvent>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMimeData>
#include <QProcess>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTextStream>
#include <QUrl>

#include <set>

using namespace texloom;
using namespace texloom::ui;

namespace {

/// Names the folder for what the program to be killed leaves behind.
const char* const kVictimFolder = "TEXLOOM_TEST_VICTIM";

void dropOn(QWidget& window, const QString& file) {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(file)});
    QDragEnterEvent enter(QPoint(9, 9), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&window, &enter);
    QDropEvent drop(QPoint(9, 9), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&window, &drop);
}

bool idle(const MainWindow& window) {
    const JobQueue* const queue = window.desk()->queue();
    return queue->current() == nullptr && queue->waiting() == 0;
}

/// Key of the first result of a comparison that this method made.
std::string resultOf(const MainWindow& window, const char* method) {
    for (const CompareItem& item : window.compare()->items())
        if (const ResultEntry* entry = window.desk()->history()->find(item.key);
            entry != nullptr && entry->recipe.steps.front().method == method)
            return item.key;
    return {};
}

/// Works in a window until a long run is under way, says so, and waits to be killed.
int beVictim(const QString& folder) {
    QSettings().setValue(QStringLiteral("results/folder"), folder + QStringLiteral("/results"));
    MainWindow window;
    window.document()->recovery()->setFolder(folder + QStringLiteral("/recovery"));
    window.document()->recovery()->setDelay(std::chrono::milliseconds(50));
    window.show();
    if (!openAndFinish(window, folder + QStringLiteral("/bark.png")))
        return 1;
    window.desk()->history()->waitForDisk();
    window.store()->setEdits(window.store()->current()->id, {{{"rotate", 90.0}}}, {});
    window.inspector()->setValues({{"patch", 16}});
    window.inspector()->output()->setOutputSize({4096, 4000});
    QSignalSpy previewed(window.desk()->controller(), &RunController::previewed);
    window.startRun(false);
    if (!previewed.wait(kPatience))
        return 1;
    QTextStream(stdout) << "running" << Qt::endl;
    QTest::qWait(kPatience);
    return 1;
}

} // namespace

class FlowsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void firstMinute() {
        MainWindow window;
        window.resize(1280, 900);
        window.show();
        QVERIFY(QTest::qWaitForWindowActive(&window));
        QVERIFY(window.findChild<StartPage*>()->isVisible());
        QSignalSpy finished(window.desk()->controller(), &RunController::finished);
        dropOn(window, writeTexture(m_folder, QStringLiteral("bark.jpg"), {64, 56}));
        QVERIFY(finished.wait(kPatience)); // a quick preview by itself
        ImageViewer* const viewer = window.results()->viewer(ResultView::ResultTab);
        QTRY_VERIFY(viewer->isVisible() && viewer->picture());
        QTest::keyClick(viewer, Qt::Key_W);
        QVERIFY(viewer->repeats());

        window.inspector()->output()->setOutputSize({72, 64});
        trigger(window, "tryAll");
        CompareView* const compare = window.compare();
        QTRY_COMPARE(compare->items().size(), triedMethods() + 1);
        QTRY_VERIFY_WITH_TIMEOUT(!compare->items()[1].key.empty(), kPatience); // the quickest comes first
        window.desk()->queue()->clear();
        QTRY_VERIFY_WITH_TIMEOUT(idle(window), kPatience);
        const ResultEntry* const taken = window.desk()->history()->find(compare->items()[1].key);
        QTest::keyClick(compare->viewer(1), Qt::Key_Return);
        QCOMPARE(window.inspector()->method()->id(), taken->recipe.steps.front().method);

        finished.clear();
        QTRY_VERIFY(child<QAction>(window, "run")->isEnabled());
        QTest::keyClick(&window, Qt::Key_Return, Qt::ControlModifier);
        QVERIFY(finished.wait(kPatience));
        QTRY_VERIFY(child<QAction>(window, "export")->isEnabled());
        QTest::keyClick(&window, Qt::Key_E, Qt::ControlModifier);
        auto* dialog = child<ExportDialog>(window, "exportDialog");
        child<QLineEdit>(*dialog, "exportFolder")->setText(m_folder.path());
        child<QPushButton>(*dialog, "exportWrite")->click();
        const QString name = QStringLiteral("bark_%1_s1_72x64")
                                 .arg(QString::fromStdString(window.inspector()->method()->id()));
        for (const char* ending : {".png", ".json"})
            QTRY_VERIFY2(QFile::exists(m_folder.filePath(name + QLatin1String(ending))), qPrintable(name));
    }

    void expert() {
        MainWindow window;
        window.resize(1280, 900);
        window.show();
        QStringList files;
        for (const char* map : {"albedo", "normal", "rough", "height", "ao", "metallic"})
            files += writeTexture(m_folder, QStringLiteral("rock_%1.png").arg(QLatin1String(map)), {64, 64});
        QSignalSpy finished(window.desk()->controller(), &RunController::finished);
        window.openFiles(files);
        QVERIFY(finished.wait(kPatience));
        QCOMPARE(window.store()->entries().size(), 1U);
        QCOMPARE(window.store()->current()->exemplar.companions.size(), 5U);
        rectify(window);

        window.inspector()->output()->setOutputSize({96, 96});
        QVERIFY(child<QCheckBox>(window, "wrapX")->isChecked() &&
                child<QCheckBox>(window, "wrapY")->isChecked()); // as the window starts
        tryFour(window);
        const CompareView* const compare = window.compare();
        trigger(window, "repeat");
        for (int i = 0; i < 5; ++i)
            QVERIFY(compare->viewer(i)->repeats()); // the linked grid repeats as one
        const std::string winner = resultOf(window, "quilting");
        QVERIFY(!winner.empty());
        Q_EMIT window.compare()->useWanted(winner);
        QCOMPARE(window.inspector()->method()->id(), std::string("quilting"));
        sweep(window);

        finished.clear();
        window.startRun(false);
        QVERIFY(finished.wait(kPatience));
        child<QDockWidget>(window, "figureDock")->raise();
        QTRY_VERIFY_WITH_TIMEOUT(!child<FiguresPanel>(window, "figuresPanel")->titles().isEmpty(), kPatience);
        exportAll(window);
        reproduce();
    }

    void killedInTheMiddleOfARun() {
        const QTemporaryDir folder;
        writeTexture(folder, QStringLiteral("bark.png"), {64, 48});
        QProcess program;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QLatin1String(kVictimFolder), folder.path());
        program.setProcessEnvironment(environment);
        program.start(QCoreApplication::applicationFilePath(), {});
        QByteArray said;
        QTRY_VERIFY_WITH_TIMEOUT((said += program.readAllStandardOutput()).contains("running"), kPatience);
        const QDir kept(folder.filePath(QStringLiteral("recovery")));
        const auto size = [&] {
            const QFileInfoList found = kept.entryInfoList({QStringLiteral("*.texloom")}, QDir::Files);
            return found.isEmpty() ? Size{} : readSession(toPath(found.front().filePath())).settings.size;
        };
        QTRY_VERIFY((size() == Size{4096, 4000}));
        program.kill();
        QVERIFY(program.waitForFinished());
        QCOMPARE(program.exitStatus(), QProcess::CrashExit);

        const QVariant before = QSettings().value(QStringLiteral("results/folder"));
        QSettings().setValue(QStringLiteral("results/folder"), folder.filePath(QStringLiteral("results")));
        MainWindow window;
        QSettings().setValue(QStringLiteral("results/folder"), before);
        window.show();
        QTRY_VERIFY(window.desk()->history()->ready());
        QCOMPARE(window.desk()->history()->rowCount(), 1); // what had ended; not what was under way
        bool read = false;
        window.desk()->history()->want(
            window.desk()->history()->entries().front().key,
            [&](const std::shared_ptr<const Result>& result) { read = !result->synthesis.image.empty(); },
            [](const QString& why) { QFAIL(qPrintable(why)); });
        QTRY_VERIFY(read);
        window.document()->recovery()->setFolder(kept.path());
        window.document()->offerRecovery();
        auto* box = child<RecoveryDialog>(window, "recoveryDialog");
        child<QPushButton>(*box, "recover")->click();
        QTRY_COMPARE(window.store()->entries().size(), 1U);
        QVERIFY((window.store()->current()->exemplar.edits == ExemplarEdits{{{"rotate", 90.0}}}));
        QVERIFY((window.inspector()->output()->outputSize() == Size{4096, 4000}));
        QVERIFY(window.inspector()->rows().front()->value() == Value(16));
    }

    void everyTextHasRoomAndEveryControlAName_data() {
        QTest::addColumn<QString>("language");
        for (const char* language : {"C", "de_DE", "fr_FR"})
            QTest::newRow(language) << QString::fromLatin1(language);
    }

    void everyTextHasRoomAndEveryControlAName() {
        QFETCH(QString, language);
        useLanguage(QLocale(language));
        {
            MainWindow window;
            window.resize(1280, 900);
            window.show();
            QVERIFY(QTest::qWaitForWindowExposed(&window));
            check(window);
            QVERIFY(openAndFinish(window, writeTexture(m_folder, QStringLiteral("one.png"), {64, 64})));
            QSignalSpy opened(window.store(), &ExemplarStore::opened);
            window.openFiles({writeTexture(m_folder, QStringLiteral("two.png"), {64, 64}, 2)});
            QVERIFY(opened.wait());
            QTRY_VERIFY(child<QAction>(window, "run")->isEnabled());
            check(window);
            trigger(window, "editExemplar");
            for (const char* mode : {"crop", "rectify", "hide"}) {
                window.exemplarEditor()->setMode(QLatin1String(mode));
                check(window);
            }
            trigger(window, "editExemplar");
            for (const char* dock : {"jobDock", "logDock", "figureDock", "resultDock"}) {
                child<QDockWidget>(window, dock)->raise();
                check(window);
            }
            for (const char* name : {"export", "sweep", "trySome", "shortcuts", "about", "variance", "stress",
                                     "blend", "resultLimits"})
                checkDialogOf(window, name);
        }
        useLanguage(QLocale::c());
    }

    void keysAreChosenKeptAndGivenBack() {
        const QKeySequence other(QStringLiteral("Ctrl+Alt+W"));
        {
            MainWindow window;
            window.show();
            trigger(window, "shortcuts");
            auto* dialog = child<QDialog>(window, "shortcutsDialog");
            auto* table = child<QTableWidget>(*dialog, "shortcutsTable");
            auto* keys = child<QKeySequenceEdit>(*dialog, "shortcutKeys");
            table->setCurrentItem(table->findItems(QStringLiteral("W"), Qt::MatchExactly).front());
            keys->setKeySequence(QKeySequence(QStringLiteral("G")));
            child<QPushButton>(*dialog, "shortcutTake")->click();
            const QString said = child<QLabel>(*dialog, "shortcutSaid")->text();
            QVERIFY2(said.startsWith(QStringLiteral("G is taken")), qPrintable(said));
            keys->setKeySequence(other);
            child<QPushButton>(*dialog, "shortcutTake")->click();
            QCOMPARE(child<QAction>(window, "repeat")->shortcut(), other);
        }
        const QKeyEvent w(QEvent::KeyPress, Qt::Key_W, Qt::NoModifier);
        QVERIFY(!viewerCommandAt(w));
        MainWindow window;
        auto* repeat = child<QAction>(window, "repeat");
        QCOMPARE(repeat->shortcut(), other);
        QVERIFY2(repeat->toolTip().contains(QStringLiteral("Ctrl+Alt+W")), qPrintable(repeat->toolTip()));
        resetShortcut(repeat);
        QCOMPARE(repeat->shortcut(), QKeySequence(QStringLiteral("W")));
        QVERIFY(viewerCommandAt(w) == ViewerCommand::Repeat);
    }

    void everythingIsReachedByTab() {
        MainWindow window;
        window.resize(1280, 900);
        window.show();
        QVERIFY(QTest::qWaitForWindowActive(&window));
        QVERIFY(openAndFinish(window, writeTexture(m_folder, QStringLiteral("tab.png"), {64, 64})));
        QTRY_VERIFY(child<QAction>(window, "run")->isEnabled());
        auto* first = child<QListWidget>(window, "exemplarList");
        first->setFocus();
        std::vector<const QWidget*> way;
        do {
            way.push_back(QApplication::focusWidget());
            QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
        } while (QApplication::focusWidget() != first && way.size() < 400);
        QVERIFY2(way.size() < 400, "the way never comes back");
        const auto place = [&](const QWidget* widget) {
            return std::find(way.begin(), way.end(), widget) - way.begin();
        };
        for (const QWidget* widget : window.findChildren<QWidget*>()) {
            const bool wanted = (widget->focusPolicy() & Qt::TabFocus) != 0 && widget->isVisible() &&
                                widget->isEnabled() && widget->focusProxy() == nullptr;
            if (wanted)
                QVERIFY2(place(widget) < std::ssize(way),
                         qPrintable(QLatin1String(widget->metaObject()->className()) + QLatin1Char(' ') +
                                    widget->objectName()));
        }
        QVERIFY(place(child<QWidget>(window, "method")) < place(child<QWidget>(window, "runButton")));
        QVERIFY(place(child<QWidget>(window, "runButton")) <
                place(window.results()->viewer(ResultView::ResultTab)));
    }

private:
    static void rectify(MainWindow& window) {
        trigger(window, "editExemplar");
        window.exemplarEditor()->setMode(QStringLiteral("rectify"));
        child<QPushButton>(window, "apply-rectify")->click();
        QTRY_COMPARE(window.store()->current()->exemplar.edits.size(), 1U);
        child<QPushButton>(window, "editDone")->click();
    }

    static void tryFour(MainWindow& window) {
        trigger(window, "trySome");
        auto* dialog = child<QDialog>(window, "methodsDialog");
        auto* list = child<QListWidget>(*dialog, "triedMethods");
        const std::set<QString> ticked = {QStringLiteral("quilting"), QStringLiteral("patchmatch"),
                                          QStringLiteral("random-phase"), QStringLiteral("heeger-bergen")};
        for (int row = 0; row < list->count(); ++row)
            if (ticked.contains(list->item(row)->data(Qt::UserRole).toString()))
                list->item(row)->setCheckState(Qt::Checked);
        child<QCheckBox>(*dialog, "triedQuick")->setChecked(false);
        child<QPushButton>(*dialog, "triedStart")->click();
        const CompareView* const compare = window.compare();
        QTRY_COMPARE(compare->items().size(), 5U);
        QTRY_VERIFY_WITH_TIMEOUT(idle(window) && compare->pictures() == 5, kPatience);
    }

    static void sweep(MainWindow& window) {
        trigger(window, "sweep");
        auto* dialog = child<QDialog>(window, "sweepDialog");
        child<QLineEdit>(*dialog, "sweepAcrossValues")->setText(QStringLiteral("10, 16"));
        child<QPushButton>(*dialog, "sweepStart")->click();
        const CompareView* const compare = window.compare();
        QTRY_VERIFY_WITH_TIMEOUT(compare->items().size() == 2 && compare->pictures() == 2 && idle(window),
                                 kPatience);
        QVERIFY2(compare->heading().contains(QStringLiteral("rock")), qPrintable(compare->heading()));
        const QImage plain = contactSheet(compare->items(), QString(), 2, 64, QFont());
        const QImage sheet = contactSheet(compare->items(), compare->heading(), 2, 64, QFont());
        QVERIFY(sheet.height() > plain.height());
        QTRY_VERIFY(child<QAction>(window, "run")->isEnabled());
    }

    void exportAll(MainWindow& window) {
        trigger(window, "export");
        auto* dialog = child<ExportDialog>(window, "exportDialog");
        child<QLineEdit>(*dialog, "exportFolder")->setText(m_folder.path());
        auto* preset = child<QComboBox>(*dialog, "exportPreset");
        preset->setCurrentIndex(preset->findData(QStringLiteral("unreal")));
        child<QCheckBox>(*dialog, "exportStMap")->setChecked(true);
        auto* height = child<QComboBox>(*dialog, "depth-H");
        QCOMPARE(height->currentData().toInt(), static_cast<int>(Depth::Bits16)); // as the preset wants it
        auto* normals = child<QComboBox>(*dialog, "depth-N");
        normals->setCurrentIndex(normals->findData(static_cast<int>(Depth::Bits16)));
        Q_EMIT normals->activated(normals->currentIndex());
        child<QPushButton>(*dialog, "exportWrite")->click();
        for (const char* file : {"T_rock_BC.png", "T_rock_N.png", "T_rock_ORM.png", "T_rock_H.png",
                                 "T_rock_stmap.exr", "T_rock_BC.json"})
            QTRY_VERIFY2(QFile::exists(m_folder.filePath(QLatin1String(file))), file);
        for (const char* file : {"T_rock_N.png", "T_rock_H.png"})
            QCOMPARE(readImageInfo(toPath(m_folder.filePath(QLatin1String(file)))).depth,
                     std::string("16-bit"));
    }

    /// The command line makes the exported picture again from its recipe alone.
    void reproduce() {
        QProcess cli;
        const QString again = m_folder.filePath(QStringLiteral("again.png"));
        cli.start(QStringLiteral(TEXLOOM_CLI),
                  {QStringLiteral("run"), m_folder.filePath(QStringLiteral("T_rock_BC.json")),
                   QStringLiteral("-o"), again});
        QVERIFY(cli.waitForFinished());
        QVERIFY2(cli.exitCode() == 0, cli.readAllStandardError().constData());
        QVERIFY(samePixels(*loadExemplar(toPath(again)).image,
                           *loadExemplar(toPath(m_folder.filePath(QStringLiteral("T_rock_BC.png")))).image));
    }

    static void check(const QWidget& window) {
        settle();
        QVERIFY2(cutText(window).isEmpty(), qPrintable(cutText(window)));
        QVERIFY2(namelessControls(window).isEmpty(),
                 qPrintable(namelessControls(window).join(QStringLiteral(", "))));
    }

    static void checkDialogOf(MainWindow& window, const char* name) {
        trigger(window, name);
        settle();
        bool any = false;
        for (QWidget* dialog : QApplication::topLevelWidgets()) {
            if (dialog == &window || !dialog->isVisible() || dialog->windowType() == Qt::Popup)
                continue;
            any = true;
            check(*dialog);
            dialog->close();
        }
        QVERIFY2(any, name);
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }

    QTemporaryDir m_folder;
};

int main(int argc, char** argv) {
    return runTests(argc, argv, [](int count, char** values) {
        if (qEnvironmentVariableIsSet(kVictimFolder))
            return beVictim(qEnvironmentVariable(kVictimFolder));
        FlowsTest tests;
        return QTest::qExec(&tests, count, values);
    });
}

#include "flows_test.moc"
