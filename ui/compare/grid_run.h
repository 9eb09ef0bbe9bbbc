#pragma once

#include "core/session/run.h"
#include "ui/compare/compare_item.h"
#include "ui/jobs/job_queue.h"
#include "ui/results/result_history.h"

#include <QObject>

#include <functional>
#include <map>
#include <vector>

namespace texloom::ui {

class CompareView;

/// One run of a grid before it starts.
struct GridEntry {
    QString label;
    RunInput input;
};

/// Makes many runs by way of the queue and shows them as a grid that fills as they end; those that cannot be
/// run say why in their place. Every result goes to the history like any other.
class GridRun : public QObject {
    Q_OBJECT

public:
    GridRun(JobQueue* queue, const ResultHistory* history, CompareView* view, QObject* parent = nullptr);

    /// @param first pictures shown before the runs, such as the exemplar.
    /// @param columns of the grid; 0 for one about as wide as high.
    /// @param quick whether these are previews at a small size.
    /// @param cheapestFirst whether the quickest run comes first, rather than the first entry.
    void start(std::vector<GridEntry> entries, std::vector<CompareItem> first, int columns, bool quick,
               bool cheapestFirst);
    /// Runs of the grid that have not ended.
    int open() const { return static_cast<int>(m_cells.size()); }
    /// The run `id` has ended and is this result in the history.
    void keep(int id, const std::string& key, const RunPictures& pictures);

Q_SIGNALS:
    /// All runs of the grid are queued or refused.
    void queued();

private:
    struct Planned {
        QString label;
        std::optional<RunPlan> plan;
        QString refusal;
        double seconds = 0;
    };

    static Planned planned(const GridEntry& entry, const std::vector<ResultEntry>& earlier);
    void showAndQueue(std::vector<Planned> planned, std::vector<CompareItem> first, int columns, bool quick);
    void say(int id, const QString& message);
    void showPreview(int id, const RunPictures& pictures);

    JobQueue* m_queue;
    const ResultHistory* m_history;
    CompareView* m_view;
    std::map<int, int> m_cells; ///< the view's cell of each run
    int m_request = 0;
};

} // namespace texloom::ui
