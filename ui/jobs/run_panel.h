#pragma once

#include "core/methods/method.h"
#include "ui/jobs/run_controller.h"

#include <QWidget>

class QAction;
class QLabel;
class QProgressBar;

namespace texloom::ui {

/// Starts and stops runs, says beforehand what one will need or why it cannot be, and how it goes.
class RunPanel : public QWidget {
    Q_OBJECT

public:
    /// The actions' buttons, from left to right.
    RunPanel(QAction* run, QAction* quick, QAction* stop, QWidget* parent = nullptr);

    /// "About 2 s · 120 MiB".
    void setEstimate(const Estimate& estimate);
    /// Says why the run cannot start.
    void setRefusal(const QString& sentence);
    /// Says what is missing before there is anything to run.
    void setHint(const QString& text);
    /// The refusal shown; empty if the run can start.
    const QString& refusal() const { return m_refusal; }
    void setRunning(bool running);
    void showProgress(const RunProgress& progress);

protected:
    void changeEvent(QEvent* event) override;

private:
    void say(const QString& text, const QString& refusal);
    void colorNote();

    QLabel* m_note;
    QLabel* m_stage;
    QLabel* m_time;
    QProgressBar* m_bar;
    QString m_refusal;
};

} // namespace texloom::ui
