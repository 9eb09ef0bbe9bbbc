#pragma once

#include "core/job/job.h"
#include "ui/common/background.h"
#include "ui/common/text.h"

#include <memory>
#include <utility>
#include <variant>

namespace texloom::ui {

/// One piece of background work that can be called off: a core job whose outcome comes to the GUI thread.
/// The GUI thread never waits for it, not even for its end.
template <class R> class Task {
public:
    Task() = default;
    ~Task() { cancel(); }
    Task(const Task&) = delete;
    Task& operator=(const Task&) = delete;

    /// Starts `work` on a thread of its own; what was under way before is called off. Then `done` is called
    /// on the GUI thread with the result, or `failed` with a sentence; neither after cancel().
    template <class Done, class Failed>
    void start(const JobOptions& options, typename Job<R>::Work work, Done done, Failed failed) {
        cancel();
        m_running = std::make_shared<Running>();
        const std::weak_ptr<Running> weak = m_running;
        const auto deliver = [this, weak, done = std::move(done), failed = std::move(failed)]() mutable {
            const std::shared_ptr<Running> ended = weak.lock();
            if (!ended || ended->calledOff)
                return;
            Outcome<R> outcome = ended->job->take();
            m_running.reset();
            if (R* result = std::get_if<R>(&outcome))
                done(std::move(*result));
            else if (const auto* failure = std::get_if<Failure>(&outcome))
                failed(translated(failure->message));
        };
        m_running->job = std::make_unique<Job<R>>(options, std::move(work), [deliver] {
            QMetaObject::invokeMethod(QCoreApplication::instance(), deliver, Qt::QueuedConnection);
        });
    }

    /// Calls the work off, if there is any, and forgets it.
    void cancel() {
        if (!m_running)
            return;
        m_running->calledOff = true;
        m_running->job->cancel();
        workers().start([last = std::move(m_running)]() mutable { last.reset(); });
        m_running.reset();
    }

    bool running() const { return m_running != nullptr; }
    /// From 0 to 1; 0 if nothing is under way.
    double progress() const { return m_running ? m_running->job->monitor().progress() : 0; }

private:
    struct Running {
        std::unique_ptr<Job<R>> job;
        bool calledOff = false;
    };

    std::shared_ptr<Running> m_running;
};

} // namespace texloom::ui
