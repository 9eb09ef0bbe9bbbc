#include "ui/common/save_guard.h"

#include "core/base/error.h"
#include "core/base/text.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>

#include <utility>

namespace texloom::ui {

namespace fs = std::filesystem;

FilesInUse& FilesInUse::all() {
    static FilesInUse files;
    return files;
}

void FilesInUse::add(QObject* owner, Tell tell) {
    m_holders.push_back({owner, std::move(tell)});
}

OutputGuard FilesInUse::now(const QObject* but) const {
    std::erase_if(m_holders, [](const Holder& holder) { return holder.owner.isNull(); });
    OutputGuard guard;
    for (const Holder& holder : m_holders)
        if (but == nullptr || holder.owner->metaObject() != but->metaObject())
            holder.tell(guard);
    return guard;
}

SaveGuard::SaveGuard(const QObject* by)
    : m_inUse(std::make_shared<const OutputGuard>(FilesInUse::all().now(by))) {}

void SaveGuard::check(const fs::path& chosen, const Message& what) const {
    check(chosen, what, {chosen});
}

void SaveGuard::check(const fs::path& chosen, const Message& what, const std::vector<fs::path>& files) const {
    OutputGuard guard(m_inUse.get());
    for (const fs::path& file : files)
        guard.writes(file, what);
    guard.check(true);
    for (const fs::path& file : guard.foreign())
        if (FileIdentity::of(file) != FileIdentity::of(chosen))
            failUsage("{} is there, and Texloom did not write it; choose another name or folder.",
                      file.string());
}

QString askWhereToSave(QWidget* parent, const QString& title, const QString& start, const QString& filter,
                       const Ending& ending) {
    const auto whole = [&](const QString& name) {
        const QString suffix = QFileInfo(name).suffix();
        const bool ended =
            ending.only ? suffix.compare(ending.suffix, Qt::CaseInsensitive) == 0 : !suffix.isEmpty();
        return ended ? name : name + QLatin1Char('.') + ending.suffix;
    };
    QFileDialog dialog(parent, title, QString(), filter);
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(ending.suffix);
    const QFileInfo place(start);
    dialog.setDirectory(place.isDir() ? start : place.path());
    if (!start.isEmpty() && !place.isDir())
        dialog.selectFile(place.fileName());
    while (dialog.exec() == QDialog::Accepted && !dialog.selectedFiles().isEmpty()) {
        const QString chosen = dialog.selectedFiles().constFirst();
        QString path = whole(chosen);
        if (path == chosen || !QFileInfo::exists(path))
            return path;
        dialog.selectFile(path); // which the dialog did not ask about
    }
    return {};
}

} // namespace texloom::ui
