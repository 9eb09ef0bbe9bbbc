#pragma once

#include "ui/runs/job_queue.h"
#include "ui/runs/result_history.h"

#include <QObject>

#include <memory>
#include <optional>
#include <string>

namespace texloom::ui {

/// What the settings as they stand can be run for.
struct Outlook {
    std::optional<Estimate> estimate; ///< of the run; none if it cannot start
    std::optional<double> seconds;    ///< that it should take, if earlier runs tell
    QString refusal;                  ///< why it cannot start
    QString quickRefusal;             ///< why its preview cannot
    bool quick = false;               ///< whether its preview can start
};

/// A finished run as it is shown.
struct ShownResult {
    std::shared_ptr<const Result> result;
    RunPictures pictures;
    bool quick = false; ///< a preview at a small size
    std::string key;    ///< in the history
};

/// All of a window's runs, from what they are asked for to their place in the history, and the one that is
/// shown. It plans them, queues them, keeps what they make and tells how they go; panels and viewers listen.
/// One run is shown at a time: a finished result, or one under way as it goes.
class RunDesk : public QObject {
    Q_OBJECT

public:
    /// @param folder of the history; made when the first result comes.
    explicit RunDesk(const QString& folder, QObject* parent = nullptr);

    const RunController* controller() const { return m_controller; }
    JobQueue* queue() const { return m_queue; }
    ResultHistory* history() const { return m_history; }

    /// Finds out in the background what a run with these settings would be, and its preview; outlookChanged()
    /// follows. The last call counts, and is answered again after every run that ends.
    void lookAhead(const RunInput& input);
    /// There is nothing that could be run.
    void lookAway();
    bool canRun() const { return m_outlook.estimate && !m_adding; }
    bool canQuick() const { return m_outlook.quick && !m_adding; }

    /// Plans a run in the background and puts it next in the queue; its pictures are shown as it goes. Does
    /// nothing while another is being planned. @param quick as a preview.
    void run(const RunInput& input, bool quick);
    /// The same at the queue's end, without its pictures being shown.
    void enqueue(const RunInput& input);
    /// Goes on with a run that a crash broke off; it must have a plan.
    void resume(BrokenRun run);
    bool running() const { return m_controller->running(); }
    /// Asks the run under way to end with what it has, which becomes a result of the history.
    void stopAndKeep() { m_controller->stopAndKeep(); }
    /// Asks the run under way to end; nothing of it is kept.
    void cancel() { m_controller->cancel(); }
    /// Gives up all that waits and asks the run under way to end, but leaves its checkpoint for another time.
    void breakOff();
    /// The same at once: waits for the end, and nothing can be run any more.
    void halt();
    /// Where runs leave checkpoints, from which they can go on after a crash; nowhere before it is set.
    void setCheckpointFolder(const QString& folder) { m_queue->setCheckpointFolder(folder); }

    /// Shows the pictures of a queued run as it goes, and its result.
    void watch(int id);
    /// Shows a result of the history; shown() follows once it is read.
    void show(const std::string& key);
    /// Goes back to the result that was shown last; there must be one.
    void showLast();
    /// Shows nothing any more, as before the first run; emptied() follows.
    void clear();
    /// The finished result that was shown last; null if there is none.
    const std::shared_ptr<const Result>& result() const { return m_last.result; }
    const ShownResult& last() const { return m_last; }
    /// Whether it is on show, rather than a run under way.
    bool resultShown() const { return m_resultShown; }
    /// The run whose pictures are on show, finished or not; none before the first.
    const std::optional<RunPlan>& shownPlan() const { return m_shownPlan; }

Q_SIGNALS:
    /// What can be started, stopped or exported may be different now.
    void changed();
    void outlookChanged(const texloom::ui::Outlook& outlook);
    /// From now on the pictures of this run are shown.
    void watching(const texloom::ui::QueuedJob& job);
    /// A partial picture of the run that is shown.
    void previewed(const texloom::ui::RunPictures& pictures);
    /// The curves of the run that is shown, each time they have grown.
    void curvesGrew(const std::vector<texloom::Curve>& curves);
    void shown(const texloom::ui::ShownResult& result);
    /// The run that was shown was cancelled at this share of its work; what was shown before it is again.
    void cancelled(const texloom::ui::QueuedJob& job, double fraction);
    /// Nothing is shown any more, and there is no result to go back to.
    void emptied();
    /// What was asked for goes into the queue.
    void accepted();
    /// A run that was asked for with run() ended while another is shown.
    void endedUnseen(const texloom::ui::QueuedJob& job, const std::string& key);
    /// A run ended and is this result of the history.
    void kept(const texloom::ui::QueuedJob& job, const std::string& key,
              const texloom::ui::RunPictures& pictures);
    /// What was asked for cannot be done; the sentence says why.
    void refused(const QString& sentence);
    /// For the log: what happened.
    void noted(const QString& line);

private:
    void connectQueue();
    void connectNotes();
    void add(const RunInput& input, bool quick, bool next);
    void refuse(const QString& sentence);
    void keep(const QueuedJob& job, const std::shared_ptr<const Result>& result, const RunPictures& pictures);
    void takeCancelled(const QueuedJob& job, double fraction);
    void takeFailed(const QueuedJob& job);
    void showFormer();
    void lookAgain();
    void setOutlook(const Outlook& outlook);
    void setResultShown(bool shown);
    void show(ShownResult result);

    RunController* m_controller;
    JobQueue* m_queue;
    ResultHistory* m_history;
    std::optional<RunInput> m_input; ///< that the outlook is of
    Outlook m_outlook;
    int m_lookRequest = 0;
    int m_showRequest = 0;
    bool m_adding = false;
    int m_live = 0; ///< the queue's id of the run whose pictures are shown as it goes
    ShownResult m_last;
    bool m_resultShown = false;
    std::optional<RunPlan> m_shownPlan;
};

} // namespace texloom::ui
