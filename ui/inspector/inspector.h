#pragma once

#include "core/methods/method.h"

#include <QWidget>

#include <vector>

class QLabel;
class QVBoxLayout;

namespace texloom::ui {

class Mnemonics;
class OutputGroup;
class ParamRow;

/// The right dock's form: the output's settings and, made from the method's declaration, a row for each of
/// its parameters in their groups. Below it, in words, what the control in use does.
class Inspector : public QWidget {
    Q_OBJECT

public:
    explicit Inspector(QWidget* parent = nullptr);

    /// Makes the form of another method; parameters of the same name and type keep what the user set.
    void setMethod(const Method& method);
    const Method* method() const { return m_method; }
    /// The exemplar that defaults scale with; empty if there is none.
    void setExemplarSize(Size size);
    /// All parameters' values as the form shows them.
    Values values() const;
    /// Sets these parameters and brings all others back to their defaults.
    void setValues(const Values& values);
    /// Brings every parameter back to its default.
    void resetAll();

    OutputGroup* output() const { return m_output; }
    const std::vector<ParamRow*>& rows() const { return m_rows; }
    /// The text under the form.
    QString help() const;

Q_SIGNALS:
    /// Any setting changed.
    void edited();

private:
    void makeRows();
    void alignLabels();
    QWidget* makeGroup(const std::string& name, Mnemonics& mnemonics);
    void updateConditions();
    void showHelp(const QString& html);

    const Method* m_method = nullptr;
    OutputGroup* m_output;
    QWidget* m_form = nullptr;
    QVBoxLayout* m_column;
    QLabel* m_help;
    std::vector<ParamRow*> m_rows;
    Size m_exemplar;
};

} // namespace texloom::ui
