#pragma once

#include "ui/runs/run_checkpoint.h"

#include <QObject>
#include <QString>

class QMessageBox;
class QWidget;

namespace texloom::ui {

class RunDesk;

/// Offers to go on with runs that a crash broke off, one after the other, from their last checkpoints. Of one
/// that cannot go on it says why, and its settings can still be had.
class RunRecovery : public QObject {
    Q_OBJECT

public:
    /// @param desk on which runs go on. @param window that dialogs belong to.
    RunRecovery(RunDesk* desk, QWidget* window);

    /// Looks through the folder in the background and asks about the newest run, once no other question is
    /// open.
    void offer(const QString& folder);

Q_SIGNALS:
    /// A run goes on.
    void resumed(const texloom::Recipe& recipe);
    /// The settings of a run that cannot go on are to be taken over.
    void restoreWanted(const texloom::Recipe& recipe);
    /// The folder could not be looked through.
    void failed(const QString& sentence);

private:
    void askWhenQuiet(const BrokenRun& run);
    void ask(const BrokenRun& run);
    QMessageBox* makeBox(const BrokenRun& run);
    void goOn(const BrokenRun& run);

    RunDesk* m_desk;
    QWidget* m_window;
    QString m_folder;
};

} // namespace texloom::ui
