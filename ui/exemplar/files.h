#pragma once

#include "core/io/recipe.h"
#include "core/session/run/exemplar_file.h"
#include "core/session/run/run.h"

#include <QImage>
#include <QString>
#include <QStringList>

#include <vector>

class QMimeData;

namespace texloom::ui {

/// The exemplars that come with the program, as paths; empty if their folder is not there. Looked for in
/// $TEXLOOM_RESOURCES/exemplars, then beside and above the program.
QStringList bundledExemplars();

/// The files opened last, newest first; those that are gone are left out.
QStringList recentFiles();
void addRecentFile(const QString& path);

/// The filter of a dialog that opens pictures.
QString pictureFilter();

/// Whether something dropped or pasted holds files or a picture.
bool offersPicture(const QMimeData& data);

/// Paths of the local files in it; none in a result of the window's own.
QStringList localFiles(const QMimeData& data);

/// Where pasted pictures are kept.
QString pastedFolder();

/// Writes a pasted picture to a file of its own in pastedFolder(). Called on a worker. @throws Error
QString savePastedPicture(const QImage& picture);

/// The folder for what is made here and has no place of its own: painted masks, results that are inputs.
QString ownFolder();

/// Writes a painted mask to a file of its own in ownFolder(). Called on a worker. @throws Error
ExemplarFile saveMask(const Image& mask, const std::string& exemplar);

/// Writes a picture, bit for bit, to a file of its own in ownFolder(). Called on a worker.
/// @param name the file's begins with it. @param space "srgb", or "raw" for data. @return its path.
/// @throws Error
QString savePicture(const Image& image, const std::string& name, const std::string& space);

/// Writes a result, bit for bit, to a file of its own in ownFolder(), so that it can be an input or an
/// exemplar. Called on a worker. @param name the file's begins with it. @param space "srgb", or "raw" for
/// data. @param recipe that made it. @return its path. @throws Error, UsageError
QString saveResult(const Image& image, const std::string& name, const std::string& space,
                   const Recipe& recipe);

/// Writes what a result has for a port, of any kind, to files of its own in ownFolder(): pictures and masks
/// as saveResult(), of volumes without end as much as the store of results keeps. Called on a worker.
/// @param asset as assetFor() gives it. @return the path by which the port reads it. @throws Error,
/// UsageError
QString saveInput(const Result& result, const Port& port, const Asset& asset);

/// Removes the files in ownFolder() and the folders in materialFolder() that are older than a week and named
/// neither by these recipes nor by a session or a checkpoint in the folder of those to be recovered; saved
/// sessions have copies of their own. Called on a worker.
/// @throws Error, UsageError where a session cannot be read; then nothing is removed.
void removeOldFiles(std::vector<Recipe> recipes, const QString& recovery);

} // namespace texloom::ui
