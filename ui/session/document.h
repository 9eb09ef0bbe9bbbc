#pragma once

#include "ui/exemplar/exemplar_store.h"
#include "ui/session/recovery_copy.h"
#include "ui/session/settings_state.h"

#include <QObject>
#include <QThreadPool>

#include <functional>
#include <optional>

class QAction;
class QMenu;
class QWidget;

namespace texloom::ui {

/// A session with the images of its exemplars, loaded.
struct LoadedSession {
    Session session;
    std::vector<RunExemplar> exemplars; ///< one for each of the session's
    InputFiles inputs;
    QStringList changed; ///< names of files that are not those the session knew
    QStringList leftOut; ///< sentences about files that could not be read
};

/// The session on which the window works, as a file: new, open, save, the recent ones, and a copy for
/// recovery that is written in the background soon after every change and outlives a crash.
class Document : public QObject {
    Q_OBJECT

public:
    /// What a document needs of its window.
    struct Window {
        QWidget* widget;
        std::function<Session()> read; ///< as it stands; cheap
        /// Shows it in place of all that is open, and calls `shown` when that is done.
        std::function<void(const LoadedSession&, std::function<void()> shown)> show;
        /// Closes all that is open, as when the window first opens, and calls `shown` when that is done.
        std::function<void(std::function<void()> shown)> startAfresh;
        std::function<void(const QString&)> tell, refuse; ///< says a sentence in place
        /// Whether there is something made by hand that only a session keeps, such as edits or a painted
        /// mask.
        std::function<bool()> handmade;
    };

    Document(Window window, QObject* parent);
    ~Document() override;

    /// New, open, recent, save and so on, in order.
    void addTo(QMenu* menu);
    /// To be called whenever anything changed that a session keeps.
    void touch();
    bool modified() const { return m_modified; }
    /// Takes what is there now as nothing that could be lost: the window as it first opens.
    void settle();
    /// The session's file; empty before it was first saved.
    const QString& file() const { return m_file; }
    void open(const QString& path);
    /// Opens one that comes with Texloom, as a session that has no file yet.
    void openExample(const QString& path);
    /// @param packed with copies of all images beside it.
    void saveTo(const QString& path, bool packed);
    /// Whether the window may close: asks where changes of a saved session, or what was made by hand in one
    /// that was never saved, would be lost. Results and their settings are kept in any case.
    bool mayClose();
    /// Looks for sessions whose program ended without closing them, and offers them all.
    void offerRecovery();

    /// The copy that would be left by a crash.
    RecoveryCopy* recovery() const { return m_recovery; }

    /// Whether a path names a session.
    static bool isSession(const QString& path);

Q_SIGNALS:
    /// The file or whether it is modified changed; for the window's title.
    void titleChanged();

private:
    QAction* add(QMenu* menu, const char* name, const QString& text, const QKeySequence& key,
                 void (Document::*)());
    void startNew();
    void chooseAndOpen();
    void save();
    void saveAs();
    void savePacked();
    QString askForFile(const QString& title);
    void fillRecent(QMenu* menu) const;
    /// @param file that it is saved to from now on; empty for none.
    void read(const QString& path, const QString& file);
    /// The steps of opening a session. @param copy the file it is recovered from, which stays for another
    /// time if it is not opened; empty if it is opened from `file`.
    void resolve(const Session& session, const QString& file, const QString& copy);
    void askForMissing(const Session& session, const QStringList& missing, const QString& file,
                       const QString& copy);
    void load(const Session& session, const QString& file, const QString& copy);
    void opened(const LoadedSession& loaded, const QString& file, const QString& copy);
    void setFile(const QString& path);
    void setModified(bool modified);
    void finishSaving();
    bool askToSave();
    bool saveNow(const QString& path);
    std::optional<Session> unsaved() const;
    void recover(const QString& path);

    Window m_window;
    QString m_file;
    bool m_modified = false;
    bool m_loading = false;
    bool m_closing = false;
    QThreadPool m_writer; ///< one thread: what is saved later is written later
    int m_saving = 0;
    RecoveryCopy* m_recovery;
};

} // namespace texloom::ui
