#include "ui/session/document.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/session/run/edited_exemplar.h"
#include "ui/common/background.h"
#include "ui/common/readings.h"
#include "ui/common/save_guard.h"
#include "ui/common/text.h"
#include "ui/exemplar/files.h"
#include "ui/session/example_sessions.h"
#include "ui/session/missing_files_dialog.h"

#include <QAction>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QMessageBox>
#include <QSettings>
#include <QStandardPaths>

#include <utility>

namespace texloom::ui {

namespace {

const QString kEnding = QStringLiteral(".texloom");
const QString kRecents = QStringLiteral("recentSessions");
const QString kFolder = QStringLiteral("folders/session");
constexpr int kMostRecents = 12;

QString filter() {
    return Document::tr("Sessions (*.texloom)");
}

QStringList presentRecents() {
    QStringList present;
    for (const QString& path : QSettings().value(kRecents).toStringList())
        if (QFileInfo::exists(path))
            present += path;
    return present;
}

/// Loads all images; what cannot be read is left out, with a sentence.
LoadedSession loadAll(Session session) {
    LoadedSession loaded;
    for (const auto& path : checkFiles(session).changed)
        loaded.changed += toQString(path.filename());
    for (std::size_t i = 0; i < session.settings.exemplars.size();) {
        const RecipeExemplar entry = session.settings.exemplars[i];
        try {
            loaded.exemplars.push_back(edited(loadFiles(entry, session.settings.steps), entry.edits));
            ++i;
        } catch (const std::exception& error) {
            loaded.leftOut += sentence(error);
            leaveOut(session, i);
        }
    }
    try {
        loaded.inputs = loadInputs(session.settings.inputs, session.settings.steps, loaded.exemplars);
    } catch (const std::exception& error) {
        loaded.leftOut += sentence(error);
        session.settings.inputs.clear();
    }
    loaded.session = std::move(session);
    return loaded;
}

} // namespace

Document::Document(Window window, QObject* parent)
    : QObject(parent), m_window(std::move(window)),
      m_recovery(new RecoveryCopy([this] { return unsaved(); }, &m_writer, this)) {
    m_writer.setMaxThreadCount(1);
    m_recovery->setFolder(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) +
                          QStringLiteral("/recovery"));
    connect(m_recovery, &RecoveryCopy::recoverWanted, this, &Document::recover);
    connect(m_recovery, &RecoveryCopy::failed, this, m_window.refuse);
    FilesInUse::all().add(this, [this](OutputGuard& guard) {
        if (!m_file.isEmpty())
            guard.reads(toPath(m_file), TR("the session that is open"));
    });
}

Document::~Document() {
    // A window that is closed properly leaves nothing to recover, nor does a copy that is still being
    // written.
    m_writer.waitForDone();
    m_recovery->drop();
}

bool Document::isSession(const QString& path) {
    return path.endsWith(kEnding, Qt::CaseInsensitive);
}

QAction* Document::add(QMenu* menu, const char* name, const QString& text, const QKeySequence& key,
                       void (Document::*method)()) {
    auto* action = new QAction(text, m_window.widget);
    action->setObjectName(QLatin1String(name));
    action->setShortcut(key);
    m_window.widget->addAction(action);
    menu->addAction(action);
    connect(action, &QAction::triggered, this, method);
    return action;
}

void Document::addTo(QMenu* menu) {
    add(menu, "newSession", tr("&New session"), QKeySequence::New, &Document::startNew);
    add(menu, "openSession", tr("Open &session…"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_O),
        &Document::chooseAndOpen);
    QMenu* const recent = menu->addMenu(tr("Recent sess&ions"));
    recent->setToolTipsVisible(true);
    connect(recent, &QMenu::aboutToShow, this, [this, recent] { fillRecent(recent); });
    auto* const examples = new ExampleSessions(menu);
    menu->addMenu(examples);
    connect(examples, &ExampleSessions::chosen, this, &Document::openExample);
    add(menu, "saveSession", tr("S&ave session"), QKeySequence::Save, &Document::save);
    add(menu, "saveSessionAs", tr("Save session &as…"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S),
        &Document::saveAs);
    add(menu, "packSession", tr("Save session &with its images…"), {}, &Document::savePacked);
}

void Document::fillRecent(QMenu* menu) const {
    menu->clear();
    for (const QString& path : presentRecents()) {
        QAction* const action = menu->addAction(QFileInfo(path).completeBaseName());
        action->setToolTip(path);
        connect(action, &QAction::triggered, this, [this, path] { const_cast<Document*>(this)->open(path); });
    }
    if (menu->isEmpty())
        menu->addAction(tr("No session saved yet"))->setEnabled(false);
}

void Document::touch() {
    if (m_loading)
        return;
    setModified(true);
    m_recovery->writeSoon();
}

void Document::settle() {
    m_recovery->pause();
    setModified(false);
}

void Document::setModified(bool modified) {
    if (std::exchange(m_modified, modified) != modified)
        Q_EMIT titleChanged();
}

void Document::setFile(const QString& path) {
    m_file = path;
    if (!path.isEmpty()) {
        QStringList recents = QSettings().value(kRecents).toStringList();
        recents.removeAll(path);
        recents.prepend(path);
        QSettings().setValue(kRecents, recents.mid(0, kMostRecents));
    }
    Q_EMIT titleChanged();
}

void Document::startNew() {
    if (!askToSave())
        return;
    m_loading = true;
    m_window.startAfresh([this] {
        m_loading = false;
        m_recovery->drop();
        setFile({});
        setModified(false);
    });
}

void Document::chooseAndOpen() {
    const QString path = QFileDialog::getOpenFileName(m_window.widget, tr("Open session"),
                                                      QSettings().value(kFolder).toString(), filter());
    if (!path.isEmpty())
        open(path);
}

void Document::open(const QString& path) {
    if (!askToSave())
        return;
    const QString file = QFileInfo(path).absoluteFilePath();
    QSettings().setValue(kFolder, QFileInfo(file).path());
    read(file, file);
}

void Document::openExample(const QString& path) {
    if (askToSave())
        read(path, {});
}

void Document::read(const QString& path, const QString& file) {
    inBackground(
        this, [path = toPath(path)] { return readSession(path); },
        [this, file](const Session& session) { resolve(session, file, {}); },
        [this](const QString& why) { m_window.refuse(why); });
}

/// Finds out which files are gone before anything is loaded.
void Document::resolve(const Session& session, const QString& file, const QString& copy) {
    inBackground(
        this,
        [session] {
            QStringList missing;
            for (const auto& path : missingFiles(session))
                missing += toQString(path);
            return missing;
        },
        [this, session, file, copy](const QStringList& missing) {
            if (missing.isEmpty())
                load(session, file, copy);
            else
                askForMissing(session, missing, file, copy);
        },
        [this](const QString& why) { m_window.refuse(why); });
}

void Document::askForMissing(const Session& session, const QStringList& missing, const QString& file,
                             const QString& copy) {
    auto* dialog = new MissingFilesDialog(session, missing, m_window.widget);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this,
            [this, dialog, file, copy] { load(dialog->session(), file, copy); });
    dialog->open();
}

void Document::load(const Session& session, const QString& file, const QString& copy) {
    const QString name = file.isEmpty() ? tr("the session") : QFileInfo(file).fileName();
    readInBackground(
        this, name, [session] { return loadAll(session); },
        [this, file, copy](const LoadedSession& loaded) {
            m_loading = true;
            m_window.show(loaded, [this, loaded, file, copy] { opened(loaded, file, copy); });
        },
        [this](const QString& why) {
            if (!why.isEmpty())
                m_window.refuse(why);
        });
}

void Document::opened(const LoadedSession& loaded, const QString& file, const QString& copy) {
    m_loading = false;
    m_recovery->drop();
    if (!copy.isEmpty())
        m_recovery->takeOver(copy); // written again as work goes on
    setFile(file);
    setModified(!copy.isEmpty() || !loaded.leftOut.isEmpty());
    if (!loaded.leftOut.isEmpty())
        m_window.refuse(tr("Opened, but without some files: %1").arg(loaded.leftOut.join(QLatin1Char(' '))));
    else if (!loaded.changed.isEmpty())
        m_window.tell(tr("Opened, but these files changed since the session was saved, so results "
                         "will differ: %1.")
                          .arg(loaded.changed.join(QStringLiteral(", "))));
}

QString Document::askForFile(const QString& title) {
    const QString start = m_file.isEmpty() ? QSettings().value(kFolder).toString() : m_file;
    QString path = askWhereToSave(m_window.widget, title, start, filter(), {kEnding.mid(1), true});
    if (!path.isEmpty())
        QSettings().setValue(kFolder, QFileInfo(path).path());
    return path;
}

void Document::save() {
    if (m_file.isEmpty())
        saveAs();
    else
        saveTo(m_file, false);
}

void Document::saveAs() {
    if (const QString path = askForFile(tr("Save session")); !path.isEmpty())
        saveTo(path, false);
}

void Document::savePacked() {
    if (const QString path = askForFile(tr("Save session with its images")); !path.isEmpty())
        saveTo(path, true);
}

void Document::saveTo(const QString& path, bool packed) {
    // What was painted here has no place of its own: it is always kept with the session.
    const std::filesystem::path only = packed ? std::filesystem::path() : toPath(ownFolder());
    setModified(false);
    ++m_saving;
    inBackground(
        m_writer, this,
        [path = toPath(path), session = m_window.read(), only, guard = SaveGuard(this)] {
            guard.check(path, TR("session"));
            return packSession(path, session, only);
        },
        [this, path](const Session&) {
            --m_saving;
            setFile(path);
            if (!m_modified)
                m_recovery->drop();
            m_window.tell(tr("Saved %1.").arg(QFileInfo(path).fileName()));
        },
        [this](const QString& why) {
            --m_saving;
            touch();
            m_window.refuse(tr("The session was not saved. %1").arg(why));
        });
}

/// Waits for what is being saved: that it failed must be known before anything is given up.
void Document::finishSaving() {
    if (m_saving == 0)
        return;
    m_writer.waitForDone();
    QCoreApplication::sendPostedEvents(QCoreApplication::instance(), QEvent::MetaCall);
}

bool Document::askToSave() {
    finishSaving();
    const bool untitled = m_file.isEmpty();
    if (!m_modified || (untitled && !m_window.handmade()))
        return true;
    const auto answer = QMessageBox::question(
        m_window.widget, tr("Unsaved changes"),
        untitled
            ? tr("The exemplars were edited, and no session holds that yet. Results are kept in any case.")
            : tr("%1 has changes that are not saved.").arg(QFileInfo(m_file).completeBaseName()),
        QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
    if (answer == QMessageBox::Save)
        return saveNow(untitled ? askForFile(tr("Save session")) : m_file);
    return answer != QMessageBox::Cancel;
}

/// Saves before anything else happens. @return false if it was not saved.
bool Document::saveNow(const QString& path) {
    if (path.isEmpty())
        return false;
    try {
        SaveGuard(this).check(toPath(path), TR("session"));
        packSession(toPath(path), m_window.read(), toPath(ownFolder()));
    } catch (const std::exception& error) {
        m_window.refuse(tr("The session was not saved. %1").arg(sentence(error)));
        return false;
    }
    setFile(path);
    setModified(false);
    return true;
}

bool Document::mayClose() {
    if (!askToSave())
        return false;
    m_closing = true;
    m_recovery->pause();
    return true;
}

/// What a crash would lose.
std::optional<Session> Document::unsaved() const {
    if (m_closing || !m_modified)
        return {};
    Session session = m_window.read();
    session.file = toPath(m_file);
    return session;
}

void Document::offerRecovery() {
    m_recovery->offer(m_window.widget);
}

void Document::recover(const QString& path) {
    try {
        const Session session = readSession(toPath(path));
        resolve(session, toQString(session.file), path);
    } catch (const std::exception& error) {
        m_window.refuse(sentence(error));
    }
}

} // namespace texloom::ui
