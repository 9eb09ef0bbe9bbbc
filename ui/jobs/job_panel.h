#pragma once

#include "ui/runs/job_queue.h"

#include <QWidget>

class QAction;
class QLabel;
class QSpinBox;
class QToolButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace texloom::ui {

/// The Jobs dock: the run under way with its progress and time left, those that wait in their order, and
/// those that failed with the reason.
class JobPanel : public QWidget {
    Q_OBJECT

public:
    explicit JobPanel(JobQueue* queue, QWidget* parent = nullptr);

    /// The id of the chosen run; 0 if none is chosen.
    int selected() const;

Q_SIGNALS:
    /// The pictures of this run are to be shown as it goes.
    void watchWanted(int id);

private:
    QAction* makeAction(const char* name, const QString& text, const QString& help, const char* iconName);
    QWidget* makeBar();
    QWidget* makeThreads();
    void fill();
    void showProgress(int id);
    void updateActions();

    JobQueue* m_queue;
    QTreeWidget* m_list;
    QLabel* m_empty;
    QSpinBox* m_threads;
    QAction* m_up;
    QAction* m_down;
    QAction* m_stop;
    QAction* m_cancel;
    QAction* m_pause;
    QAction* m_clear;
};

} // namespace texloom::ui
