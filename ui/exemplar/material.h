#pragma once

#include "core/session/run/material_files.h"

#include <QString>

#include <vector>

namespace texloom::ui {

/// Whether a path names a folder or a ZIP archive, which may hold a material.
bool isMaterial(const QString& path);

/// The materials in a folder or a ZIP archive, at least one; an archive is unpacked to a folder of its own in
/// materialFolder(). Called on a worker. @throws Error where there is no picture, or there are too many.
std::vector<MaterialFiles> materialsIn(const QString& path);

/// Whether a file is a companion map by its name.
bool isCompanion(const QString& path);

/// Whether a companion map and a picture are of one material by their names.
bool belongTogether(const QString& companion, const QString& picture);

/// Whether a map was made from other maps, rather than read from the user's files.
bool isDerived(const QString& path);

/// A folder of this name for maps that are derived, in materialFolder(); not made yet.
QString derivedFolder(const QString& name);

/// The folder for maps that are not the user's own files: unpacked ones, and those that were derived.
QString materialFolder();

} // namespace texloom::ui
