#pragma once

#include "core/base/param.h"

#include <QWidget>

namespace texloom::ui {

/// Edits one value of a parameter's type.
class ValueEditor : public QWidget {
    Q_OBJECT

public:
    using QWidget::QWidget;

    virtual Value value() const = 0;
    /// Shows a value without saying that it was edited.
    virtual void setValue(const Value& value) = 0;
    /// Lets no number be larger; only of editors of one number.
    virtual void setLargest(double /*largest*/) {}

Q_SIGNALS:
    /// The user changed the value.
    void edited();
};

} // namespace texloom::ui
