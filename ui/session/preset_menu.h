#pragma once

#include "core/session/preset.h"

#include <QMenu>

#include <functional>

namespace texloom::ui {

/// The presets that Texloom ships and one's own: to use, to keep the settings as they stand under a name, to
/// import from files and export to them.
class PresetMenu : public QMenu {
    Q_OBJECT

public:
    /// @param steps the methods and settings as they stand.
    explicit PresetMenu(std::function<std::vector<RecipeStep>()> steps, QWidget* parent = nullptr);

    /// Keeps the settings as they stand. @param name as the user wrote it.
    void keep(const QString& name);
    /// The same in place of the preset that has the name.
    void replace(const QString& name);
    /// Takes a preset's file over into one's own.
    void importFrom(const QString& path);
    void exportTo(const QString& path, const QString& name);
    void remove(const QString& id);
    /// The folder of one's own presets.
    static QString folder();

Q_SIGNALS:
    void chosen(const texloom::Preset& preset);
    /// What was done, in a sentence.
    void told(const QString& sentence);
    void failed(const QString& sentence);
    /// A preset that was to be kept has the name of another.
    void known(const QString& name);

private:
    void fill();
    bool write(const QString& path, const QString& name);
    void addPreset(QMenu* menu, const Preset& preset, bool shipped);
    void askForName();
    void askForImport();
    void askForExport();

    std::function<std::vector<RecipeStep>()> m_steps;
};

} // namespace texloom::ui
