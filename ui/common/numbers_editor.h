#pragma once

#include "ui/common/value_editor.h"

#include <vector>

class QSpinBox;

namespace texloom::ui {

/// Edits a parameter of several numbers (an area, a size, points) as pairs of whole pixels. The spin boxes
/// have the parameter's name and their number as object names: "crop-0".
class NumbersEditor : public ValueEditor {
    Q_OBJECT

public:
    explicit NumbersEditor(const Param& param, QWidget* parent);

    Value value() const override { return m_value; }
    void setValue(const Value& value) override;

private:
    std::vector<QString> pairTitles() const;
    void showNumbers();
    void take(std::size_t index, int number);

    const Param& m_param;
    Value m_value;
    std::vector<QSpinBox*> m_numbers;
};

} // namespace texloom::ui
