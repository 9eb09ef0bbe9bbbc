#include "ui/runs/run_controller.h"

#include "ui/common/background.h"
#include "ui/common/text.h"

#include <chrono>
#include <utility>

namespace texloom::ui {

namespace {

constexpr std::chrono::milliseconds kPollPause{60};
/// Before this share or time of the work, the time left is only guessed at and not told.
constexpr double kFirstShare = 0.03;
constexpr double kFirstSeconds = 0.5;

std::optional<double> secondsLeft(double fraction, double seconds) {
    if (fraction < kFirstShare || seconds < kFirstSeconds)
        return {};
    return seconds * (1 - fraction) / fraction;
}

} // namespace

QString labelOf(const RunPlan& plan) {
    return RunController::tr("%1 · seed %2 · %3")
        .arg(titleOf(plan))
        .arg(plan.request.seed)
        .arg(sizeText(plan.request.size));
}

RunController::RunController(QObject* parent) : QObject(parent) {
    m_timer.setInterval(kPollPause);
    connect(&m_timer, &QTimer::timeout, this, &RunController::poll);
}

RunController::~RunController() {
    halt();
}

void RunController::halt() {
    ++m_run;
    end();
}

void RunController::stop() {
    if (m_job)
        m_job->cancel();
}

void RunController::start(RunPlan plan, bool quick) {
    m_quick = quick;
    m_label = labelOf(plan);
    m_size = plan.request.part().size;
    const int run = ++m_run;
    m_job = startRun(std::move(plan), true, [this, run] {
        QMetaObject::invokeMethod(
            this, [this, run] { takeOutcome(run); }, Qt::QueuedConnection);
    });
    m_timer.start();
    Q_EMIT started();
    poll();
}

void RunController::poll() {
    if (!m_job)
        return;
    const JobMonitor& monitor = m_job->monitor();
    const double fraction = monitor.progress();
    const double seconds = monitor.seconds();
    Q_EMIT progressed({fraction, translated(monitor.stage()), seconds, secondsLeft(fraction, seconds)});
    if (!m_drawing)
        showPreview();
}

void RunController::showPreview() {
    std::optional<Preview> preview = m_job->monitor().takePreview();
    if (!preview)
        return;
    m_drawing = true;
    const auto shared = std::make_shared<Preview>(std::move(*preview));
    inBackground(
        this, [shared, size = m_size] { return picturesOf(std::move(*shared), size); },
        [this, run = m_run](const RunPictures& pictures) {
            m_drawing = false;
            if (run == m_run)
                Q_EMIT previewed(pictures);
        },
        [this](const QString&) { m_drawing = false; });
}

void RunController::takeOutcome(int run) {
    if (run != m_run || !m_job)
        return;
    const double fraction = m_job->monitor().progress();
    Outcome<Result> outcome = m_job->take();
    m_timer.stop();
    if (std::holds_alternative<Cancelled>(outcome)) {
        showPreview();
        end();
        Q_EMIT stopped(fraction);
    } else if (const auto* failure = std::get_if<Failure>(&outcome)) {
        failWith(translated(failure->message));
    } else {
        finishWith(std::make_shared<const Result>(std::get<Result>(std::move(outcome))));
    }
}

void RunController::finishWith(const std::shared_ptr<const Result>& result) {
    ++m_run;
    Q_EMIT progressed({1, tr("Preparing the pictures"), result->seconds, {}});
    inBackground(
        this, [result] { return picturesOf(result); },
        [this, result](const RunPictures& pictures) {
            end();
            Q_EMIT finished(result, pictures);
        },
        [this](const QString& why) { failWith(why); });
}

void RunController::failWith(const QString& why) {
    end();
    Q_EMIT failed(why);
}

void RunController::end() {
    m_timer.stop();
    m_job.reset();
}

} // namespace texloom::ui
