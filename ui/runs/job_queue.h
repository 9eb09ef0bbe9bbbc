#pragma once

#include "ui/runs/run_controller.h"

#include <QObject>
#include <QString>

#include <deque>
#include <memory>
#include <optional>
#include <vector>

namespace texloom::ui {

/// A run that waits, is under way, or failed. Its settings are those of the moment at which it was queued.
struct QueuedJob {
    enum class State { Waiting, Running, Failed };

    int id = 0;
    RunPlan plan;
    bool quick = false; ///< a preview at a small size
    bool shown = false; ///< asked for with Run or Quick: its pictures are shown as it goes
    QString label;
    State state = State::Waiting;
    RunProgress progress;           ///< while it is under way
    std::optional<double> expected; ///< seconds that it should take, if earlier runs tell
    QString problem;                ///< why it failed
    /// What it leaves behind in a crash; null before it begins, unless it goes on from there, and for
    /// previews.
    std::shared_ptr<RunCheckpoint> checkpoint = nullptr;
};

/// The runs that are to be made, one after the other. It decides which comes next and tells how each goes;
/// the RunController does one at a time.
class JobQueue : public QObject {
    Q_OBJECT

public:
    /// Where a new run goes: before all that wait but those asked for with Run, or behind them.
    enum class Place { Next, Last };

    /// @param controller used by this queue alone.
    explicit JobQueue(RunController* controller, QObject* parent = nullptr);

    /// Adds a run. A quick preview under way gives way to one that is placed next. @return its id.
    int add(RunPlan plan, bool quick, bool shown, Place place, std::optional<double> expected = {});
    /// Adds a run that goes on from a checkpoint, shown, before all that wait but those asked for with Run.
    /// @return its id.
    int resume(RunPlan plan, std::shared_ptr<RunCheckpoint> checkpoint);
    /// The one under way, if there is one, then those that wait in their order, then those that failed.
    const std::deque<QueuedJob>& jobs() const { return m_jobs; }
    const QueuedJob* find(int id) const;
    /// The run under way; null if there is none.
    const QueuedJob* current() const;
    int waiting() const;
    /// The id that the next run added will have.
    int nextId() const { return m_lastId + 1; }

    /// Takes a run off the list; one under way ends and leaves nothing.
    void cancel(int id);
    /// Ends a run that is under way with what it has; see RunController::stopAndKeep().
    void stopAndKeep(int id);
    /// Cancels all that wait and forgets those that failed.
    void clear();
    /// Moves a waiting run up (−1) or down (1) among those that wait.
    void move(int id, int step);
    bool paused() const { return m_paused; }
    /// While paused, no waiting run is begun but those asked for with Run; the one under way goes on.
    void setPaused(bool paused);
    /// The most threads that a run may use; 0 for as many as it asks for.
    void setThreads(int threads) { m_threads = threads; }
    /// Where runs that begin from now on leave their checkpoints; nowhere if empty.
    void setCheckpointFolder(const QString& folder) { m_checkpoints = folder; }
    /// The checkpoints of all runs stay, so that those can go on another time.
    void leaveCheckpoints();

Q_SIGNALS:
    /// Runs were added, removed, moved, begun or ended.
    void changed();
    void pausedChanged(bool paused);
    void started(int id);
    void progressed(int id);
    void previewed(int id, const texloom::ui::RunPictures& pictures);
    void curvesGrew(int id, const std::vector<texloom::Curve>& curves);
    void finished(const texloom::ui::QueuedJob& job, std::shared_ptr<const texloom::Result> result,
                  const texloom::ui::RunPictures& pictures);
    /// Cancelled at this share of its work.
    void cancelled(const texloom::ui::QueuedJob& job, double fraction);
    void failed(const texloom::ui::QueuedJob& job);

private:
    void connectController();
    void startSoon();
    void startNext();
    int insert(QueuedJob job, Place place);
    void begin(QueuedJob& job);
    void fail(QueuedJob job, const QString& sentence);
    QueuedJob takeCurrent();
    std::deque<QueuedJob>::iterator firstWaiting();
    std::deque<QueuedJob>::iterator endOfWaiting();

    RunController* m_controller;
    std::deque<QueuedJob> m_jobs;
    int m_lastId = 0;
    int m_shown = 0;   ///< the run whose pictures the controller makes
    int m_givenUp = 0; ///< the run that was stopped for another: nobody is told
    int m_threads = 0;
    bool m_paused = false;
    QString m_checkpoints; ///< their folder
};

} // namespace texloom::ui
