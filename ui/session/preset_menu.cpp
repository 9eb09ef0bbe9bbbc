#include "ui/session/preset_menu.h"

#include "core/base/text.h"
#include "core/io/image_file.h"
#include "ui/common/background.h"
#include "ui/common/own_folders.h"
#include "ui/common/save_guard.h"
#include "ui/common/text.h"

#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QStandardPaths>

#include <utility>

namespace texloom::ui {

namespace {

Preset presetNamed(const QString& name, std::vector<RecipeStep> steps) {
    return {idFrom(name).toStdString(), name.trimmed().toStdString(), {}, std::move(steps)};
}

QString fileOf(const QString& id) {
    return PresetMenu::folder() + QLatin1Char('/') + id + QStringLiteral(".json");
}

} // namespace

PresetMenu::PresetMenu(std::function<std::vector<RecipeStep>()> steps, QWidget* parent)
    : QMenu(tr("Pre&sets"), parent), m_steps(std::move(steps)) {
    setObjectName(QStringLiteral("presetMenu"));
    setToolTipsVisible(true);
    connect(this, &QMenu::aboutToShow, this, &PresetMenu::fill);
    fill();
}

QString PresetMenu::folder() {
    return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + QStringLiteral("/presets");
}

void PresetMenu::addPreset(QMenu* menu, const Preset& preset, bool shipped) {
    const auto text = [shipped](const std::string& words) {
        return shipped ? translated(words) : QString::fromStdString(words);
    };
    QAction* const action =
        menu->addAction(text(preset.title).replace(QLatin1Char('&'), QStringLiteral("&&")));
    action->setObjectName(QString::fromStdString((shipped ? "preset-" : "own-preset-") + preset.id));
    action->setToolTip(text(preset.summary));
    connect(action, &QAction::triggered, this, [this, preset] { Q_EMIT chosen(preset); });
}

void PresetMenu::fill() {
    clear();
    for (const Preset& preset : presets())
        addPreset(this, preset, true);
    addSeparator();
    const std::vector<Preset> own =
        presetsIn(toPath(folder()), [this](const Message& why) { Q_EMIT failed(translated(why)); });
    for (const Preset& preset : own)
        addPreset(this, preset, false);
    addSeparator();
    QAction* const keeping = addAction(tr("&Keep settings as a preset…"), this, &PresetMenu::askForName);
    keeping->setObjectName(QStringLiteral("keepPreset"));
    addAction(tr("&Import presets…"), this, &PresetMenu::askForImport);
    addAction(tr("&Export settings as a preset…"), this, &PresetMenu::askForExport);
    QMenu* const removing = addMenu(tr("&Remove"));
    removing->setEnabled(!own.empty());
    for (const Preset& preset : own)
        removing->addAction(QString::fromStdString(preset.title), this,
                            [this, id = QString::fromStdString(preset.id)] { remove(id); });
}

void PresetMenu::keep(const QString& name) {
    const Preset preset = presetNamed(name, m_steps());
    const QString id = QString::fromStdString(preset.id);
    if (id.isEmpty())
        return Q_EMIT failed(tr("The preset needs a name with a letter or a figure in it."));
    if (QFile::exists(fileOf(id)))
        return Q_EMIT known(name);
    replace(name);
}

void PresetMenu::replace(const QString& name) {
    const QString id = QString::fromStdString(presetNamed(name, m_steps()).id);
    if (!write(fileOf(id), name))
        return;
    fill();
    Q_EMIT told(tr("Kept the preset %1.").arg(name));
}

void PresetMenu::exportTo(const QString& path, const QString& name) {
    try {
        SaveGuard().check(toPath(path), TR("preset"));
    } catch (const std::exception& error) {
        return Q_EMIT failed(sentence(error));
    }
    if (write(path, name))
        Q_EMIT told(tr("Wrote the preset %1.").arg(QFileInfo(path).fileName()));
}

bool PresetMenu::write(const QString& path, const QString& name) {
    try {
        QDir().mkpath(QFileInfo(path).path());
        writeText(toPath(path), presetNamed(name, m_steps()).toJson());
        return true;
    } catch (const std::exception& error) {
        Q_EMIT failed(sentence(error));
        return false;
    }
}

void PresetMenu::importFrom(const QString& path) {
    const QFileInfo file(path);
    try {
        const Preset preset = Preset::fromJson(file.completeBaseName().toStdString(), readText(toPath(path)));
        const QString target = fileOf(idFrom(file.completeBaseName()));
        if (QFile::exists(target))
            return Q_EMIT failed(
                tr("There is a preset %1 already; rename the file or remove the preset first.")
                    .arg(file.completeBaseName()));
        QDir().mkpath(folder());
        writeText(toPath(target), preset.toJson());
        fill();
        Q_EMIT told(tr("Imported the preset %1.").arg(QString::fromStdString(preset.title)));
    } catch (const std::exception& error) {
        Q_EMIT failed(tr("%1: %2").arg(file.fileName(), sentence(error)));
    }
}

void PresetMenu::remove(const QString& id) {
    if (!QFile::remove(fileOf(id)))
        Q_EMIT failed(tr("The preset %1 could not be removed.").arg(id));
    fill();
}

void PresetMenu::askForName() {
    auto* dialog = new QInputDialog(parentWidget());
    dialog->setObjectName(QStringLiteral("presetName"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Keep settings as a preset"));
    dialog->setLabelText(tr("Name of the preset"));
    connect(dialog, &QInputDialog::textValueSelected, this, &PresetMenu::keep);
    dialog->open();
}

void PresetMenu::askForImport() {
    for (const QString& path :
         QFileDialog::getOpenFileNames(parentWidget(), tr("Import presets"), {}, tr("Presets (*.json)")))
        importFrom(path);
}

void PresetMenu::askForExport() {
    const QString path = askWhereToSave(parentWidget(), tr("Export settings as a preset"), {},
                                        tr("Presets (*.json)"), {QStringLiteral("json"), true});
    if (!path.isEmpty())
        exportTo(path, QFileInfo(path).completeBaseName());
}

} // namespace texloom::ui
