#include "ui/exemplar/edit_fields.h"

#include "core/base/param.h"
#include "core/base/text.h"
#include "core/image/exemplar_edit.h"
#include "ui/common/text.h"
#include "ui/common/value_editor.h"

#include <QFormLayout>
#include <QLabel>

#include <algorithm>

namespace texloom::ui {

namespace {

/// What the page's sliders set.
struct Fields {
    double angle = 0;
    FlattenEdit::Model model = FlattenEdit::Model::Smooth;
    double width = 0.25;
    int order = 2;
    double strength = 1;
    int brush = 32;
};

const std::vector<Param>& fields() {
    static const std::vector<Param> all = {
        field(&Fields::angle, "angle", TR("Angle")).range(-45, 45).unit("°"),
        field(&Fields::model, "model", TR("Light"))
            .choices({{"smooth", TR("Soft changes")}, {"polynomial", TR("One slope over the whole")}}),
        field(&Fields::width, "width", TR("Softness")).range(0.02, 1),
        field(&Fields::order, "order", TR("Bends")).range(1, 4),
        field(&Fields::strength, "strength", TR("Strength")).range(0, 1),
        field(&Fields::brush, "brush", TR("Brush")).range(1, 512).unit("px")};
    return all;
}

const Param& fieldNamed(const char* name) {
    return *std::find_if(fields().begin(), fields().end(),
                         [=](const Param& param) { return param.name() == name; });
}

} // namespace

ValueEditor* editorFor(const char* name, QWidget* parent) {
    const Param& param = fieldNamed(name);
    ValueEditor* const editor = makeValueEditor(param, parent);
    editor->setObjectName(QStringLiteral("edit-%1").arg(QLatin1String(name)));
    editor->setAccessibleName(translated(param.title()));
    editor->setValue(param.defaultFor(0));
    return editor;
}

QLabel* addEditorRow(QFormLayout* form, const char* name, ValueEditor* editor) {
    auto* label = new QLabel(translated(fieldNamed(name).title()));
    label->setBuddy(editor);
    form->addRow(label, editor);
    return label;
}

double realOf(const ValueEditor& editor) {
    const Value value = editor.value();
    return std::holds_alternative<int>(value) ? std::get<int>(value) : std::get<double>(value);
}

QLabel* noteLabel(const QString& text) {
    auto* note = new QLabel(text);
    note->setWordWrap(true);
    return note;
}

} // namespace texloom::ui
