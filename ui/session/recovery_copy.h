#pragma once

#include "core/session/session.h"

#include <QObject>
#include <QString>
#include <QTimer>

#include <chrono>
#include <functional>
#include <memory>
#include <optional>

class QLockFile;
class QThreadPool;
class QWidget;

namespace texloom::ui {

/// The copy of a session that outlives a crash: a file of its own, written in the background soon after every
/// change, locked as long as this program lives, and gone once nothing could be lost.
class RecoveryCopy : public QObject {
    Q_OBJECT

public:
    /// What is to be kept as it stands; none if nothing is.
    using Read = std::function<std::optional<Session>()>;

    /// @param writer of one thread, on which it is written.
    RecoveryCopy(Read read, QThreadPool* writer, QObject* parent);

    /// Where copies are. @param folder made when needed.
    void setFolder(const QString& folder);
    const QString& folder() const { return m_folder; }
    /// The copy's path; empty while there is none.
    const QString& file() const { return m_file; }
    void setDelay(std::chrono::milliseconds delay) { m_timer.setInterval(delay); }

    /// Writes the copy in a while.
    void writeSoon();
    /// Leaves the copy as it is from now on.
    void pause() { m_timer.stop(); }
    /// Removes the copy.
    void drop();
    /// Goes on with the copy of a session that was recovered.
    void takeOver(const QString& path);
    /// Looks for copies whose program ended without removing them, and offers them all; those that are
    /// refused are removed.
    void offer(QWidget* parent);

Q_SIGNALS:
    /// The session in this file is to be opened.
    void recoverWanted(const QString& path);
    /// The copy could not be written; told once until that succeeds again.
    void failed(const QString& sentence);

private:
    void write();

    Read m_read;
    QThreadPool* m_writer;
    QTimer m_timer;
    QString m_folder;
    QString m_file;
    std::unique_ptr<QLockFile> m_lock;
    bool m_writing = false;
    bool m_failed = false;
};

} // namespace texloom::ui
