#pragma once

#include <QWidget>

class QFormLayout;
class QLabel;

namespace texloom::ui {

class ValueEditor;

/// The editor for one of the values that the editing page sets: angle, model, width, order, strength or
/// brush; as parameters of methods have.
ValueEditor* editorFor(const char* name, QWidget* parent);

/// Adds it to a form under its title. @return the label.
QLabel* addEditorRow(QFormLayout* form, const char* name, ValueEditor* editor);

/// What an editor of real numbers shows.
double realOf(const ValueEditor& editor);

/// A note that wraps.
QLabel* noteLabel(const QString& text);

} // namespace texloom::ui
