#pragma once

#include <QString>

namespace texloom::ui {

/// The name of the folder of pasted pictures.
inline const QString kPasted = QStringLiteral("pasted");

/// Where what someone made is kept until they remove it: the folder of this name in the user's data.
QString dataFolder(const QString& name);

/// What a file that someone gave a title is called: "old-bark-fine" for "Old bark, fine"; empty where the
/// title has neither letters nor digits.
QString idFrom(const QString& title);

/// Where earlier versions kept the same: in the cache, which programs that tidy up empty.
QString earlierFolder(const QString& name);

/// Moves the files of earlierFolder() to dataFolder(), where none has their names. Each leaves a link behind,
/// as sessions and recipes name it where it was. Called on a worker.
void takeOverFiles(const QString& name);

} // namespace texloom::ui
