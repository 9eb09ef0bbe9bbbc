#pragma once

#include "core/session/run/run.h"
#include "ui/compare/compare_item.h"
#include "ui/runs/run_desk.h"

#include <QObject>

#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <vector>

namespace texloom::ui {

class CompareView;

/// One run of a grid before it starts.
struct GridEntry {
    QString label;
    RunInput input;
    std::vector<Message> varied = {}; ///< see ResultEntry::varied
};

/// How the runs of a grid are made and shown.
struct GridLayout {
    QString heading;   ///< of the grid's contact sheet: what all of them share
    int columns = 0;   ///< 0 for a grid about as wide as high
    bool quick = true; ///< whether these are previews at a small size
    /// Seconds from which on a run is not made, and its cell says so.
    double longest = std::numeric_limits<double>::infinity();
    bool cheapestFirst = false; ///< whether the quickest run is made first, rather than the first entry's
};

/// Makes many runs by way of the queue and shows them as a grid that fills as they end; those that cannot be
/// run say why in their place. Every result goes to the history like any other.
class GridRun : public QObject {
    Q_OBJECT

public:
    GridRun(RunDesk* desk, CompareView* view, QObject* parent = nullptr);

    /// @param first pictures shown before the runs, such as the exemplar.
    void start(std::vector<GridEntry> entries, std::vector<CompareItem> first, const GridLayout& layout);
    /// Runs of the grid that have not ended.
    int open() const { return static_cast<int>(m_open.size()); }
    /// Where one of its runs is under way: has that one end with what it has, and gives up those that wait.
    /// @return how many were given up; none if another run is under way, or none.
    std::optional<int> stop();

private:
    struct Planned {
        QString label;
        std::vector<Message> varied;
        std::optional<RunPlan> plan;
        QString refusal;
        double seconds = 0;
    };

    static Planned planned(const GridEntry& entry, const std::vector<ResultEntry>& earlier);
    void showAndQueue(std::vector<Planned> planned, std::vector<CompareItem> first, const GridLayout& layout);
    int cellOf(int id) const;
    void say(int id, const QString& message);
    void showPreview(int id, const RunPictures& pictures);
    void keep(int id, const std::string& key, const RunPictures& pictures);

    JobQueue* m_queue;
    ResultHistory* m_history;
    CompareView* m_view;
    std::set<int> m_open;
    std::map<int, std::vector<Message>> m_varied;
    int m_request = 0;
};

} // namespace texloom::ui
