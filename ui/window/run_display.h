#pragma once

#include "ui/runs/run_desk.h"

#include <QObject>

namespace texloom::ui {

class FiguresPanel;
class MaterialPage;
class MessageBar;
class ResultView;
class RunPanel;
class VolumePage;

/// Shows what the desk tells: the pictures of the run that is shown with its title, badge, notes and figures,
/// in tabs of their own the material that it makes, lit, and its volumes, if it made any;
/// what the next run will need, how the one under way goes, and what could not be done.
class RunDisplay : public QObject {
    Q_OBJECT

public:
    /// Where it is shown.
    struct Places {
        ResultView* results;
        FiguresPanel* figures;
        RunPanel* panel;
        MessageBar* messages;
    };

    RunDisplay(RunDesk* desk, const Places& places, QObject* parent);

    /// The tab of volumes.
    VolumePage* volumes() const { return m_volume; }

private:
    void connectPanel();
    void announce(const QueuedJob& job);
    void showPreview(const RunPictures& pictures);
    void showResult(const ShownResult& shown);
    void sayAwaited();
    void clear();
    void sayCancelled(const QueuedJob& job, double fraction);
    void offer(const QueuedJob& job, const std::string& key);

    RunDesk* m_desk;
    Places m_to;
    VolumePage* m_volume;
    MaterialPage* m_material;
};

} // namespace texloom::ui
