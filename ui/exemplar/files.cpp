#include "ui/exemplar/files.h"

#include "core/base/error.h"
#include "core/session/session.h"
#include "ui/common/own_folders.h"
#include "ui/common/text.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QDirIterator>
#include <QFileInfo>
#include <QMimeData>
#include <QSettings>
#include <QUrl>

#include <algorithm>
#include <set>

namespace texloom::ui {

namespace {

const QString kRecents = QStringLiteral("recentFiles");
/// Painted masks younger than this may belong to a window that has not written its copy for recovery yet.
constexpr int kMaskDays = 7;
constexpr int kMostRecents = 12;

const QStringList& pictureNames() {
    static const QStringList names{
        QStringLiteral("*.png"),  QStringLiteral("*.jpg"), QStringLiteral("*.jpeg"), QStringLiteral("*.tif"),
        QStringLiteral("*.tiff"), QStringLiteral("*.exr"), QStringLiteral("*.hdr")};
    return names;
}

/// The folder of bundled exemplars, or empty.
QString bundleFolder() {
    QStringList candidates;
    const QString named = qEnvironmentVariable("TEXLOOM_RESOURCES");
    if (!named.isEmpty())
        candidates += named + QStringLiteral("/exemplars");
    QDir folder(QCoreApplication::applicationDirPath());
    candidates += folder.filePath(QStringLiteral("../share/texloom/exemplars"));
    do
        candidates += folder.filePath(QStringLiteral("resources/exemplars"));
    while (folder.cdUp());
    for (const QString& candidate : candidates)
        if (QFileInfo(candidate).isDir())
            return QDir::cleanPath(candidate);
    return {};
}

} // namespace

QStringList bundledExemplars() {
    const QString folder = bundleFolder();
    if (folder.isEmpty())
        return {};
    QStringList found;
    QDirIterator files(folder, pictureNames(), QDir::Files, QDirIterator::Subdirectories);
    while (files.hasNext()) {
        const QFileInfo file(files.next());
        const bool companion =
            file.dir() != QDir(folder) && !file.baseName().endsWith(QStringLiteral("_albedo"));
        if (!companion)
            found += file.filePath();
    }
    found.sort();
    return found;
}

QStringList recentFiles() {
    QStringList present;
    for (const QString& path : QSettings().value(kRecents).toStringList())
        if (QFileInfo::exists(path))
            present += path;
    return present;
}

void addRecentFile(const QString& path) {
    QStringList recents = QSettings().value(kRecents).toStringList();
    recents.removeAll(path);
    recents.prepend(path);
    QSettings().setValue(kRecents, recents.mid(0, kMostRecents));
}

QString pictureFilter() {
    return QCoreApplication::translate("files", "Pictures and recipes (%1 *.json);;All files (*)")
        .arg(pictureNames().join(QLatin1Char(' ')));
}

bool offersPicture(const QMimeData& data) {
    return data.hasUrls() || data.hasImage();
}

QStringList localFiles(const QMimeData& data) {
    QStringList paths;
    for (const QUrl& url : data.urls())
        if (url.isLocalFile())
            paths += url.toLocalFile();
    return paths;
}

QString pastedFolder() {
    return dataFolder(QStringLiteral("pasted"));
}

QString savePastedPicture(const QImage& picture) {
    const QDir folder(pastedFolder());
    const QString stamp = QDateTime::currentDateTime().toString(QStringLiteral("yyyyMMdd-HHmmss-zzz"));
    QString path = folder.filePath(QStringLiteral("pasted-%1.png").arg(stamp));
    if (!folder.mkpath(QStringLiteral(".")) || !picture.save(path, "PNG"))
        fail("The pasted picture could not be kept in {}; check that there is room.",
             folder.path().toStdString());
    return path;
}

QString ownFolder() {
    return dataFolder(QStringLiteral("masks"));
}

ExemplarFile saveMask(const Image& mask, const std::string& exemplar) {
    const QDir folder(ownFolder());
    const QString stamp = QDateTime::currentDateTime().toString(QStringLiteral("yyyyMMdd-HHmmss-zzz"));
    if (!folder.mkpath(QStringLiteral(".")))
        fail("The painted mask could not be kept in {}; check that there is room.",
             folder.path().toStdString());
    const QString name = QStringLiteral("%1_mask-%2.png").arg(QString::fromStdString(exemplar), stamp);
    WriteOptions options;
    options.space = "raw";
    writeImage(toPath(folder.filePath(name)), mask, options);
    return loadMask(toPath(folder.filePath(name)));
}

void removeOldMasks(const std::vector<Recipe>& recipes, const QString& recovery) {
    std::set<std::filesystem::path> named;
    const auto add = [&](const Recipe& recipe) {
        for (const RecipeExemplar& exemplar : recipe.exemplars)
            if (exemplar.mask)
                named.insert(exemplar.mask->path);
    };
    std::for_each(recipes.begin(), recipes.end(), add);
    for (const QFileInfo& copy : QDir(recovery).entryInfoList(QDir::Files))
        if (copy.suffix() == QLatin1String("texloom"))
            add(readSession(toPath(copy.filePath())).settings);
    const QDateTime limit = QDateTime::currentDateTime().addDays(-kMaskDays);
    for (const QFileInfo& mask : QDir(ownFolder()).entryInfoList(QDir::Files))
        if (mask.lastModified() < limit && !named.contains(toPath(mask.filePath())))
            QFile::remove(mask.filePath());
}

} // namespace texloom::ui
