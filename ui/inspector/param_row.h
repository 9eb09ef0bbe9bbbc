#pragma once

#include "core/base/param.h"

#include <QObject>
#include <QString>

#include <optional>

class QGridLayout;
class QLabel;
class QToolButton;

namespace texloom::ui {

class Mnemonics;
class ValueEditor;

/// One parameter in the inspector: its label, an editor, and an arrow that brings back the default. A value
/// the user changed is bold; one not changed follows the exemplar where the default scales with it.
class ParamRow : public QObject {
    Q_OBJECT

public:
    /// Adds the row's widgets at the end of `grid`. @param param must outlive the row.
    ParamRow(const Param& param, QGridLayout* grid, QWidget* parent, Mnemonics& mnemonics);

    const Param& param() const { return *m_param; }
    Value value() const;
    /// Whether the user's value differs from the default.
    bool changed() const { return m_chosen.has_value(); }
    void setValue(const Value& value);
    /// Takes the default for an exemplar whose shorter side is this long.
    void setExemplarSide(int side);
    void reset();
    /// Greys the row out while another parameter's value makes it idle.
    void setApplies(bool applies, const QString& reason);
    /// What the parameter does, its limits, default and symbol.
    QString helpText() const;

    QLabel* label() const { return m_label; }
    ValueEditor* editor() const { return m_editor; }
    QToolButton* resetButton() const { return m_reset; }

Q_SIGNALS:
    void edited();
    /// The mouse or the focus came to this row.
    void approached();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void choose(const Value& value);
    void show();
    QString defaultText() const;

    const Param* m_param;
    QLabel* m_label;
    ValueEditor* m_editor;
    QToolButton* m_reset;
    Value m_default;
    std::optional<Value> m_chosen;
    int m_side = 0;
};

} // namespace texloom::ui
