#pragma once

#include "core/session/export/output_guard.h"

#include <QObject>
#include <QPointer>
#include <QString>

#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

class QWidget;

namespace texloom::ui {

/// The files that what is open in the windows is made from: exemplars with all that belongs to them, inputs,
/// the session, meshes. Whatever holds such files tells of them when it is asked. Used on the GUI thread.
class FilesInUse {
public:
    using Tell = std::function<void(OutputGuard&)>;

    /// Those of this program.
    static FilesInUse& all();

    /// @param owner as long as it lives, it holds what `tell` names.
    void add(QObject* owner, Tell tell);
    /// All of them as they are now. @param but what is held by objects of its class is left out, as sessions
    /// may replace sessions.
    OutputGuard now(const QObject* but = nullptr) const;

private:
    struct Holder {
        QPointer<QObject> owner;
        Tell tell;
    };

    mutable std::vector<Holder> m_holders;
};

/// What every save of the window goes through: nothing that is in use is ever replaced, and of other people's
/// files only the one that the user chose, who was asked about it by the file dialog.
class SaveGuard {
public:
    /// Made on the GUI thread, before the work begins. @param by see FilesInUse::now()
    explicit SaveGuard(const QObject* by = nullptr);

    /// Called right before the files are written, on any thread.
    /// @param chosen the name that the user chose. @param what is written, for messages.
    /// @throws UsageError in one sentence
    void check(const std::filesystem::path& chosen, const Message& what) const;
    /// The same for several files, among which `chosen` need not be.
    void check(const std::filesystem::path& chosen, const Message& what,
               const std::vector<std::filesystem::path>& files) const;

private:
    std::shared_ptr<const OutputGuard> m_inUse;
};

/// Which ending a file gets whose name has none, or (if `only`) has another.
struct Ending {
    QString suffix; ///< without the point
    bool only = false;
};

/// Asks where to save. The name has its ending before the user is asked about a file that is there.
/// @param start folder or file to begin with. @return the file, or empty if none was chosen.
QString askWhereToSave(QWidget* parent, const QString& title, const QString& start, const QString& filter,
                       const Ending& ending);

} // namespace texloom::ui
