#pragma once

#include "core/session/preset.h"
#include "core/session/run/run.h"
#include "core/session/session.h"
#include "ui/exemplar/exemplar_store.h"
#include "ui/exemplar/named_image.h"
#include "ui/results/result_panel.h"
#include "ui/runs/run_desk.h"
#include "ui/session/settings_state.h"
#include "ui/window/actions.h"
#include "ui/window/drop_targets.h"

#include <QMainWindow>
#include <QTimer>

#include <functional>
#include <string>
#include <vector>

class QComboBox;
class QDockWidget;
class QMenu;
class QMimeData;
class QStackedWidget;

namespace texloom {
class OutputGuard;
}

namespace texloom::ui {

class BlendWindow;
class Comparisons;
class CompareView;
class Document;
class ExemplarEditor;
class ExemplarPanel;
class FiguresPanel;
class ImageViewer;
class Inspector;
class JobPanel;
class LatticeTool;
class LogPanel;
class MessageBar;
class MethodHint;
class ResultExport;
class ResultInputs;
class ResultView;
class RunDisplay;
class RunPanel;
class RunRecovery;
class StartPage;
class Tries;
class UndoHistory;
struct LoadedSession;

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
    /// What a run would be given now.
    RunInput input(bool quick) const;
    /// Takes over everything that a recipe says.
    void restore(const RunInput& input);
    /// Takes over what a recipe says; its exemplars are read if they are not open.
    /// @param keepSize whether the output keeps its size, as for the recipe of a preview.
    void restoreRecipe(const Recipe& recipe, bool keepSize);
    /// Asks about sessions and runs that a crash broke off.
    void offerRecovery();
    /// Takes over the settings of a result of the history.
    void restoreResult(const std::string& key);
    /// Says in place what could not be done.
    void fail(const QString& sentence);

    RunDesk* desk() const { return m_desk; }
    ExemplarStore* store() const { return m_store; }
    Inspector* inspector() const { return m_inspector; }
    ResultView* results() const { return m_results; }
    MessageBar* messages() const { return m_messages; }
    RunPanel* runPanel() const { return m_runPanel; }
    ResultPanel* resultPanel() const { return m_resultPanel; }
    LogPanel* log() const { return m_log; }
    CompareView* compare() const;
    ExemplarPanel* exemplarPanel() const { return m_exemplars; }
    ExemplarEditor* exemplarEditor() const { return m_editor; }
    Document* document() const { return m_document; }
    UndoHistory* undoHistory() const { return m_undo; }
    /// Everything that a session keeps, as it stands.
    Session session() const;
    LatticeTool* lattice() const { return m_lattice; }

protected:
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dragLeaveEvent(QDragLeaveEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    void fillMethods();
    void makeCentre();
    void makeDocks();
    QDockWidget* addDock(QWidget* content, const QString& title, const char* name);
    void arrangePanels(bool stacked);
    void makeMenus();
    QMenu* makeFileMenu();
    QMenu* makeExemplarMenu();
    void reserveKeys();
    QMenu* makeSynthesisMenu();
    QMenu* makePresetMenu();
    QMenu* makeViewMenu();
    QMenu* makeAppearanceMenu();
    void makeToolBar();
    void setTabOrderThrough();
    void connectActions();
    void connectRunActions();
    void connectViewActions();
    ImageViewer* frontViewer() const;
    void connectStore();
    void connectDesk();
    void connectResults();
    void offerToPutBack(const std::vector<std::string>& keys, const QString& sentence);
    void connectLattice();
    void connectTools();
    void connectSolids();
    QMenu* makeSolidMenu();
    std::vector<NamedImage> images() const;
    std::vector<NamedImage> earlierResults();
    BlendWindow* openBlend(std::vector<NamedImage> first);
    void restoreLayout();
    void makeDocument();
    void connectRecovery();
    bool handmade() const;
    void tidyFiles();
    void tellFiles(OutputGuard& guard) const;
    void showTitle();
    void startAfresh(const std::function<void()>& shown);
    void showSession(const LoadedSession& loaded, const std::function<void()>& shown);
    void editExemplar(bool edit);

    void fillRecentMenu(QMenu* menu);
    void openMaterials(const QString& path);
    void offerNeighbours(int id);
    void mixNext();
    void openDialog();
    void paste();
    void take(const QMimeData& offered);
    void dropOn(DropTargets::Target target, const QMimeData& offered);
    void dropInto(const std::string& port, const QMimeData& offered);
    void exemplarOpened(int id);
    void askForLayer(const LayerQuestion& question);
    void offerRecipe(const QString& path, const QString& text);
    void loadRecipeFrom(const QString& path);
    /// Says so where another build made something. @param sentence with both versions as %1 and %2
    void sayOtherBuild(const std::string& version, const QString& sentence);

    void methodChosen();
    void settingsEdited();
    void usePreset(const Preset& preset);
    void exemplarsChanged();
    void planSoon();
    void plan();
    void updateActions();
    std::vector<RunExemplar> usedExemplars() const;
    void drawSeedUnlessLocked();
    void stopRuns();
    void runLike(const Recipe& recipe, bool quick);
    bool lookAtExemplarsOf(const Recipe& recipe);
    void applySettings(const RunInput& input);
    bool openExemplarsOf(const Recipe& recipe);
    void showResults();
    void showShortcuts();
    void showAbout();

    Actions m_actions;
    ResultActions m_resultActions;
    ExemplarStore* m_store;
    RunDesk* m_desk;
    Comparisons* m_comparisons;
    Tries* m_tries;
    QStackedWidget* m_centre = nullptr;
    StartPage* m_start = nullptr;
    RunDisplay* m_display = nullptr;
    ResultView* m_results = nullptr;
    ExemplarEditor* m_editor = nullptr;
    DropTargets* m_drop = nullptr;
    Document* m_document = nullptr;
    UndoHistory* m_undo = nullptr;
    RunRecovery* m_brokenRuns;
    MessageBar* m_messages = nullptr;
    ResultExport* m_export = nullptr;
    ResultInputs* m_resultInputs = nullptr;
    ExemplarPanel* m_exemplars = nullptr;
    Inspector* m_inspector = nullptr;
    MethodHint* m_hint = nullptr;
    RunPanel* m_runPanel = nullptr;
    ResultPanel* m_resultPanel = nullptr;
    JobPanel* m_jobs = nullptr;
    LogPanel* m_log = nullptr;
    LatticeTool* m_lattice = nullptr;
    FiguresPanel* m_figures = nullptr;
    QComboBox* m_method;
    SettingsState m_firstSettings; ///< as the window first opens
    QByteArray m_defaultLayout;
    std::vector<QDockWidget*> m_panels; ///< exemplars, parameters, results, jobs, log, figures
    QTimer m_planTimer;
};

} // namespace texloom::ui
