#pragma once

#include <QString>

namespace texloom::ui {

/// Where what someone made is kept until they remove it: the folder of this name in the user's data.
QString dataFolder(const QString& name);

/// Where earlier versions kept the same: in the cache, which programs that tidy up empty.
QString earlierFolder(const QString& name);

} // namespace texloom::ui
