#include "core/job/job.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/job/freed_memory.h"

#include <exception>

namespace texloom {

void JobRunner::start(const JobOptions& options, std::function<void(JobContext&)> work,
                      std::function<void()> cancelled, std::function<void(Failure)> failed,
                      std::function<void()> onFinished) {
    keepFreedMemory();
    m_thread = std::jthread([=, this](const std::stop_token& stop) {
        try {
            JobContext context(
                options, [&stop] { return stop.stop_requested(); }, *m_monitor,
                [this] { return m_keepWanted.load(); });
            work(context);
            const std::lock_guard lock(m_monitor->m_mutex);
            m_monitor->m_progress = 1;
            if (!m_monitor->m_stages.empty())
                m_monitor->m_stages.back().seconds =
                    std::chrono::duration<double>(std::chrono::steady_clock::now() - m_monitor->m_stageStart)
                        .count();
        } catch (const Cancelled&) {
            cancelled();
        } catch (const StoppedEarly&) { // work that makes nothing of a part of itself
            cancelled();
        } catch (const std::exception& error) {
            failed({messageOf(error), dynamic_cast<const UsageError*>(&error) != nullptr});
        } catch (...) {
            failed({TR("The work ended for an unknown reason; try again."), false});
        }
        giveBackFreedMemory();
        m_finished = true;
        if (onFinished)
            onFinished();
    });
}

void JobRunner::join() {
    if (m_thread.joinable())
        m_thread.join();
}

} // namespace texloom
