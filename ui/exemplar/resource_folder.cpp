#include "ui/exemplar/resource_folder.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QStringList>

namespace texloom::ui {

QString resourceFolder(const QString& name) {
    QStringList candidates;
    const QString named = qEnvironmentVariable("TEXLOOM_RESOURCES");
    if (!named.isEmpty())
        candidates += named + QLatin1Char('/') + name;
    QDir folder(QCoreApplication::applicationDirPath());
    candidates += folder.filePath(QStringLiteral("../share/texloom/") + name);
    do
        candidates += folder.filePath(QStringLiteral("resources/") + name);
    while (folder.cdUp());
    for (const QString& candidate : candidates)
        if (QFileInfo(candidate).isDir())
            return QDir::cleanPath(candidate);
    return {};
}

QStringList resourceFiles(const QString& name, const QString& pattern) {
    const QString folder = resourceFolder(name);
    QStringList paths;
    if (!folder.isEmpty())
        for (const QFileInfo& file : QDir(folder).entryInfoList({pattern}, QDir::Files))
            paths += file.filePath();
    return paths;
}

} // namespace texloom::ui
