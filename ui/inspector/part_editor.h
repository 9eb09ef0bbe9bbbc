#pragma once

#include "core/image/size.h"

#include <QWidget>

#include <array>
#include <optional>

class QCheckBox;
class QSpinBox;

namespace texloom::ui {

/// Whether all of an output is made or only a part of it, and which.
class PartEditor : public QWidget {
    Q_OBJECT

public:
    explicit PartEditor(QWidget* parent = nullptr);

    /// The part to make; none if it is all.
    std::optional<Region> part() const;
    void setPart(const std::optional<Region>& part);
    /// The size of the whole: where a part is first asked for, its middle.
    void setWhole(Size whole);

Q_SIGNALS:
    void edited();

private:
    Size m_whole;
    QCheckBox* m_only;
    QWidget* m_numbers;
    std::array<QSpinBox*, 4> m_fields{}; ///< left, top, width, height
    bool m_chosen = false;
};

} // namespace texloom::ui
