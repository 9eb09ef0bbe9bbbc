#pragma once

#include "core/io/recipe.h"
#include "core/methods/method.h"

#include <QWidget>

#include <vector>

class QLabel;
class QVBoxLayout;

namespace texloom::ui {

class MethodForm;
class OutputGroup;
class ParamRow;
class StepChain;

/// The right dock's form: the output's settings, the method's parameters, and the methods that follow it with
/// theirs. Below it, in words, what the control in use does.
class Inspector : public QWidget {
    Q_OBJECT

public:
    explicit Inspector(QWidget* parent = nullptr);

    /// Makes the form of another method; parameters of the same name and type keep what the user set.
    void setMethod(const Method& method);
    const Method* method() const;
    /// The exemplar that defaults scale with; empty if there is none.
    void setExemplarSize(Size size);
    /// All parameters' values as the form shows them.
    Values values() const;
    /// Those that the user set.
    Values changedValues() const;
    /// Sets these parameters and brings all others back to their defaults.
    void setValues(const Values& values);
    /// Sets these parameters, those of them that the method has, and leaves all others.
    void changeValues(const Values& values);
    /// The methods that follow, with all their parameters.
    std::vector<RecipeStep> then() const;
    /// All methods with only what was set by hand: the rest follows from the exemplar.
    std::vector<RecipeStep> changedSteps() const;
    void setThen(const std::vector<RecipeStep>& steps);
    /// The method with its values, and those that follow it with all their parameters.
    std::vector<RecipeStep> steps() const;
    void setSteps(const std::vector<RecipeStep>& steps);
    /// Brings every parameter back to its default.
    void resetAll();

    OutputGroup* output() const { return m_output; }
    /// The first method's rows.
    const std::vector<ParamRow*>& rows() const;
    /// The text under the form.
    QString help() const;

Q_SIGNALS:
    /// Any setting changed.
    void edited();

private:
    void showHelp(const QString& html);
    void showPorts();

    OutputGroup* m_output;
    MethodForm* m_form = nullptr;
    StepChain* m_then;
    QVBoxLayout* m_column;
    QLabel* m_help;
    Size m_exemplar;
};

} // namespace texloom::ui
