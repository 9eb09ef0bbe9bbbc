#include "ui/runs/job_queue.h"

#include "ui/common/background.h"

#include <algorithm>
#include <utility>

namespace texloom::ui {

JobQueue::JobQueue(RunController* controller, QObject* parent) : QObject(parent), m_controller(controller) {
    connectController();
}

void JobQueue::connectController() {
    connect(m_controller, &RunController::progressed, this, [this](const RunProgress& progress) {
        if (m_jobs.empty() || m_jobs.front().state != QueuedJob::State::Running)
            return;
        m_jobs.front().progress = progress;
        Q_EMIT progressed(m_jobs.front().id);
    });
    connect(m_controller, &RunController::previewed, this,
            [this](const RunPictures& pictures) { Q_EMIT previewed(m_shown, pictures); });
    connect(m_controller, &RunController::curvesGrew, this,
            [this](const std::vector<Curve>& curves) { Q_EMIT curvesGrew(m_shown, curves); });
    connect(m_controller, &RunController::finished, this,
            [this](const std::shared_ptr<const Result>& result, const RunPictures& pictures) {
                const QueuedJob job = takeCurrent();
                Q_EMIT finished(job, result, pictures);
                Q_EMIT changed();
                startSoon();
            });
    connect(m_controller, &RunController::cancelled, this, [this](double fraction) {
        const QueuedJob job = takeCurrent();
        if (job.id != m_givenUp)
            Q_EMIT cancelled(job, fraction);
        Q_EMIT changed();
        startSoon();
    });
    connect(m_controller, &RunController::failed, this, [this](const QString& sentence) {
        fail(takeCurrent(), sentence);
        startSoon();
    });
}

int JobQueue::add(RunPlan plan, bool quick, bool shown, Place place, std::optional<double> expected) {
    QueuedJob job;
    job.label = labelOf(plan);
    job.plan = std::move(plan);
    job.quick = quick;
    job.shown = shown;
    job.expected = expected;
    return insert(std::move(job), place);
}

int JobQueue::resume(RunPlan plan, std::shared_ptr<RunCheckpoint> checkpoint) {
    QueuedJob job;
    job.label = labelOf(plan);
    job.plan = std::move(plan);
    job.shown = true;
    job.checkpoint = std::move(checkpoint);
    return insert(std::move(job), Place::Next);
}

int JobQueue::insert(QueuedJob job, Place place) {
    job.id = ++m_lastId;
    const bool next = place == Place::Next;
    const int id = job.id;
    const auto end = endOfWaiting();
    const auto behindShown =
        std::find_if(firstWaiting(), end, [](const QueuedJob& other) { return !other.shown; });
    m_jobs.insert(next ? behindShown : end, std::move(job));
    if (const QueuedJob* under = current(); next && under != nullptr && under->quick && under->shown) {
        m_givenUp = under->id;
        m_controller->cancel();
    }
    Q_EMIT changed();
    startNext();
    return id;
}

const QueuedJob* JobQueue::find(int id) const {
    const auto found =
        std::find_if(m_jobs.begin(), m_jobs.end(), [id](const QueuedJob& job) { return job.id == id; });
    return found == m_jobs.end() ? nullptr : &*found;
}

const QueuedJob* JobQueue::current() const {
    const bool running = !m_jobs.empty() && m_jobs.front().state == QueuedJob::State::Running;
    return running ? &m_jobs.front() : nullptr;
}

std::deque<QueuedJob>::iterator JobQueue::firstWaiting() {
    return m_jobs.begin() + (current() != nullptr ? 1 : 0);
}

std::deque<QueuedJob>::iterator JobQueue::endOfWaiting() {
    return std::find_if(firstWaiting(), m_jobs.end(),
                        [](const QueuedJob& job) { return job.state != QueuedJob::State::Waiting; });
}

int JobQueue::waiting() const {
    return static_cast<int>(std::count_if(m_jobs.begin(), m_jobs.end(), [](const QueuedJob& job) {
        return job.state == QueuedJob::State::Waiting;
    }));
}

void JobQueue::cancel(int id) {
    const auto found =
        std::find_if(m_jobs.begin(), m_jobs.end(), [id](const QueuedJob& job) { return job.id == id; });
    if (found == m_jobs.end())
        return;
    if (found->state == QueuedJob::State::Running)
        return m_controller->cancel();
    const QueuedJob job = std::move(*found);
    m_jobs.erase(found);
    if (job.state == QueuedJob::State::Waiting)
        Q_EMIT cancelled(job, 0);
    Q_EMIT changed();
}

void JobQueue::stopAndKeep(int id) {
    if (const QueuedJob* under = current(); under != nullptr && under->id == id)
        m_controller->stopAndKeep();
}

void JobQueue::leaveCheckpoints() {
    for (const QueuedJob& job : m_jobs)
        if (job.checkpoint)
            job.checkpoint->leave();
}

void JobQueue::clear() {
    const std::vector<QueuedJob> gone(firstWaiting(), m_jobs.end());
    m_jobs.erase(firstWaiting(), m_jobs.end());
    for (const QueuedJob& job : gone)
        if (job.state == QueuedJob::State::Waiting)
            Q_EMIT cancelled(job, 0);
    Q_EMIT changed();
}

void JobQueue::move(int id, int step) {
    const auto first = firstWaiting();
    const auto end = endOfWaiting();
    const auto found = std::find_if(first, end, [id](const QueuedJob& job) { return job.id == id; });
    if (found == end)
        return;
    const auto to = found - first + step;
    if (to < 0 || to >= end - first)
        return;
    std::swap(*found, *(first + to));
    Q_EMIT changed();
}

void JobQueue::setPaused(bool paused) {
    if (m_paused == paused)
        return;
    m_paused = paused;
    Q_EMIT pausedChanged(paused);
    Q_EMIT changed();
    startNext();
}

void JobQueue::startSoon() {
    QMetaObject::invokeMethod(this, &JobQueue::startNext, Qt::QueuedConnection);
}

void JobQueue::startNext() {
    if (m_controller->running() || current() != nullptr)
        return;
    const auto next = firstWaiting();
    if (next == endOfWaiting() || (m_paused && !next->shown))
        return;
    begin(*next);
}

void JobQueue::begin(QueuedJob& job) {
    try {
        checkMemory(job.plan);
    } catch (const std::exception& error) {
        QueuedJob refused = std::move(job);
        m_jobs.pop_front();
        if (refused.checkpoint)
            refused.checkpoint->leave(); // it was not begun, and may go on when there is room
        fail(std::move(refused), sentence(error));
        return startSoon();
    }
    job.state = QueuedJob::State::Running;
    m_shown = job.id;
    RunPlan plan = job.plan;
    if (m_threads > 0)
        plan.threads = std::min(plan.threads, m_threads);
    if (!job.checkpoint && !job.quick && !m_checkpoints.isEmpty())
        job.checkpoint = std::make_shared<RunCheckpoint>(m_checkpoints);
    m_controller->start(std::move(plan), job.quick, job.checkpoint);
    Q_EMIT started(m_shown);
    Q_EMIT changed();
}

void JobQueue::fail(QueuedJob job, const QString& sentence) {
    job.state = QueuedJob::State::Failed;
    job.problem = sentence;
    job.checkpoint.reset();
    m_jobs.push_back(std::move(job));
    Q_EMIT failed(m_jobs.back());
    Q_EMIT changed();
}

QueuedJob JobQueue::takeCurrent() {
    QueuedJob job = std::move(m_jobs.front());
    m_jobs.pop_front();
    return job;
}

} // namespace texloom::ui
