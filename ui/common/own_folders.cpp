#include "ui/common/own_folders.h"

#include <QStandardPaths>

namespace texloom::ui {

QString dataFolder(const QString& name) {
    return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + QLatin1Char('/') + name;
}

QString earlierFolder(const QString& name) {
    return QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + QLatin1Char('/') + name;
}

} // namespace texloom::ui
