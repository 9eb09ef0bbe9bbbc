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
/// Curves are told with each picture; this often where none comes.
constexpr qint64 kCurvePause = 500;

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

void RunController::cancel() {
    if (m_job)
        m_job->cancel();
}

void RunController::stopAndKeep() {
    if (!m_job || m_job->finished())
        return;
    m_job->stopAndKeep();
    m_keeping = true;
    if (!m_drawing)
        showPreview();
    if (!m_pictured)
        Q_EMIT pictureAwaited();
    tellProgress();
}

void RunController::start(RunPlan plan, bool quick, std::shared_ptr<RunCheckpoint> checkpoint) {
    m_quick = quick;
    m_pictured = m_keeping = false;
    m_drawn = 0;
    m_sinceDrawn.start();
    m_checkpoint = std::move(checkpoint);
    Checkpoints checkpoints = m_checkpoint ? m_checkpoint->forRun(plan.recipe) : Checkpoints{};
    m_label = labelOf(plan);
    m_size = plan.request.part().size;
    const int run = ++m_run;
    const auto ended = [this, run] {
        QMetaObject::invokeMethod(
            this, [this, run] { takeOutcome(run); }, Qt::QueuedConnection);
    };
    m_job = startRun(std::move(plan), true, ended, std::move(checkpoints));
    m_timer.start();
    Q_EMIT started();
    poll();
}

void RunController::poll() {
    if (!m_job)
        return;
    tellProgress();
    const bool pictured = !m_drawing && showPreview();
    if (pictured || m_sinceDrawn.elapsed() >= kCurvePause)
        showCurves();
    if (m_checkpoint)
        if (const QString why = m_checkpoint->takeProblem(); !why.isEmpty())
            Q_EMIT unprotected(
                tr("The run goes on, but a crash would lose it; make room on the disk. %1").arg(why));
}

void RunController::tellProgress() {
    const JobMonitor& monitor = m_job->monitor();
    const double fraction = monitor.progress();
    const double seconds = monitor.seconds();
    if (m_keeping)
        Q_EMIT progressed({fraction, tr("Stopping…"), seconds, {}});
    else
        Q_EMIT progressed({fraction, translated(monitor.stage()), seconds, secondsLeft(fraction, seconds)});
}

void RunController::showCurves() {
    m_sinceDrawn.restart();
    const std::vector<Curve> curves = m_job->monitor().curves();
    std::size_t values = 0;
    for (const Curve& curve : curves)
        values += curve.values.size();
    if (std::exchange(m_drawn, values) != values && values > 0)
        Q_EMIT curvesGrew(curves);
}

/// @return whether there was a new one.
bool RunController::showPreview() {
    std::optional<Preview> preview = m_job->monitor().takePreview();
    if (!preview)
        return false;
    m_drawing = m_pictured = true;
    const auto shared = std::make_shared<Preview>(std::move(*preview));
    inBackground(
        this, [shared, size = m_size] { return picturesOf(std::move(*shared), size); },
        [this, run = m_run](const RunPictures& pictures) {
            m_drawing = false;
            if (run == m_run)
                Q_EMIT previewed(pictures);
        },
        [this](const QString&) { m_drawing = false; });
    return true;
}

void RunController::takeOutcome(int run) {
    if (run != m_run || !m_job)
        return;
    const double fraction = m_job->monitor().progress();
    Outcome<Result> outcome = m_job->take();
    m_timer.stop();
    if (std::holds_alternative<Cancelled>(outcome)) {
        end();
        Q_EMIT cancelled(fraction);
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
    m_checkpoint.reset();
}

} // namespace texloom::ui
