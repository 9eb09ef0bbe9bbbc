#include "ui/common/own_folders.h"

#include "ui/common/text.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QStandardPaths>

#include <filesystem>
#include <system_error>

namespace texloom::ui {

QString dataFolder(const QString& name) {
    return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + QLatin1Char('/') + name;
}

QString idFrom(const QString& title) {
    QString id;
    for (const QChar letter : title.toLower())
        if (letter.isLetterOrNumber())
            id += letter;
        else if (!id.isEmpty() && !id.endsWith(QLatin1Char('-')))
            id += QLatin1Char('-');
    while (id.endsWith(QLatin1Char('-')))
        id.chop(1);
    return id;
}

QString earlierFolder(const QString& name) {
    return QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + QLatin1Char('/') + name;
}

void takeOverFiles(const QString& name) {
    const QDir from(earlierFolder(name)), to(dataFolder(name));
    for (const QFileInfo& file : from.entryInfoList(QDir::Files | QDir::NoSymLinks)) {
        const QString place = to.filePath(file.fileName());
        const QString link = file.filePath() + QStringLiteral(".link");
        if (QFile::exists(place) || !to.mkpath(QStringLiteral(".")))
            continue;
        // The old name leads to the picture at every moment: a copy, then a link that takes the old file's
        // place.
        if (!QFile::copy(file.filePath(), place))
            continue;
        QFile::remove(link);
        std::error_code error;
        if (QFile::link(place, link))
            std::filesystem::rename(toPath(link), toPath(file.filePath()), error);
    }
}

} // namespace texloom::ui
