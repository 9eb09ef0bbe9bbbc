#pragma once

#include "core/methods/method.h"

#include <QWidget>

#include <vector>

namespace texloom::ui {

class Mnemonics;
class ParamRow;

/// A row for each parameter of a method, in its groups, made from the method's declaration.
class MethodForm : public QWidget {
    Q_OBJECT

public:
    /// @param method must outlive the form.
    MethodForm(const Method& method, Mnemonics& mnemonics, QWidget* parent = nullptr);

    const Method& method() const { return m_method; }
    const std::vector<ParamRow*>& rows() const { return m_rows; }
    /// All parameters' values as the form shows them.
    Values values() const;
    /// Those that the user changed.
    Values changedValues() const;
    /// Sets these parameters and brings all others back to their defaults.
    void setValues(const Values& values);
    /// Sets those of these parameters that the method has and can take.
    void adopt(const Values& values);
    /// Takes the defaults for an exemplar whose shorter side is this long.
    void setExemplarSide(int side);

Q_SIGNALS:
    void edited();
    /// What the parameter does whose row the mouse or the focus came to.
    void helpWanted(const QString& html);

private:
    QWidget* makeGroup(const std::string& name, Mnemonics& mnemonics);
    void alignLabels();
    void updateConditions();

    const Method& m_method;
    std::vector<ParamRow*> m_rows;
};

} // namespace texloom::ui
