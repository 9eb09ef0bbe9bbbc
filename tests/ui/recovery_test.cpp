#include "core/session/session.h"
#include "tests/ui/window_fixture.h"
#include "ui/common/message_bar.h"
#include "ui/common/text.h"
#include "ui/inspector/inspector.h"
#include "ui/inspector/output_group.h"
#include "ui/session/document.h"
#include "ui/session/missing_files_dialog.h"
#include "ui/session/recovery_dialog.h"

#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QListWidget>
#include <QLockFile>
#include <QMessageBox>
#include <QProcess>
#include <QPushButton>
#include <QTimer>

#include <sys/resource.h>

#include <csignal>

using namespace texloom;
using namespace texloom::ui;

/// That nothing is lost: saves, questions before closing, recovery after a crash, in the real window.
class RecoveryTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() {
        m_folder = std::make_unique<QTemporaryDir>();
        m_window = std::make_unique<MainWindow>();
        m_window->document()->recovery()->setFolder(m_folder->filePath(QStringLiteral("recovery")));
        m_window->show();
    }
    void cleanup() { m_window.reset(); }

    void noRoomForRecoveryIsSaidOnce() {
        QFile blocked(m_folder->filePath(QStringLiteral("blocked")));
        QVERIFY(blocked.open(QIODevice::WriteOnly)); // a file where the folder should be
        m_window->document()->recovery()->setFolder(blocked.fileName());
        m_window->document()->recovery()->setDelay(std::chrono::milliseconds(10));
        m_window->inspector()->output()->setSeed(5);
        QTRY_VERIFY(m_window->messages()->text().contains(QStringLiteral("make room")));
        QVERIFY(m_window->messages()->text().contains(QStringLiteral("crash would lose it")));
    }

    void aFullDiskLeavesTheFormerCopyAndSaysSo() {
        Document* const document = m_window->document();
        document->recovery()->setDelay(std::chrono::milliseconds(10));
        m_window->inspector()->output()->setSeed(5);
        QTRY_VERIFY(!document->recovery()->file().isEmpty() && QFile::exists(document->recovery()->file()));
        const auto kept = [&] { return readSession(toPath(document->recovery()->file())).settings.seed; };
        QTRY_COMPARE(kept(), 5U);
        const auto former = std::signal(SIGXFSZ, SIG_IGN);
        rlimit limit{};
        QCOMPARE(getrlimit(RLIMIT_FSIZE, &limit), 0);
        const rlimit tight{64, limit.rlim_max};
        QCOMPARE(setrlimit(RLIMIT_FSIZE, &tight), 0);
        m_window->inspector()->output()->setSeed(6);
        QTRY_VERIFY(m_window->messages()->text().contains(QStringLiteral("make room")));
        QCOMPARE(kept(), 5U);
        QCOMPARE(setrlimit(RLIMIT_FSIZE, &limit), 0);
        std::signal(SIGXFSZ, former);
        QTRY_COMPARE(kept(), 6U); // as soon as there is room again
    }

    void whatWasMadeByHandIsNotClosedWithoutAsking() {
        openBark();
        m_window->inspector()->output()->setSeed(9);
        QVERIFY(m_window->document()->mayClose()); // its settings are with its result
        m_window->store()->setEdits(m_window->store()->current()->id, {{{"rotate", 90.0}}}, {});
        QTRY_VERIFY((current() == Size{48, 64}));
        QString asked;
        const auto answer = [&](QMessageBox::StandardButton button) {
            QTimer::singleShot(0, this, [&asked, button] {
                auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
                asked = box->text();
                box->button(button)->click();
            });
        };
        answer(QMessageBox::Cancel);
        QVERIFY(!m_window->document()->mayClose());
        QVERIFY2(asked.contains(QStringLiteral("Results are kept")), qPrintable(asked));
        answer(QMessageBox::Discard);
        QVERIFY(m_window->document()->mayClose());
    }

    void aSaveThatFailsIsKnownBeforeTheWindowCloses() {
        openBark();
        m_window->store()->setEdits(m_window->store()->current()->id, {{{"rotate", 90.0}}}, {});
        QTRY_VERIFY((current() == Size{48, 64}));
        m_window->document()->saveTo(m_folder->filePath(QStringLiteral("gone/work.texloom")), false);
        bool asked = false;
        QTimer::singleShot(0, this, [&asked] {
            if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
                asked = true;
                box->button(QMessageBox::Cancel)->click();
            }
        });
        QVERIFY(!m_window->document()->mayClose());
        QVERIFY(asked);
    }

    void whatIsSavedLastIsWhatIsKept() {
        const QString file = m_folder->filePath(QStringLiteral("work.texloom"));
        for (int seed = 1; seed <= 20; ++seed) {
            m_window->inspector()->output()->setSeed(static_cast<quint64>(seed));
            m_window->document()->saveTo(file, seed % 2 == 0);
        }
        QVERIFY(m_window->document()->mayClose());
        QCOMPARE(readSession(toPath(file)).settings.seed, 20U);
    }

    void aRecoveryThatIsCalledOffIsOfferedAgain() {
        const QString folder = m_folder->filePath(QStringLiteral("recovery"));
        QVERIFY(QDir().mkpath(folder));
        Session session = m_window->session();
        session.settings.exemplars = {
            {{toPath(m_folder->filePath(QStringLiteral("gone.png"))), "srgb", "", ""}, {}, {}}};
        session.used = {true};
        const QString copy = folder + QStringLiteral("/lost.texloom");
        writeSession(toPath(copy), session);
        m_window->document()->offerRecovery();
        child<QPushButton>(*child<RecoveryDialog>(*m_window, "recoveryDialog"), "recover")->click();
        QTRY_VERIFY(m_window->findChild<MissingFilesDialog*>() != nullptr);
        m_window->findChild<MissingFilesDialog*>()->reject();
        m_window.reset();
        QVERIFY(QFile::exists(copy));
    }

    void allThatCrashesLeftIsOfferedAndSweptWhenRefused() {
        const QString folder = m_folder->filePath(QStringLiteral("recovery"));
        QVERIFY(QDir().mkpath(folder));
        const QDateTime now = QDateTime::currentDateTime();
        for (int age = 0; age < 4; ++age) {
            Session session = m_window->session();
            session.settings.exemplars = {
                {{toPath(m_folder->filePath(QStringLiteral("bark%1.png").arg(age))), "srgb", "", ""},
                 {},
                 {}}};
            session.used = {true};
            const QString copy = folder + QStringLiteral("/lost%1.texloom").arg(age);
            writeSession(toPath(copy), session);
            QFile file(copy);
            QVERIFY(file.open(QIODevice::ReadWrite));
            QVERIFY(file.setFileTime(now.addDays(-age), QFileDevice::FileModificationTime));
        }
        QLockFile alive(folder + QStringLiteral("/lost3.texloom.lock")); // a window that is still there
        QVERIFY(alive.tryLock());
        m_window->document()->offerRecovery();
        auto* dialog = child<RecoveryDialog>(*m_window, "recoveryDialog");
        auto* list = child<QListWidget>(*dialog, "lostSessions");
        QCOMPARE(list->count(), 3);
        for (int row = 0; row < 3; ++row)
            QTRY_VERIFY2(list->item(row)->text().endsWith(QStringLiteral("bark%1.png").arg(row)),
                         qPrintable(list->item(row)->text()));
        list->selectAll();
        QVERIFY(!child<QPushButton>(*dialog, "recover")->isEnabled());
        list->setCurrentRow(1, QItemSelectionModel::ClearAndSelect);
        child<QPushButton>(*dialog, "throwAway")->click();
        QCOMPARE(list->count(), 2);
        QVERIFY(!QFile::exists(folder + QStringLiteral("/lost1.texloom")));
        list->selectAll();
        child<QPushButton>(*dialog, "throwAway")->click();
        QVERIFY(!dialog->isVisible());
        QCOMPARE(QDir(folder).entryList(QDir::Files),
                 QStringList({QStringLiteral("lost3.texloom"), QStringLiteral("lost3.texloom.lock")}));
    }

    void anOrderlyEndLeavesNothingToRecover() {
        m_window->document()->recovery()->setDelay(std::chrono::milliseconds(10));
        m_window->inspector()->output()->setSeed(5);
        QTRY_VERIFY(!m_window->document()->recovery()->file().isEmpty() &&
                    QFile::exists(m_window->document()->recovery()->file()));
        m_window.reset();
        QVERIFY(QDir(m_folder->filePath(QStringLiteral("recovery"))).isEmpty());
    }

    void aKilledProgramIsRecovered() {
        const QString bark = writeTexture(*m_folder, QStringLiteral("bark.png"), {64, 48});
        QProcess program;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QStringLiteral("XDG_DATA_HOME"), m_folder->filePath(QStringLiteral("data")));
        environment.insert(QStringLiteral("XDG_CONFIG_HOME"), m_folder->filePath(QStringLiteral("config")));
        environment.insert(QStringLiteral("TEXLOOM_RECOVERY_SECONDS"), QStringLiteral("1"));
        program.setProcessEnvironment(environment);
        program.start(QStringLiteral(TEXLOOM_GUI), {bark});
        QVERIFY(program.waitForStarted());
        const QDir kept(m_folder->filePath(QStringLiteral("data/Texloom/texloom/recovery")));
        QTRY_VERIFY_WITH_TIMEOUT(!kept.entryList({QStringLiteral("*.texloom")}, QDir::Files).isEmpty(),
                                 30'000);
        program.kill();
        QVERIFY(program.waitForFinished());
        QCOMPARE(program.exitStatus(), QProcess::CrashExit);

        m_window->document()->recovery()->setFolder(kept.path());
        m_window->document()->offerRecovery();
        auto* box = m_window->findChild<RecoveryDialog*>(QStringLiteral("recoveryDialog"));
        QVERIFY(box != nullptr);
        child<QPushButton>(*box, "recover")->click();
        QTRY_COMPARE(m_window->store()->entries().size(), 1U);
        QCOMPARE(toQString(m_window->store()->current()->file().path), bark);
        QVERIFY(m_window->document()->modified());
        QVERIFY(QFile::exists(m_window->document()->recovery()->file()));
    }

private:
    /// A picture of 64 × 48 px; its first quick run has ended.
    void openBark() {
        QVERIFY(openAndFinish(*m_window, writeTexture(*m_folder, QStringLiteral("bark.png"), {64, 48})));
    }
    Size current() const { return m_window->store()->current()->file().image->size(); }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<MainWindow> m_window;
};

TEXLOOM_UI_TESTS(RecoveryTest)
#include "recovery_test.moc"
