#pragma once

#include "core/methods/method.h"
#include "ui/runs/run_controller.h"

#include <QWidget>

#include <optional>

class QAction;
class QLabel;
class QProgressBar;
class QToolButton;

namespace texloom::ui {

/// Starts and stops runs, says beforehand what one will need or why it cannot be, and how it goes.
class RunPanel : public QWidget {
    Q_OBJECT

public:
    /// The actions that have buttons, from left to right.
    struct Buttons {
        QAction* run;
        QAction* queue;
        QAction* quick;
        QAction* stop;
        QAction* cancel;
    };

    explicit RunPanel(const Buttons& actions, QWidget* parent = nullptr);

    /// "Takes about 2 s · 120 MiB". @param seconds as earlier runs let expect; none if there were none.
    void setEstimate(const Estimate& estimate, std::optional<double> seconds);
    /// Says why the run cannot start.
    void setRefusal(const QString& sentence);
    /// Says what is missing before there is anything to run.
    void setHint(const QString& text);
    /// The refusal shown; empty if the run can start.
    const QString& refusal() const { return m_refusal; }
    /// @param waiting number of runs that wait.
    void setRunning(bool running, int waiting = 0);
    void showProgress(const RunProgress& progress);

protected:
    void changeEvent(QEvent* event) override;

private:
    QToolButton* makeIconButton(QAction* action, const QString& name);
    void say(const QString& text, const QString& refusal);
    void colorNote();

    QLabel* m_note;
    QLabel* m_stage;
    QLabel* m_time;
    QProgressBar* m_bar;
    QString m_refusal;
    int m_waiting = 0;
};

} // namespace texloom::ui
