#pragma once

#include "core/session/run/input_file.h"
#include "core/session/session.h"

#include <QString>

class QComboBox;

namespace texloom::ui {

class Inspector;

/// All settings as the window shows them: what undo goes back to and a session keeps.
struct SettingsState {
    Recipe settings; ///< without exemplars and inputs; only the parameters that the user set
    InputFiles inputs;
    bool seedLocked = true;

    /// What is different, as a path such as "/parameters/patch"; empty if nothing is. Several differences of
    /// one group are the group, "/parameters" for one.
    QString difference(const SettingsState& other) const;
};

SettingsState settingsOf(const QComboBox& method, const Inspector& inspector);
void showSettings(const SettingsState& state, QComboBox& method, Inspector& inspector);

} // namespace texloom::ui
