#include "ui/compare/grid_run.h"

#include "ui/compare/compare_view.h"
#include "ui/jobs/background.h"
#include "ui/window/text.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace texloom::ui {

GridRun::GridRun(JobQueue* queue, const ResultHistory* history, CompareView* view, QObject* parent)
    : QObject(parent), m_queue(queue), m_history(history), m_view(view) {
    connect(view, &CompareView::replaced, this, [this] { m_cells.clear(); });
    connect(queue, &JobQueue::started, this, [this](int id) { say(id, tr("Under way…")); });
    connect(queue, &JobQueue::previewed, this, &GridRun::showPreview);
    connect(queue, &JobQueue::failed, this, [this](const QueuedJob& job) {
        say(job.id, job.problem);
        m_cells.erase(job.id);
    });
    connect(queue, &JobQueue::stopped, this, [this](const QueuedJob& job) {
        say(job.id, tr("Stopped."));
        m_cells.erase(job.id);
    });
}

GridRun::Planned GridRun::planned(const GridEntry& entry, const std::vector<ResultEntry>& earlier) {
    Planned planned;
    planned.label = entry.label;
    planned.seconds = std::numeric_limits<double>::infinity();
    try {
        planned.plan = planRun(entry.input);
        planned.seconds = expectedSeconds(*planned.plan, earlier).value_or(planned.plan->estimate.seconds);
    } catch (const std::exception& error) {
        planned.refusal = translated(sentence(error).toStdString());
    }
    return planned;
}

void GridRun::start(std::vector<GridEntry> entries, std::vector<CompareItem> first, int columns, bool quick,
                    bool cheapestFirst) {
    m_cells.clear();
    const auto plan = [entries = std::move(entries), earlier = m_history->entries(), cheapestFirst] {
        std::vector<Planned> all;
        for (const GridEntry& entry : entries)
            all.push_back(planned(entry, earlier));
        if (cheapestFirst)
            std::stable_sort(all.begin(), all.end(),
                             [](const Planned& a, const Planned& b) { return a.seconds < b.seconds; });
        return all;
    };
    inBackground(
        this, plan,
        [this, first = std::move(first), columns, quick, request = ++m_request](std::vector<Planned> all) {
            if (request == m_request)
                showAndQueue(std::move(all), first, columns, quick);
        },
        [](const QString&) {});
}

void GridRun::showAndQueue(std::vector<Planned> planned, std::vector<CompareItem> first, int columns,
                           bool quick) {
    std::vector<CompareItem> items = std::move(first);
    const int before = static_cast<int>(items.size());
    for (const Planned& run : planned)
        items.push_back({run.label, nullptr, run.plan ? tr("Waiting…") : run.refusal, {}});
    m_view->setItems(std::move(items), columns);
    for (std::size_t i = 0; i < planned.size(); ++i)
        if (planned[i].plan) {
            const double seconds = planned[i].seconds;
            // The cell must be known before the queue tells that the run began.
            m_cells[m_queue->nextId()] = before + static_cast<int>(i);
            m_queue->add(std::move(*planned[i].plan), quick, false, JobQueue::Place::Last, seconds);
        }
    Q_EMIT queued();
}

void GridRun::say(int id, const QString& message) {
    const auto cell = m_cells.find(id);
    if (cell == m_cells.end())
        return;
    CompareItem item = m_view->items()[static_cast<std::size_t>(cell->second)];
    item.message = message;
    item.picture = nullptr;
    m_view->setItem(cell->second, item);
}

void GridRun::showPreview(int id, const RunPictures& pictures) {
    const auto cell = m_cells.find(id);
    if (cell == m_cells.end())
        return;
    CompareItem item = m_view->items()[static_cast<std::size_t>(cell->second)];
    item.picture = pictures.result;
    m_view->setItem(cell->second, item);
}

void GridRun::keep(int id, const std::string& key, const RunPictures& pictures) {
    const auto cell = m_cells.find(id);
    if (cell == m_cells.end())
        return;
    CompareItem item = m_view->items()[static_cast<std::size_t>(cell->second)];
    item.picture = pictures.result;
    item.key = key;
    m_view->setItem(cell->second, item);
    m_cells.erase(cell);
}

} // namespace texloom::ui
