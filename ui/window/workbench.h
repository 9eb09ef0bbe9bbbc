#pragma once

#include "ui/compare/compare_bar.h"
#include "ui/compare/compare_item.h"
#include "ui/results/result_panel.h"
#include "ui/runs/job_queue.h"
#include "ui/runs/result_history.h"

#include <QObject>

#include <set>
#include <string>
#include <vector>

class QAction;
class QMenu;

namespace texloom::ui {

class CompareView;
class GridRun;
class JobPanel;
class ResultView;
class LogPanel;
class MainWindow;

/// What is about more than one run: the queue, the history of results, the log, comparisons, and runs made
/// many at a time. It joins them to one another and to the window.
class Workbench : public QObject {
    Q_OBJECT

public:
    /// @param controller of the window's runs; from here on, the queue's.
    Workbench(RunController* controller, MainWindow* window);

    /// Puts the docks at the bottom, as tabs.
    void addDocks();
    /// Adds the tab for comparisons.
    void addPages(ResultView* tabs);
    QMenu* makeResultsMenu();
    QMenu* makeCompareMenu();
    QAction* tryAllAction() const { return m_tryAll; }
    QAction* trySomeAction() const { return m_trySome; }
    QAction* sweepAction() const { return m_sweep; }
    /// Whether the settings as they stand can be run, and whether there is an exemplar at all.
    void setCanRun(bool settings, bool exemplar);

    JobQueue* queue() const { return m_queue; }
    ResultHistory* history() const { return m_history; }
    ResultPanel* resultPanel() const { return m_results; }
    JobPanel* jobPanel() const { return m_jobs; }
    LogPanel* log() const { return m_log; }
    CompareView* compare() const { return m_compare; }

    /// Shows an earlier result in the window.
    void show(const std::string& key);
    /// Brings an earlier result's settings into the form.
    void restore(const std::string& key);
    /// Shows results side by side, in the order in which they were made.
    void compareResults(const std::vector<std::string>& keys, bool exemplar);
    /// Makes a preview with every method and its default settings, the quickest first.
    void tryAll();
    void trySome();
    void tryMethods(const std::vector<std::string>& ids, bool quick);

private:
    /// Results on their way into a comparison.
    struct Gathering;

    void connectCompare();
    void gather(const std::shared_ptr<Gathering>& gathering);
    void chooseMode(CompareMode mode);
    void startSweep();
    void writeContactSheet();
    void showCompare();
    std::set<int> exemplarsOf(const std::vector<std::string>& keys) const;
    std::vector<CompareItem> exemplarItems(const std::set<int>& ids) const;
    std::set<int> exemplarsShown() const;
    void showExemplars(const std::set<int>& ids);
    void listExemplars();
    void connectQueue();
    void connectResults();
    void keep(const QueuedJob& job, const std::shared_ptr<const Result>& result, const RunPictures& pictures);
    void showDifference(const std::string& first, const std::string& second);
    void setLimits();

    MainWindow* m_window;
    JobQueue* m_queue;
    ResultHistory* m_history;
    ResultActions m_resultActions;
    ResultPanel* m_results;
    JobPanel* m_jobs;
    LogPanel* m_log;
    CompareActions m_compareActions;
    CompareView* m_compare;
    GridRun* m_grid;
    QAction* m_tryAll;
    QAction* m_trySome;
    QAction* m_sweep;
    std::vector<std::string> m_compared; ///< results that were chosen to be compared
    ResultView* m_tabs = nullptr;
};

} // namespace texloom::ui
