#include "ui/compare/grid_run.h"

#include "core/base/text.h"
#include "ui/common/background.h"
#include "ui/common/text.h"
#include "ui/compare/compare_view.h"
#include "ui/runs/result_text.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace texloom::ui {

GridRun::GridRun(RunDesk* desk, CompareView* view, QObject* parent)
    : QObject(parent), m_queue(desk->queue()), m_history(desk->history()), m_view(view) {
    connect(view, &CompareView::replaced, this, [this] {
        std::set<int> shown;
        for (const CompareItem& item : m_view->items())
            shown.insert(item.run);
        std::erase_if(m_open, [&](int id) { return !shown.contains(id); });
    });
    connect(m_queue, &JobQueue::started, this, [this](int id) { say(id, tr("Under way…")); });
    connect(m_queue, &JobQueue::previewed, this, &GridRun::showPreview);
    connect(m_queue, &JobQueue::failed, this, [this](const QueuedJob& job) {
        say(job.id, job.problem);
        m_open.erase(job.id);
    });
    connect(desk, &RunDesk::kept, this,
            [this](const QueuedJob& job, const std::string& key, const RunPictures& pictures) {
                if (const auto varied = m_varied.find(job.id); varied != m_varied.end()) {
                    m_history->setVaried(key, varied->second);
                    m_varied.erase(varied);
                }
                keep(job.id, key, pictures);
            });
    connect(m_queue, &JobQueue::cancelled, this, [this](const QueuedJob& job) {
        say(job.id, tr("Cancelled."));
        m_open.erase(job.id);
    });
}

GridRun::Planned GridRun::planned(const GridEntry& entry, const std::vector<ResultEntry>& earlier) {
    Planned planned;
    planned.label = entry.label;
    planned.varied = entry.varied;
    planned.seconds = std::numeric_limits<double>::infinity();
    try {
        planned.plan = planRun(entry.input);
        planned.seconds = expectedSeconds(*planned.plan, earlier).value_or(planned.plan->estimate.seconds);
    } catch (const std::exception& error) {
        planned.refusal = sentence(error);
    }
    return planned;
}

void GridRun::start(std::vector<GridEntry> entries, std::vector<CompareItem> first,
                    const GridLayout& layout) {
    m_open.clear();
    const auto plan = [entries = std::move(entries), earlier = m_history->entries()] {
        std::vector<Planned> all;
        for (const GridEntry& entry : entries)
            all.push_back(planned(entry, earlier));
        return all;
    };
    inBackground(
        this, plan,
        [this, first = std::move(first), layout, request = ++m_request](std::vector<Planned> all) {
            if (request == m_request)
                showAndQueue(std::move(all), first, layout);
        },
        [](const QString&) {});
}

void GridRun::showAndQueue(std::vector<Planned> planned, std::vector<CompareItem> first,
                           const GridLayout& layout) {
    for (Planned& run : planned)
        if (run.plan && run.seconds > layout.longest) {
            run.refusal = tr("Would take about %1: choose the method and run it by itself.")
                              .arg(QString::fromStdString(durationText(run.seconds)));
            run.plan.reset();
        }
    std::vector<CompareItem> items = std::move(first);
    const std::size_t before = items.size();
    for (const Planned& run : planned)
        items.push_back({run.label, nullptr, run.plan ? tr("Waiting…") : run.refusal, {}});
    std::vector<std::size_t> queued;
    for (std::size_t i = 0; i < planned.size(); ++i)
        if (planned[i].plan)
            queued.push_back(i);
    if (layout.cheapestFirst)
        std::stable_sort(queued.begin(), queued.end(), [&](std::size_t a, std::size_t b) {
            return planned[a].seconds < planned[b].seconds;
        });
    int id = m_queue->nextId();
    for (const std::size_t i : queued)
        items[before + i].run = id++;
    m_view->setItems(std::move(items), layout.columns, layout.heading);
    for (const std::size_t i : queued) {
        Planned& run = planned[i];
        // It must be known before the queue tells that the run began.
        m_open.insert(m_queue->nextId());
        if (!run.varied.empty())
            m_varied[m_queue->nextId()] = run.varied;
        m_queue->add(std::move(*run.plan), layout.quick, false, JobQueue::Place::Last, run.seconds);
    }
}

std::optional<int> GridRun::stop() {
    const QueuedJob* const current = m_queue->current();
    if (current == nullptr || !m_open.contains(current->id))
        return {};
    const int running = current->id;
    int left = 0;
    for (const int id : std::set(m_open))
        if (id != running && m_queue->find(id) != nullptr) {
            m_queue->cancel(id);
            ++left;
        }
    return left;
}

/// The view's cell of a run that is open; −1 where it shows something else by now.
int GridRun::cellOf(int id) const {
    if (!m_open.contains(id))
        return -1;
    const std::vector<CompareItem>& items = m_view->items();
    const auto found =
        std::find_if(items.begin(), items.end(), [=](const CompareItem& item) { return item.run == id; });
    return found == items.end() ? -1 : static_cast<int>(found - items.begin());
}

void GridRun::say(int id, const QString& message) {
    const int cell = cellOf(id);
    if (cell < 0)
        return;
    CompareItem item = m_view->items()[static_cast<std::size_t>(cell)];
    item.message = message;
    item.picture = nullptr;
    m_view->setItem(cell, item);
}

void GridRun::showPreview(int id, const RunPictures& pictures) {
    const int cell = cellOf(id);
    if (cell < 0)
        return;
    CompareItem item = m_view->items()[static_cast<std::size_t>(cell)];
    item.picture = pictures.result;
    m_view->setItem(cell, item);
}

void GridRun::keep(int id, const std::string& key, const RunPictures& pictures) {
    const int cell = cellOf(id);
    if (cell < 0)
        return;
    CompareItem item = m_view->items()[static_cast<std::size_t>(cell)];
    item.picture = pictures.result;
    item.key = key;
    item.figures = figuresText(pictures.run->figures);
    if (pictures.run->stoppedAt)
        item.label = tr("%1 · %2").arg(item.label, stoppedText(*pictures.run->stoppedAt));
    m_view->setItem(cell, item);
    m_open.erase(id);
}

} // namespace texloom::ui
