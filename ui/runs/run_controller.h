#pragma once

#include "core/session/run/run.h"
#include "ui/runs/run_checkpoint.h"
#include "ui/runs/run_pictures.h"

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QTimer>

#include <memory>
#include <optional>
#include <vector>

namespace texloom::ui {

/// How far a run has come.
struct RunProgress {
    double fraction = 0;
    QString stage;
    double seconds = 0;
    std::optional<double> left; ///< seconds still to go, once that can be told
};

/// "Image quilting · seed 1 · 512 × 512".
QString labelOf(const RunPlan& plan);

/// Owns the run under way: starts it, looks at it on a timer, and tells the window how it goes and ends. A
/// run goes on its own threads; destroying the controller halts it.
class RunController : public QObject {
    Q_OBJECT

public:
    explicit RunController(QObject* parent = nullptr);
    ~RunController() override;

    /// Starts a planned run; there must be none under way. @param quick whether it is a preview at a small
    /// size. @param checkpoint where it can be taken up again; null if it leaves none.
    void start(RunPlan plan, bool quick, std::shared_ptr<RunCheckpoint> checkpoint = nullptr);
    /// Asks the run to end; cancelled() follows.
    void cancel();
    /// Asks the run to end with the picture it has; finished() follows. One that has none goes on until it
    /// does, and pictureAwaited() says so.
    void stopAndKeep();
    /// Ends the run and waits for that; nobody is told.
    void halt();
    bool running() const { return m_job != nullptr; }
    /// Whether the run under way, or the last one, is or was a preview at a small size.
    bool quick() const { return m_quick; }
    /// "quilting · seed 1 · 512 × 512" of the run under way or the last one.
    const QString& label() const { return m_label; }

Q_SIGNALS:
    void started();
    void progressed(const texloom::ui::RunProgress& progress);
    /// A partial picture is there to be shown.
    void previewed(const texloom::ui::RunPictures& pictures);
    /// The run's curves have more values than before; told no more often than pictures come.
    void curvesGrew(const std::vector<texloom::Curve>& curves);
    /// The run is to end with a picture and has none yet.
    void pictureAwaited();
    void finished(std::shared_ptr<const texloom::Result> result, const texloom::ui::RunPictures& pictures);
    /// The run was cancelled at this share of its work.
    void cancelled(double fraction);
    /// The run failed; the sentence says why.
    void failed(const QString& sentence);
    /// The run goes on, but it could not be taken up again after a crash; the sentence says why.
    void unprotected(const QString& sentence);

private:
    void poll();
    void tellProgress();
    bool showPreview();
    void showCurves();
    void takeOutcome(int run);
    void finishWith(const std::shared_ptr<const Result>& result);
    void failWith(const QString& why);
    void end();

    std::shared_ptr<RunCheckpoint> m_checkpoint; ///< goes after the job, which writes it
    std::unique_ptr<SynthesisJob> m_job;
    QTimer m_timer;
    QString m_label;
    Size m_size;
    bool m_quick = false;
    bool m_drawing = false;
    bool m_pictured = false; ///< whether the run has a picture
    bool m_keeping = false;  ///< whether it is to end with what it has
    std::size_t m_drawn = 0; ///< values of all curves when they were told last
    QElapsedTimer m_sinceDrawn;
    int m_run = 0;
};

} // namespace texloom::ui
