#include "ui/session/recovery_copy.h"

#include "ui/common/background.h"
#include "ui/common/text.h"
#include "ui/session/recovery_dialog.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLockFile>
#include <QThreadPool>
#include <QUuid>

#include <utility>

namespace texloom::ui {

namespace {

const QString kRecoveryEnding = QStringLiteral(".texloom");
/// Well under the half minute that a crash may cost.
constexpr std::chrono::seconds kDelay{10};

QString lockOf(const QString& path) {
    return path + QStringLiteral(".lock");
}

} // namespace

RecoveryCopy::RecoveryCopy(Read read, QThreadPool* writer, QObject* parent)
    : QObject(parent), m_read(std::move(read)), m_writer(writer) {
    m_timer.setSingleShot(true);
    const int asked = qEnvironmentVariableIntValue("TEXLOOM_RECOVERY_SECONDS");
    m_timer.setInterval(asked > 0 ? std::chrono::seconds(asked) : kDelay);
    connect(&m_timer, &QTimer::timeout, this, &RecoveryCopy::write);
}

void RecoveryCopy::setFolder(const QString& folder) {
    drop();
    m_folder = folder;
}

void RecoveryCopy::writeSoon() {
    if (!m_timer.isActive())
        m_timer.start();
}

void RecoveryCopy::takeOver(const QString& path) {
    m_file = path;
    m_lock = std::make_unique<QLockFile>(lockOf(path));
    m_lock->setStaleLockTime(0); // as long as this process lives, however long that is
    m_lock->tryLock();
}

void RecoveryCopy::write() {
    if (m_writing)
        return;
    const std::optional<Session> session = m_read();
    if (!session)
        return;
    if (m_file.isEmpty()) {
        QDir().mkpath(m_folder);
        takeOver(m_folder + QLatin1Char('/') + QUuid::createUuid().toString(QUuid::WithoutBraces) +
                 kRecoveryEnding);
    }
    m_writing = true;
    inBackground(
        *m_writer, this,
        [path = toPath(m_file), session = *session] {
            writeSession(path, session);
            return true;
        },
        [this, path = m_file](bool) {
            m_writing = false;
            m_failed = false;
            if (path != m_file) // saved or closed in the meantime
                QFile::remove(path);
        },
        [this](const QString& why) {
            m_writing = false;
            if (!std::exchange(m_failed, true))
                Q_EMIT failed(tr("The session could not be kept for recovery, so a crash would lose it; make "
                                 "room or save it elsewhere. %1")
                                  .arg(why));
            m_timer.start();
        });
}

void RecoveryCopy::drop() {
    m_timer.stop();
    if (m_file.isEmpty())
        return;
    QFile::remove(m_file);
    m_file.clear();
    m_lock.reset();
}

void RecoveryCopy::offer(QWidget* parent) {
    const QFileInfoList found =
        QDir(m_folder).entryInfoList({QLatin1Char('*') + kRecoveryEnding}, QDir::Files, QDir::Time);
    QStringList copies;
    for (const QFileInfo& copy : found) {
        QLockFile lock(lockOf(copy.filePath()));
        lock.setStaleLockTime(0);
        if (lock.tryLock()) // else the program that writes it is still there
            copies += copy.filePath();
    }
    if (copies.isEmpty())
        return;
    auto* dialog = new RecoveryDialog(copies, parent);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &RecoveryDialog::recoverWanted, this, &RecoveryCopy::recoverWanted);
    connect(dialog, &RecoveryDialog::refused, this, [](const QString& copy) {
        QFile::remove(copy);
        QFile::remove(lockOf(copy));
    });
    dialog->open();
}

} // namespace texloom::ui
