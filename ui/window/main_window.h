#pragma once

#include "core/session/preset.h"
#include "core/session/run.h"
#include "ui/exemplar/exemplar_store.h"
#include "ui/jobs/run_controller.h"
#include "ui/window/actions.h"

#include <QMainWindow>
#include <QTimer>

#include <memory>
#include <optional>

class QComboBox;
class QMenu;
class QMimeData;
class QStackedWidget;

namespace texloom::ui {

class ExemplarPanel;
class ExportDialog;
class Inspector;
class MessageBar;
class Readout;
class ResultView;
class RunPanel;
class StartPage;

/// The window: exemplars on the left, pictures in the middle, parameters on the right. It joins what the
/// parts say to one another and does no work itself.
class MainWindow : public QMainWindow {
    Q_OBJECT

public:
    explicit MainWindow(QWidget* parent = nullptr);
    ~MainWindow() override;

    /// Opens pictures as exemplars, and recipes.
    void openFiles(const QStringList& paths);
    /// Starts a run with the settings as they stand. @param quick at a preview's size.
    void startRun(bool quick);
    /// What a run would be given now.
    RunInput input(bool quick) const;
    /// Takes over everything that a recipe says.
    void restore(const RunInput& input);

    ExemplarStore* store() const { return m_store; }
    RunController* controller() const { return m_controller; }
    Inspector* inspector() const { return m_inspector; }
    ResultView* results() const { return m_results; }
    MessageBar* messages() const { return m_messages; }
    RunPanel* runPanel() const { return m_runPanel; }
    ExemplarPanel* exemplarPanel() const { return m_exemplars; }
    /// The last finished result; null if there is none.
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
    void connectStore();
    void connectRun();
    void connectHovers();
    void restoreLayout();

    void fillRecentMenu(QMenu* menu);
    void openDialog();
    void paste();
    void take(const QMimeData& offered);
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
    void runStarted();
    void runPreviewed(const RunPictures& pictures);
    void runFinished(const std::shared_ptr<const Result>& result, const RunPictures& pictures);
    void runStopped(double fraction);
    void runFailed(const QString& sentence);
    void showResult();
    void fail(const QString& sentence);

    void hoverResult(QPoint pixel);
    void hoverExemplar(const ExemplarEntry* entry, QPoint pixel);
    void endHover();
    void showShortcuts();
    void showAbout();

    Actions m_actions;
    ExemplarStore* m_store;
    RunController* m_controller;
    QStackedWidget* m_centre = nullptr;
    StartPage* m_start = nullptr;
    ResultView* m_results = nullptr;
    MessageBar* m_messages = nullptr;
    ExemplarPanel* m_exemplars = nullptr;
    Inspector* m_inspector = nullptr;
    RunPanel* m_runPanel = nullptr;
    Readout* m_readout = nullptr;
    QComboBox* m_method;
    QByteArray m_defaultLayout;
    QTimer m_planTimer;
    bool m_canRun = false;
    bool m_canQuick = false;
    bool m_starting = false;
    int m_planRequest = 0;

    std::vector<Exemplar> m_shownExemplars; ///< of the run whose pictures are shown
    std::shared_ptr<const Result> m_result;
    RunPictures m_resultPictures;
    bool m_resultQuick = false;
    bool m_resultShown = false;
};

} // namespace texloom::ui
