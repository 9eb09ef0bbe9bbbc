#pragma once

#include "core/session/export/export_preset.h"

#include <QString>
#include <QStringList>

#include <vector>

namespace texloom::ui {

/// One's own export presets: files in the user's data, by which the command line can use them, too.
struct OwnExportPresets {
    std::vector<ExportPreset> presets; ///< by title
    QStringList refused;               ///< files that cannot be read, each with the reason

    static QString folder();
    static OwnExportPresets read();
    /// The file of a preset.
    static QString fileOf(const ExportPreset& preset);
};

/// Puts these in the place of all of one's own, those that have no id yet under one that no other has.
/// @throws Error, UsageError
void keepOwnExportPresets(std::vector<ExportPreset>& presets);

} // namespace texloom::ui
