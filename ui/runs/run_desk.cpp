#include "ui/runs/run_desk.h"

#include "core/base/text.h"
#include "ui/common/background.h"
#include "ui/common/text.h"
#include "ui/runs/quick_run.h"

#include <utility>

namespace texloom::ui {

namespace {

Outlook outlookOf(const RunInput& input, const std::vector<ResultEntry>& earlier) {
    Outlook outlook;
    try {
        const RunPlan plan = planRun(input);
        outlook.estimate = plan.estimate;
        outlook.seconds = expectedSeconds(plan, earlier);
    } catch (const std::exception& error) {
        outlook.refusal = sentence(error);
    }
    try {
        planRun(quickOf(input));
        outlook.quick = true;
    } catch (const std::exception& error) {
        outlook.quickRefusal = sentence(error);
    }
    return outlook;
}

/// A picture from which a thumbnail can be made quickly.
const QImage& smallPicture(const DisplayPicture& picture) {
    constexpr double kSide = 512;
    return picture.levelFor(kSide / picture.size().longerSide());
}

} // namespace

RunDesk::RunDesk(const QString& folder, QObject* parent)
    : QObject(parent), m_controller(new RunController(this)), m_queue(new JobQueue(m_controller, this)),
      m_history(new ResultHistory(folder, this)) {
    connectNotes();
    connectQueue();
}

void RunDesk::connectNotes() {
    connect(m_queue, &JobQueue::started, this,
            [this](int id) { Q_EMIT noted(tr("Started: %1").arg(m_queue->find(id)->label)); });
    connect(m_queue, &JobQueue::cancelled, this, [this](const QueuedJob& job, double fraction) {
        Q_EMIT noted(tr("Cancelled at %1: %2").arg(percentText(fraction), job.label));
    });
    connect(m_queue, &JobQueue::failed, this,
            [this](const QueuedJob& job) { Q_EMIT noted(tr("Failed: %1: %2").arg(job.label, job.problem)); });
    connect(m_history, &ResultHistory::remarked, this, &RunDesk::noted);
    connect(m_controller, &RunController::unprotected, this, &RunDesk::refuse);
}

void RunDesk::connectQueue() {
    connect(m_queue, &JobQueue::started, this, [this](int id) {
        if (m_queue->find(id)->shown)
            watch(id);
    });
    connect(m_queue, &JobQueue::previewed, this, [this](int id, const RunPictures& pictures) {
        if (id != m_live)
            return;
        setResultShown(false);
        Q_EMIT previewed(pictures);
        Q_EMIT changed();
    });
    connect(m_queue, &JobQueue::curvesGrew, this, [this](int id, const std::vector<Curve>& curves) {
        if (id == m_live)
            Q_EMIT curvesGrew(curves);
    });
    connect(m_queue, &JobQueue::finished, this, &RunDesk::keep);
    connect(m_queue, &JobQueue::cancelled, this, &RunDesk::takeCancelled);
    connect(m_queue, &JobQueue::failed, this, &RunDesk::takeFailed);
    connect(m_queue, &JobQueue::changed, this, &RunDesk::changed);
}

void RunDesk::lookAhead(const RunInput& input) {
    m_input = input;
    lookAgain();
}

void RunDesk::lookAway() {
    m_input.reset();
    ++m_lookRequest;
    setOutlook({});
}

void RunDesk::lookAgain() {
    if (!m_input)
        return;
    inBackground(
        this, [input = *m_input, earlier = m_history->entries()] { return outlookOf(input, earlier); },
        [this, request = ++m_lookRequest](const Outlook& outlook) {
            if (request == m_lookRequest)
                setOutlook(outlook);
        },
        [this](const QString& why) { refuse(why); });
}

void RunDesk::setOutlook(const Outlook& outlook) {
    m_outlook = outlook;
    Q_EMIT outlookChanged(m_outlook);
    Q_EMIT changed();
}

void RunDesk::run(const RunInput& input, bool quick) {
    add(input, quick, true);
}

void RunDesk::enqueue(const RunInput& input) {
    add(input, false, false);
}

void RunDesk::add(const RunInput& input, bool quick, bool next) {
    if (std::exchange(m_adding, true))
        return;
    Q_EMIT changed();
    inBackground(
        this, [input, quick] { return planRun(quick ? quickOf(input) : input); },
        [this, quick, next](RunPlan plan) {
            m_adding = false;
            Q_EMIT accepted();
            const auto expected = expectedSeconds(plan, m_history->entries());
            m_queue->add(std::move(plan), quick, next, next ? JobQueue::Place::Next : JobQueue::Place::Last,
                         expected);
        },
        [this](const QString& why) {
            m_adding = false;
            refuse(why);
            Q_EMIT changed();
        });
}

void RunDesk::refuse(const QString& sentence) {
    Q_EMIT noted(sentence);
    Q_EMIT refused(sentence);
}

void RunDesk::resume(BrokenRun run) {
    m_queue->resume(std::move(run.plan).value(),
                    std::make_shared<RunCheckpoint>(run.file, std::move(run.checkpoint)));
}

void RunDesk::breakOff() {
    m_queue->leaveCheckpoints();
    m_queue->clear();
    cancel();
}

void RunDesk::halt() {
    m_queue->leaveCheckpoints();
    m_controller->halt();
}

void RunDesk::watch(int id) {
    const QueuedJob* const job = m_queue->find(id);
    ++m_showRequest;
    m_live = id;
    setResultShown(false);
    m_shownPlan = job->plan;
    Q_EMIT watching(*job);
    Q_EMIT changed();
}

void RunDesk::keep(const QueuedJob& job, const std::shared_ptr<const Result>& result,
                   const RunPictures& pictures) {
    const std::string key = m_history->add(result, job.quick, smallPicture(*pictures.result));
    const QString time = QString::fromStdString(durationText(result->seconds));
    Q_EMIT noted(
        result->stoppedAt
            ? tr("Stopped at %1 and kept, after %2: %3").arg(percentText(*result->stoppedAt), time, job.label)
            : tr("Finished in %1: %2").arg(time, job.label));
    for (const Message& note : result->synthesis.notes)
        Q_EMIT noted(tr("Note: %1").arg(translated(note)));
    Q_EMIT kept(job, key, pictures);
    if (job.id == m_live)
        show({result, pictures, job.quick, key});
    else if (job.shown)
        Q_EMIT endedUnseen(job, key);
    lookAgain();
}

void RunDesk::takeCancelled(const QueuedJob& job, double fraction) {
    if (job.id == m_live) {
        showFormer();
        Q_EMIT cancelled(job, fraction);
    }
    Q_EMIT changed();
}

void RunDesk::showFormer() {
    if (m_last.result)
        showLast();
    else
        clear();
}

void RunDesk::takeFailed(const QueuedJob& job) {
    if (job.id == m_live)
        showFormer();
    if (job.shown)
        Q_EMIT refused(job.problem);
    Q_EMIT changed();
}

void RunDesk::show(const std::string& key) {
    const auto failed = [this](const QString& why) { refuse(why); };
    const auto got = [this, key, failed,
                      request = ++m_showRequest](const std::shared_ptr<const Result>& result) {
        const ResultEntry* const entry = m_history->find(key);
        const bool quick = entry != nullptr && entry->quick;
        inBackground(
            this, [result] { return picturesOf(result); },
            [this, key, result, quick, request](const RunPictures& pictures) {
                if (request == m_showRequest)
                    show({result, pictures, quick, key});
            },
            failed);
    };
    m_history->want(key, got, failed);
}

void RunDesk::clear() {
    ++m_showRequest;
    m_live = 0;
    m_last = {};
    m_shownPlan.reset();
    setResultShown(false);
    Q_EMIT emptied();
    Q_EMIT changed();
}

void RunDesk::setResultShown(bool shown) {
    m_resultShown = shown;
    m_history->setShown(shown ? m_last.key : std::string());
}

void RunDesk::showLast() {
    show(ShownResult(m_last));
}

void RunDesk::show(ShownResult result) {
    m_live = 0;
    m_last = std::move(result);
    setResultShown(true);
    m_shownPlan = m_last.result->plan;
    Q_EMIT shown(m_last);
    Q_EMIT changed();
}

} // namespace texloom::ui
