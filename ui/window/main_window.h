#pragma once

#include "core/session/preset.h"
#include "core/session/run/run.h"
#include "core/session/session.h"
#include "ui/exemplar/exemplar_store.h"
#include "ui/exemplar/named_image.h"
#include "ui/runs/job_queue.h"
#include "ui/window/actions.h"
#include "ui/window/drop_targets.h"

#include <QMainWindow>
#include <QTimer>

#include <memory>
#include <optional>

class QComboBox;
class QMenu;
class QMimeData;
class QStackedWidget;

namespace texloom::ui {

class Document;
class ExemplarEditor;
class ExemplarPanel;
class ExportDialog;
class FiguresPanel;
class ImageViewer;
class Inspector;
class LatticeTool;
class MessageBar;
class Readout;
class ResultView;
class RunPanel;
class StartPage;
class UndoHistory;
class Workbench;
struct LoadedSession;

/// The size of a preview of an output: its shape, small.
Size quickSize(Size size);

/// The window: exemplars on the left, pictures in the middle, parameters on the right. It joins what the
/// parts say to one another and does no work itself.
class MainWindow : public QMainWindow {
    Q_OBJECT

public:
    explicit MainWindow(QWidget* parent = nullptr);
    ~MainWindow() override;

    /// Opens pictures as exemplars, and recipes.
    void openFiles(const QStringList& paths);
    /// Starts a run with the settings as they stand, right after the one under way if there is one.
    /// @param quick at a preview's size.
    void startRun(bool quick);
    /// Adds a run with the settings as they stand to the end of the queue.
    void queueRun();
    /// What a run would be given now.
    RunInput input(bool quick) const;
    /// Takes over everything that a recipe says.
    void restore(const RunInput& input);
    /// Takes over what a recipe says; its exemplars are read if they are not open.
    /// @param keepSize whether the output keeps its size, as for the recipe of a preview.
    void restoreRecipe(const Recipe& recipe, bool keepSize);
    /// Shows a finished run. @param quick whether it is a preview at a small size.
    void showResult(const std::shared_ptr<const Result>& result, const RunPictures& pictures, bool quick);
    /// Shows the pictures of the run under way as it goes, and its result.
    void watch(int id);
    /// Leaves the start page.
    void showResults();
    /// Says in place what could not be done.
    void fail(const QString& sentence);

    ExemplarStore* store() const { return m_store; }
    RunController* controller() const { return m_controller; }
    Inspector* inspector() const { return m_inspector; }
    ResultView* results() const { return m_results; }
    MessageBar* messages() const { return m_messages; }
    RunPanel* runPanel() const { return m_runPanel; }
    ExemplarPanel* exemplarPanel() const { return m_exemplars; }
    ExemplarEditor* exemplarEditor() const { return m_editor; }
    Document* document() const { return m_document; }
    UndoHistory* undoHistory() const { return m_undo; }
    /// Everything that a session keeps, as it stands.
    Session session() const;
    Workbench* workbench() const { return m_bench; }
    LatticeTool* lattice() const { return m_lattice; }
    /// The finished result that was shown last; null if there is none.
    const std::shared_ptr<const Result>& result() const { return m_result; }

protected:
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dragLeaveEvent(QDragLeaveEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    void makeCentre();
    void makeDocks();
    void makeMenus();
    QMenu* makePresetMenu();
    QMenu* makeViewMenu();
    QMenu* makeAppearanceMenu();
    void makeToolBar();
    void setTabOrderThrough();
    void connectActions();
    void connectViewActions();
    ImageViewer* frontViewer() const;
    void connectStore();
    void connectRun();
    void connectHovers();
    void connectLattice();
    void connectTools();
    std::vector<NamedImage> images() const;
    std::vector<NamedImage> earlierResults();
    void restoreLayout();
    void makeDocument();
    bool handmade() const;
    void tidyMasks();
    void showTitle();
    void showSession(const LoadedSession& loaded, const std::function<void()>& shown);
    void editExemplar(bool edit);

    void fillRecentMenu(QMenu* menu);
    void openDialog();
    void paste();
    void take(const QMimeData& offered);
    void dropOn(DropTargets::Target target, const QMimeData& offered);
    void exemplarOpened(int id);
    void offerRecipe(const QString& path, const QString& text);
    void loadRecipeFrom(const QString& path);
    void exportDialog();
    void writeFiles(const ExportDialog& dialog);
    void copyResult();

    void methodChosen();
    void settingsEdited();
    void usePreset(const Preset& preset);
    void exemplarsChanged();
    void planSoon();
    void plan();
    void updateActions();
    std::vector<RunExemplar> usedExemplars() const;
    void addRun(bool quick, bool next);
    void applySettings(const RunInput& input);
    bool openExemplarsOf(const Recipe& recipe);
    void takeShownExemplars(const RunPlan& plan);
    void runStarted(int id);
    void runPreviewed(int id, const RunPictures& pictures);
    void runFinished(const QueuedJob& job, const std::shared_ptr<const Result>& result,
                     const RunPictures& pictures);
    void runStopped(const QueuedJob& job, double fraction);
    void runFailed(const QueuedJob& job);
    void showResult();

    void hoverResult(QPoint pixel);
    void hoverExemplar(const ExemplarEntry* entry, QPoint pixel);
    void showCopies(const ExemplarEntry& entry, QPoint pixel);
    void endHover();
    void showShortcuts();
    void showAbout();

    Actions m_actions;
    ExemplarStore* m_store;
    RunController* m_controller;
    Workbench* m_bench;
    QStackedWidget* m_centre = nullptr;
    StartPage* m_start = nullptr;
    ResultView* m_results = nullptr;
    ExemplarEditor* m_editor = nullptr;
    DropTargets* m_drop = nullptr;
    Document* m_document = nullptr;
    UndoHistory* m_undo = nullptr;
    MessageBar* m_messages = nullptr;
    ExemplarPanel* m_exemplars = nullptr;
    Inspector* m_inspector = nullptr;
    RunPanel* m_runPanel = nullptr;
    LatticeTool* m_lattice = nullptr;
    FiguresPanel* m_figures = nullptr;
    Readout* m_readout = nullptr;
    QComboBox* m_method;
    QByteArray m_defaultLayout;
    QTimer m_planTimer;
    bool m_canRun = false;
    bool m_canQuick = false;
    bool m_starting = false;
    int m_planRequest = 0;
    int m_live = 0; ///< the queue's id of the run whose pictures are shown as it goes

    std::vector<Exemplar> m_shownExemplars; ///< of the run whose pictures are shown
    std::shared_ptr<const Result> m_result;
    RunPictures m_resultPictures;
    bool m_resultQuick = false;
    bool m_resultShown = false;
};

} // namespace texloom::ui
