#pragma once

#include "core/session/results/result_store.h"

#include <QDialog>

#include <cstdint>

class QDoubleSpinBox;

namespace texloom::ui {

class ResultHistory;

/// Gives a history the limits that were chosen last.
void restoreLimits(ResultHistory& history);
/// Asks for the limits of a history, and keeps them for the next time.
void chooseLimits(ResultHistory& history, QWidget* parent);

/// How much memory and how much of the disk results may take, how much they do, and where they are.
class LimitsDialog : public QDialog {
    Q_OBJECT

public:
    LimitsDialog(const ResultStore& store, const QString& folder, QWidget* parent = nullptr);

    std::uint64_t memory() const;
    std::uint64_t disk() const;

private:
    QDoubleSpinBox* makeSize(const QString& name, double bytes, const QString& help);

    QDoubleSpinBox* m_memory;
    QDoubleSpinBox* m_disk;
};

} // namespace texloom::ui
