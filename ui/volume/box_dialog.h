#pragma once

#include "core/volume/box.h"

#include <QDialog>

#include <array>

class QDialogButtonBox;
class QLabel;
class QSpinBox;

namespace texloom::ui {

/// Asks for a box of voxels, and says how large it is, or why it cannot be written.
class BoxDialog : public QDialog {
    Q_OBJECT

public:
    explicit BoxDialog(const Box& first, QWidget* parent = nullptr);

    Box box() const;

private:
    void judge();

    std::array<QSpinBox*, 3> m_from;
    std::array<QSpinBox*, 3> m_sides;
    QLabel* m_verdict;
    QDialogButtonBox* m_buttons;
};

} // namespace texloom::ui
