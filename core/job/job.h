#pragma once

#include "core/base/message.h"
#include "core/job/job_context.h"

#include <atomic>
#include <functional>
#include <memory>
#include <thread>
#include <utility>
#include <variant>

namespace texloom {

/// Why a job gave no result, as one sentence for the user.
struct Failure {
    Message message;
    bool usage = false; ///< whether what was asked for was wrong, rather than what went on
};

/// How a job ended: with its result, cancelled, or failed. Exactly one of the three.
template <class R> using Outcome = std::variant<R, Cancelled, Failure>;

/// The part of Job that does not depend on the result's type.
class JobRunner {
public:
    JobRunner(const JobRunner&) = delete;
    JobRunner& operator=(const JobRunner&) = delete;

    /// Asks the job to end; returns at once.
    void cancel() { m_thread.request_stop(); }
    /// Asks the job to end with what it has as soon as that can be shown; returns at once. Work that knows no
    /// partial results (see JobContext::preview()) goes on to its end.
    void stopAndKeep() { m_keepWanted = true; }
    /// Whether the outcome is there.
    bool finished() const { return m_finished; }
    /// What the job lets others see of itself.
    JobMonitor& monitor() { return *m_monitor; }

protected:
    JobRunner() = default;
    ~JobRunner() = default;

    /// Runs `work` on a thread of its own; `cancelled` and `failed` store how it ended if it threw.
    void start(const JobOptions& options, std::function<void(JobContext&)> work,
               std::function<void()> cancelled, std::function<void(Failure)> failed,
               std::function<void()> onFinished);
    void join();

private:
    std::unique_ptr<JobMonitor> m_monitor = std::make_unique<JobMonitor>();
    std::atomic<bool> m_finished = false;
    std::atomic<bool> m_keepWanted = false;
    std::jthread m_thread;
};

/// One piece of work on a thread of its own. Destroying it cancels and joins; it ends in a value.
template <class R> class Job : public JobRunner {
public:
    using Work = std::function<R(JobContext&)>;

    /// Starts at once. @param onFinished called on the worker's thread when the outcome is there.
    Job(const JobOptions& options, Work work, std::function<void()> onFinished = {}) {
        start(
            options, [this, work = std::move(work)](JobContext& context) { m_outcome = work(context); },
            [this] { m_outcome = Cancelled{}; }, [this](const Failure& failure) { m_outcome = failure; },
            std::move(onFinished));
    }
    ~Job() {
        cancel();
        join();
    }

    /// Waits for the end and hands the outcome over, once.
    Outcome<R> take() {
        join();
        return std::move(m_outcome);
    }

private:
    Outcome<R> m_outcome = Cancelled{};
};

} // namespace texloom
