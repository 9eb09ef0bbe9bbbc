#pragma once

#include "core/session/run/checkpoint_file.h"

#include <QString>

#include <memory>
#include <mutex>
#include <optional>

class QLockFile;

namespace texloom::ui {

/// The last checkpoint of one run, as a file that outlives a crash: written each time the method offers one,
/// in place of the one before, locked as long as this program lives, and gone with this object, since the run
/// then has ended.
class RunCheckpoint {
public:
    /// Of a run that begins: a file of its own in `folder`, both made with the first checkpoint.
    explicit RunCheckpoint(const QString& folder);
    /// Of a run that goes on from what is in `file`.
    RunCheckpoint(QString file, std::shared_ptr<const Checkpoint> resumed);
    /// Removes the file unless it was to be left.
    ~RunCheckpoint();
    RunCheckpoint(const RunCheckpoint&) = delete;
    RunCheckpoint& operator=(const RunCheckpoint&) = delete;

    /// What a run of this recipe is to be started with; it must not outlive this object.
    Checkpoints forRun(const Recipe& recipe);
    /// The file stays when this object goes, so that the run can go on another time.
    void leave() { m_left = true; }
    /// Why the last checkpoint could not be written, told once until that succeeds again; empty if it could.
    QString takeProblem();

private:
    void write(const Recipe& recipe, const Checkpoint& checkpoint);
    void lock();

    QString m_file;
    std::shared_ptr<const Checkpoint> m_resumed;
    std::unique_ptr<QLockFile> m_lock;
    bool m_left = false;
    std::mutex m_mutex; ///< of what follows: checkpoints are written on the run's thread
    QString m_problem;
    bool m_told = false;
};

/// A run whose program ended before it did, with its last checkpoint.
struct BrokenRun {
    QString file;
    QString label;       ///< "Image quilting · seed 1 · 512 × 512"; empty if the file does not tell
    double fraction = 0; ///< how far it had come
    std::optional<Recipe> recipe; ///< none if the file does not tell, or what the run learned from is gone
    std::optional<RunPlan> plan;  ///< with which it can go on; none if it cannot
    std::shared_ptr<const Checkpoint> checkpoint;
    QString refusal; ///< why it cannot go on, as a sentence
};

/// The newest run in `folder` that is not under way in another program; none if there is none. Reads its
/// exemplars: called on a worker.
std::optional<BrokenRun> newestBrokenRun(const QString& folder);

/// Gives a broken run up for good.
void discardBrokenRun(const QString& file);

} // namespace texloom::ui
