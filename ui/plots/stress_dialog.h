#pragma once

#include "core/session/run/stress.h"
#include "ui/jobs/task.h"

#include <QDialog>

#include <vector>

class QHBoxLayout;
class QLabel;
class QPushButton;
class QScrollArea;
class QSpinBox;

namespace texloom::ui {

class Plot;
class TaskBar;

/// A texture of the texture of the texture: what a method loses in each round shows sooner than in one. The
/// rounds stand side by side over a plot of how far each is from the exemplar; none of them goes to the
/// results.
class StressDialog : public QDialog {
    Q_OBJECT

public:
    /// @param input the first round.
    explicit StressDialog(RunInput input, QWidget* parent = nullptr);

    /// Begins anew with the number of rounds as it stands.
    void start();
    bool running() const { return m_task.running(); }
    Plot* plot() const { return m_plot; }
    QString message() const;

private:
    void next();
    void take(const StressRound& round);
    void stop(const QString& why);
    void showDistances();

    RunInput m_first, m_input;
    QSpinBox* m_count;
    QPushButton* m_start;
    QScrollArea* m_scroll;
    QHBoxLayout* m_row = nullptr;
    Plot* m_plot;
    QLabel* m_message;
    TaskBar* m_bar;
    std::vector<TextureDistance> m_distances; ///< of the rounds that are there
    Task<StressRound> m_task;
};

} // namespace texloom::ui
