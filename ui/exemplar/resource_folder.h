#pragma once

#include <QString>

namespace texloom::ui {

/// A folder of what comes with the program, such as "exemplars"; empty if it is not there. Looked for in
/// $TEXLOOM_RESOURCES, then beside and above the program.
QString resourceFolder(const QString& name);

} // namespace texloom::ui
