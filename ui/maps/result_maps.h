#pragma once

#include "core/analysis/copy_index.h"
#include "ui/jobs/task.h"
#include "ui/runs/run_pictures.h"

#include <QObject>
#include <QPoint>

#include <memory>
#include <optional>
#include <vector>

namespace texloom::ui {

/// What can be made of a result's map, each on demand and in the background: the map itself, estimated, where
/// a method has none; what was copied as it is; and where an exemplar's pixels went.
class ResultMaps : public QObject {
    Q_OBJECT

public:
    /// What was copied together.
    struct Copies {
        std::shared_ptr<const DisplayPicture> picture;
        double largest = 0; ///< share of the result that the largest piece takes
    };

    using QObject::QObject;

    /// From now on it is about these pictures; what is under way for others is called off.
    void follow(const RunPictures& pictures);
    const RunPictures& pictures() const { return m_pictures; }

    /// Whether there is a finished result without a map.
    bool canEstimate() const;
    /// Looks for the most similar place of every pixel; estimated() or failed() follows.
    void estimate();
    void cancel();
    bool estimating() const { return m_estimation.running(); }
    double progress() const { return m_estimation.progress(); }

    /// What was copied; made on the first call, and copiesChanged() follows.
    const std::optional<Copies>& copies();
    /// Result pixels that came from this source. Empty until the index is made, which the first call starts.
    std::vector<QPoint> copiesOf(const Source& source);

Q_SIGNALS:
    /// pictures() now has an estimated map.
    void estimated();
    void copiesChanged();
    void failed(const QString& sentence);

private:
    struct Indexed {
        std::unique_ptr<CopyIndex> index;
    };

    RunPictures m_pictures;
    std::optional<Copies> m_copies;
    std::unique_ptr<CopyIndex> m_index;
    Task<RunPictures> m_estimation;
    Task<Copies> m_copying;
    Task<Indexed> m_indexing;
};

} // namespace texloom::ui
