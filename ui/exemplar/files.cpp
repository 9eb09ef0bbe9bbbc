#include "ui/exemplar/files.h"

#include "core/base/error.h"
#include "core/session/export/output_files.h"
#include "core/session/run/checkpoint_file.h"
#include "core/session/session.h"
#include "ui/common/own_folders.h"
#include "ui/common/text.h"
#include "ui/exemplar/material.h"
#include "ui/exemplar/resource_folder.h"
#include "ui/runs/result_drag.h"

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
#include <utility>

namespace texloom::ui {

namespace {

const QString kRecents = QStringLiteral("recentFiles");
/// Files made here that are younger may belong to a window that has not written its copy for recovery yet.
constexpr int kOwnDays = 7;
constexpr int kMostRecents = 12;

const QStringList& pictureNames() {
    static const QStringList names{
        QStringLiteral("*.png"),  QStringLiteral("*.jpg"), QStringLiteral("*.jpeg"), QStringLiteral("*.tif"),
        QStringLiteral("*.tiff"), QStringLiteral("*.exr"), QStringLiteral("*.hdr")};
    return names;
}

} // namespace

QStringList bundledExemplars() {
    const QString folder = resourceFolder(QStringLiteral("exemplars"));
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
    return QCoreApplication::translate("files",
                                       "Pictures, materials and recipes (%1 *.zip *.json);;All files (*)")
        .arg(pictureNames().join(QLatin1Char(' ')));
}

bool offersPicture(const QMimeData& data) {
    return data.hasUrls() || data.hasImage();
}

QStringList localFiles(const QMimeData& data) {
    QStringList paths;
    if (!ResultDrag::keyOf(data).empty())
        return paths; // it writes a file, for other programs, as soon as one is asked for
    for (const QUrl& url : data.urls())
        if (url.isLocalFile())
            paths += url.toLocalFile();
    return paths;
}

QString pastedFolder() {
    return dataFolder(kPasted);
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

namespace {

/// A path in ownFolder() that no other file has.
std::filesystem::path ownPath(const QString& name, const QString& ending) {
    const QDir folder(ownFolder());
    if (!folder.mkpath(QStringLiteral(".")))
        fail("The folder {} cannot be made; check that there is room.", folder.path().toStdString());
    const QString stamp = QDateTime::currentDateTime().toString(QStringLiteral("yyyyMMdd-HHmmss-zzz"));
    return toPath(folder.filePath(QStringLiteral("%1-%2%3").arg(name, stamp, ending)));
}

std::filesystem::path withoutExtension(std::filesystem::path path) {
    return path.replace_extension();
}

/// The recipes of runs that can still go on.
std::vector<Recipe> recipesOfCheckpoints(const QString& recovery) {
    std::vector<Recipe> recipes;
    for (const QFileInfo& file : QDir(recovery).entryInfoList({QStringLiteral("*.checkpoint")}, QDir::Files))
        try {
            recipes.push_back(readCheckpoint(toPath(file.filePath())).recipe);
        } catch (const Error&) { // damaged: no run goes on from it
        }
    return recipes;
}

/// Removes the folders of materials of which no recipe names a file.
void removeOldMaterials(const std::vector<Recipe>& recipes, const QDateTime& limit) {
    std::set<std::filesystem::path> named;
    for (const Recipe& recipe : recipes)
        for (const RecipeFile* file : recipe.files())
            named.insert(file->path.parent_path());
    const QDir folder(materialFolder());
    for (const QFileInfo& material : folder.entryInfoList(QDir::Dirs | QDir::NoDotAndDotDot))
        if (material.lastModified() < limit && !named.contains(toPath(material.filePath())))
            QDir(material.filePath()).removeRecursively();
}

} // namespace

ExemplarFile saveMask(const Image& mask, const std::string& exemplar) {
    const auto path =
        ownPath(QString::fromStdString(exemplar) + QStringLiteral("_mask"), QStringLiteral(".png"));
    WriteOptions options;
    options.space = "raw";
    writeImage(path, mask, options);
    return loadMask(path);
}

QString savePicture(const Image& image, const std::string& name, const std::string& space) {
    const auto path = ownPath(QString::fromStdString(name), QStringLiteral(".exr"));
    WriteOptions options;
    options.depth = Depth::Float;
    options.space = space;
    writeImage(path, image, options);
    return toQString(path);
}

QString saveResult(const Image& image, const std::string& name, const std::string& space,
                   const Recipe& recipe) {
    const auto path = ownPath(QString::fromStdString(name), QStringLiteral(".exr"));
    WriteOptions options;
    options.depth = Depth::Float;
    options.space = space;
    options.recipe = recipe.toJson(path.parent_path());
    writeImage(path, image, options);
    return toQString(path);
}

QString saveInput(const Result& result, const Port& port, const Asset& asset) {
    const std::string name = result.fileName();
    const Recipe& recipe = result.plan.recipe;
    if (const auto* image = std::get_if<std::shared_ptr<const Image>>(&asset)) {
        const bool data = port.kind == AssetKind::Mask ||
                          (!recipe.exemplars.empty() && recipe.exemplars.front().image.space == "raw");
        return saveResult(**image, name, data ? "raw" : "srgb", recipe);
    }
    const auto path =
        ownPath(QString::fromStdString(name), QString::fromStdString(usualExtension(port.kind)));
    AssetWriteOptions options = outputOptions(result, {&port, &asset, path});
    options.mostVoxels = AssetWriteOptions().mostVoxels;
    writeAsset(port.kind, asset, path, options);
    return toQString(path);
}

void removeOldFiles(std::vector<Recipe> recipes, const QString& recovery) {
    for (const QFileInfo& copy : QDir(recovery).entryInfoList(QDir::Files))
        if (copy.suffix() == QLatin1String("texloom"))
            recipes.push_back(readSession(toPath(copy.filePath())).settings);
    for (Recipe& recipe : recipesOfCheckpoints(recovery))
        recipes.push_back(std::move(recipe));
    std::set<std::filesystem::path> named; // without extensions: the data of a volume lie beside its head
    for (const Recipe& recipe : recipes)
        for (const RecipeFile* file : recipe.files())
            named.insert(withoutExtension(file->path));
    const QDateTime limit = QDateTime::currentDateTime().addDays(-kOwnDays);
    removeOldMaterials(recipes, limit);
    for (const QFileInfo& own : QDir(ownFolder()).entryInfoList(QDir::Files))
        if (own.lastModified() < limit && !named.contains(withoutExtension(toPath(own.filePath()))))
            QFile::remove(own.filePath());
}

} // namespace texloom::ui
