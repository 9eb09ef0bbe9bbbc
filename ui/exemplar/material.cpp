#include "ui/exemplar/material.h"

#include "core/base/error.h"
#include "core/io/decoder_process.h"
#include "core/io/image_file.h"
#include "core/io/zip_file.h"
#include "ui/common/own_folders.h"
#include "ui/common/text.h"

#include <QDir>
#include <QFileInfo>

namespace texloom::ui {

namespace {

/// More than this are hardly wanted all at once.
constexpr std::size_t kMostMaterials = 24;
/// What the folders of derived maps begin with.
const QString kDerived = QStringLiteral("derived-");

std::string stemOf(const QString& path) {
    return QFileInfo(path).completeBaseName().toStdString();
}

bool isArchive(const QString& path) {
    return path.endsWith(QStringLiteral(".zip"), Qt::CaseInsensitive);
}

/// The folder that an archive is unpacked to: the same for the same bytes.
std::filesystem::path folderFor(const std::filesystem::path& archive) {
    constexpr std::size_t kDigits = 8;
    const std::string name = archive.stem().string() + "-" + fileHash(archive).substr(0, kDigits);
    return toPath(materialFolder()) / name;
}

} // namespace

bool isMaterial(const QString& path) {
    return isArchive(path) || QFileInfo(path).isDir();
}

bool isCompanion(const QString& path) {
    return mapNameFrom(stemOf(path)).isCompanion();
}

bool belongTogether(const QString& companion, const QString& picture) {
    return QFileInfo(companion).path() == QFileInfo(picture).path() &&
           sameMaterial(stemOf(companion), stemOf(picture)) && !isCompanion(picture);
}

std::vector<MaterialFiles> materialsIn(const QString& path) {
    const std::filesystem::path file = toPath(path);
    std::vector<std::filesystem::path> pictures;
    if (isArchive(path))
        pictures = unzip(file, folderFor(file), isPictureName, {}, [] { DecoderProcess::check(); });
    else
        pictures = picturesIn(file);
    if (pictures.empty())
        fail("{} holds no picture that can be opened.", file.filename().string());
    std::vector<MaterialFiles> materials = materialsOf(pictures);
    if (materials.size() > kMostMaterials)
        fail("{} holds {} pictures; open those that you want.", file.filename().string(), materials.size());
    return materials;
}

bool isDerived(const QString& path) {
    return path.startsWith(materialFolder() + QLatin1Char('/') + kDerived);
}

QString derivedFolder(const QString& name) {
    return materialFolder() + QLatin1Char('/') + kDerived + name;
}

QString materialFolder() {
    return dataFolder(QStringLiteral("materials"));
}

} // namespace texloom::ui
