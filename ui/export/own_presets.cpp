#include "ui/export/own_presets.h"

#include "core/io/image_file.h"
#include "ui/common/own_folders.h"
#include "ui/common/text.h"

#include <QDir>
#include <QFile>
#include <QSet>

#include <algorithm>

namespace texloom::ui {

namespace {

/// The ids of the shipped presets stay theirs.
QSet<QString> shippedIds() {
    QSet<QString> ids;
    for (const ExportPreset& preset : exportPresets())
        ids.insert(QString::fromStdString(preset.id));
    return ids;
}

} // namespace

QString OwnExportPresets::folder() {
    return dataFolder(QStringLiteral("export_presets"));
}

QString OwnExportPresets::fileOf(const ExportPreset& preset) {
    return folder() + QLatin1Char('/') + QString::fromStdString(preset.id) + QStringLiteral(".json");
}

OwnExportPresets OwnExportPresets::read() {
    OwnExportPresets own;
    own.presets =
        exportPresetsIn(toPath(folder()), [&own](const Message& why) { own.refused += translated(why); });
    return own;
}

void keepOwnExportPresets(std::vector<ExportPreset>& presets) {
    for (const ExportPreset& preset : presets)
        checkExportPreset(preset);
    QSet<QString> taken = shippedIds();
    for (const ExportPreset& preset : presets)
        taken.insert(QString::fromStdString(preset.id));
    for (ExportPreset& preset : presets) {
        if (!preset.id.empty())
            continue;
        const QString named = idFrom(QString::fromStdString(preset.title));
        const QString wanted = named.isEmpty() ? QStringLiteral("preset") : named;
        QString id = wanted;
        for (int copy = 2; taken.contains(id) || QFile::exists(OwnExportPresets::folder() + QLatin1Char('/') +
                                                               id + QStringLiteral(".json"));
             ++copy)
            id = QStringLiteral("%1-%2").arg(wanted).arg(copy);
        taken.insert(id);
        preset.id = id.toStdString();
    }
    const std::vector<ExportPreset> before = OwnExportPresets::read().presets;
    QDir().mkpath(OwnExportPresets::folder());
    for (const ExportPreset& preset : presets)
        writeText(toPath(OwnExportPresets::fileOf(preset)), preset.toJson());
    for (const ExportPreset& old : before)
        if (std::none_of(presets.begin(), presets.end(),
                         [&old](const ExportPreset& kept) { return kept.id == old.id; }))
            QFile::remove(OwnExportPresets::fileOf(old));
}

} // namespace texloom::ui
