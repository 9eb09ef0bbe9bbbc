#pragma once

#include <QString>
#include <QStringList>

namespace texloom::ui {

/// A folder of what comes with the program, such as "exemplars"; empty if it is not there. Looked for in
/// $TEXLOOM_RESOURCES, then beside and above the program.
QString resourceFolder(const QString& name);

/// The files in such a folder whose names match, by name. @param pattern such as *.json.
QStringList resourceFiles(const QString& name, const QString& pattern);

} // namespace texloom::ui
