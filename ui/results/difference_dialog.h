#pragma once

#include "core/session/results/result_store.h"

#include <QDialog>

namespace texloom::ui {

/// A table of the settings in which two results differ.
class DifferenceDialog : public QDialog {
    Q_OBJECT

public:
    DifferenceDialog(const ResultEntry& first, const ResultEntry& second, QWidget* parent = nullptr);
};

} // namespace texloom::ui
