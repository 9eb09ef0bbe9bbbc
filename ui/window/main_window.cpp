#include "ui/window/main_window.h"

#include "ui/common/appearance.h"
#include "ui/common/background.h"
#include "ui/common/message_bar.h"
#include "ui/common/shortcuts.h"
#include "ui/common/text.h"
#include "ui/compare/compare_view.h"
#include "ui/exemplar/companion_list.h"
#include "ui/exemplar/exemplar_editor.h"
#include "ui/exemplar/exemplar_panel.h"
#include "ui/exemplar/files.h"
#include "ui/inspector/inspector.h"
#include "ui/inspector/output_group.h"
#include "ui/jobs/run_panel.h"
#include "ui/lattice/lattice_tool.h"
#include "ui/maps/result_view.h"
#include "ui/plots/figures_panel.h"
#include "ui/session/document.h"
#include "ui/session/preset_menu.h"
#include "ui/session/undo_history.h"
#include "ui/window/drop_targets.h"
#include "ui/window/readout.h"
#include "ui/window/start_page.h"
#include "ui/window/workbench.h"

#include <QActionGroup>
#include <QApplication>
#include <QCloseEvent>
#include <QComboBox>
#include <QDockWidget>
#include <QFileInfo>
#include <QMenuBar>
#include <QSettings>
#include <QStackedWidget>
#include <QStatusBar>
#include <QToolBar>
#include <QVBoxLayout>

namespace texloom::ui {

namespace {

/// Raised when docks or toolbars change, so that an older layout is not restored over them.
constexpr int kLayoutVersion = 3;
constexpr std::chrono::milliseconds kPlanPause{150};
/// The method that a newcomer meets: quick, and good at most textures.
const QString kFirstMethod = QStringLiteral("quilting");
/// The window's first size in lines and widths of text.
constexpr int kFirstWidth = 180;
constexpr int kFirstHeight = 50;

QDockWidget* dockFor(QWidget* content, const QString& title, const QString& name, QMainWindow* window) {
    auto* dock = new QDockWidget(title, window);
    dock->setObjectName(name);
    dock->setWidget(content);
    dock->setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetFloatable |
                      QDockWidget::DockWidgetClosable);
    return dock;
}

} // namespace

MainWindow::MainWindow(QWidget* parent)
    : QMainWindow(parent), m_actions(this), m_store(new ExemplarStore(this)),
      m_controller(new RunController(this)), m_bench(new Workbench(m_controller, this)),
      m_method(new QComboBox(this)) {
    setObjectName(QStringLiteral("mainWindow"));
    setWindowTitle(tr("Texloom"));
    setAcceptDrops(true);
    m_planTimer.setSingleShot(true);
    m_planTimer.setInterval(kPlanPause);
    connect(&m_planTimer, &QTimer::timeout, this, &MainWindow::plan);

    m_method->setObjectName(QStringLiteral("method"));
    m_method->setAccessibleName(tr("Method"));
    for (const Method& method : methods()) {
        m_method->addItem(translated(method.info().title), QString::fromStdString(method.id()));
        m_method->setItemData(
            m_method->count() - 1,
            tr("%1\n%2").arg(translated(method.info().summary), translated(method.info().citation)),
            Qt::ToolTipRole);
    }
    m_method->setCurrentIndex(m_method->findData(kFirstMethod));
    makeCentre();
    makeDocks();
    m_inspector->setMethod(findMethod(m_method->currentData().toString().toStdString()));
    makeDocument();
    makeMenus();
    makeToolBar();
    m_readout = new Readout(this);
    statusBar()->addWidget(m_readout, 1);
    connectActions();
    connectViewActions();
    connectStore();
    connectRun();
    connectHovers();
    connectLattice();
    connectTools();
    restoreLayout();
    restoreShortcuts(findChildren<QAction*>(QString(), Qt::FindDirectChildrenOnly));
    setTabOrderThrough();
    methodChosen();
    exemplarsChanged();
    m_document->settle();
    plan();
    QTimer::singleShot(0, m_start, &StartPage::refresh);
}

MainWindow::~MainWindow() {
    // A field that loses the focus commits what was typed and tells the window: that must come while it is
    // whole.
    if (QWidget* focused = focusWidget())
        focused->clearFocus();
    hide();
    delete m_controller;
    workers().waitForDone();
    delete m_document; // takes its copy for recovery away, once nobody writes it
}

void MainWindow::makeCentre() {
    auto* middle = new QWidget(this);
    m_messages = new MessageBar(middle);
    m_centre = new QStackedWidget(middle);
    m_start = new StartPage({m_actions.open, m_actions.paste}, m_centre);
    m_results = new ResultView(m_centre);
    m_centre->addWidget(m_start);
    m_centre->addWidget(m_results);
    m_editor = new ExemplarEditor(m_store, m_centre);
    m_centre->addWidget(m_editor);
    m_drop = new DropTargets(middle);
    connect(m_drop, &DropTargets::dropped, this, &MainWindow::dropOn);
    connect(m_drop, &DropTargets::closed, statusBar(), &QStatusBar::clearMessage);
    auto* column = new QVBoxLayout(middle);
    column->addWidget(m_messages);
    column->addWidget(m_centre, 1);
    setCentralWidget(middle);
}

void MainWindow::makeDocks() {
    m_exemplars =
        new ExemplarPanel(m_store, {m_actions.open, m_actions.editExemplar, m_actions.removeExemplar});
    auto* parameters = new QWidget;
    m_inspector = new Inspector(parameters);
    m_runPanel =
        new RunPanel(m_actions.run, m_actions.addToQueue, m_actions.quick, m_actions.stop, parameters);
    auto* column = new QVBoxLayout(parameters);
    column->addWidget(m_inspector, 1);
    column->addWidget(m_runPanel);
    m_lattice = new LatticeTool(m_store, m_inspector, m_results);
    m_results->addPage(
        m_lattice, tr("Lattice"),
        tr("The vectors by which the exemplar repeats itself: found, corrected, and given to the method."));
    addDockWidget(Qt::LeftDockWidgetArea,
                  dockFor(m_exemplars, tr("Exemplars"), QStringLiteral("exemplarDock"), this));
    addDockWidget(Qt::RightDockWidgetArea,
                  dockFor(parameters, tr("Parameters"), QStringLiteral("parameterDock"), this));
    m_bench->addDocks();
    m_bench->addPages(m_results);
    m_figures = new FiguresPanel(this);
    QDockWidget* const figures = dockFor(m_figures, tr("Figures"), QStringLiteral("figureDock"), this);
    addDockWidget(Qt::BottomDockWidgetArea, figures);
    tabifyDockWidget(findChild<QDockWidget*>(QStringLiteral("logDock")), figures);
    connect(figures, &QDockWidget::visibilityChanged, m_figures, &FiguresPanel::setSeen);
    findChild<QDockWidget*>(QStringLiteral("resultDock"))->raise();
}

void MainWindow::makeMenus() {
    QMenu* const file = menuBar()->addMenu(tr("&File"));
    file->addAction(m_actions.open);
    QMenu* const recent = file->addMenu(tr("Open &recent"));
    connect(recent, &QMenu::aboutToShow, this, [this, recent] { fillRecentMenu(recent); });
    QMenu* const samples = file->addMenu(tr("&Samples"));
    for (const QString& path : bundledExemplars())
        samples->addAction(QFileInfo(path).completeBaseName(), this, [this, path] { openFiles({path}); });
    samples->setEnabled(!samples->isEmpty());
    file->addAction(m_actions.paste);
    file->addSeparator();
    m_document->addTo(file);
    file->addSeparator();
    file->addAction(m_actions.exportResult);
    file->addSeparator();
    file->addAction(m_actions.quit);

    QMenu* const edit = menuBar()->addMenu(tr("&Edit"));
    edit->addActions({m_undo->undoAction(), m_undo->redoAction()});
    edit->addSeparator();
    edit->addAction(m_actions.copyResult);
    menuBar()
        ->addMenu(tr("E&xemplar"))
        ->addActions({m_actions.editExemplar, m_actions.addCompanions, m_actions.lattice, m_actions.setMask,
                      m_actions.clearMask, m_actions.removeExemplar});
    QMenu* const synthesis = menuBar()->addMenu(tr("&Synthesis"));
    synthesis->addActions(
        {m_actions.run, m_actions.addToQueue, m_actions.quick, m_actions.stop, m_actions.newSeedRun});
    synthesis->addSeparator();
    synthesis->addActions({m_bench->tryAllAction(), m_bench->trySomeAction(), m_bench->sweepAction()});
    synthesis->addSeparator();
    synthesis->addMenu(makePresetMenu());
    synthesis->addAction(m_actions.resetParameters);
    menuBar()->addMenu(makeViewMenu());
    menuBar()->addMenu(m_bench->makeCompareMenu());
    menuBar()->addMenu(m_bench->makeResultsMenu());
    menuBar()->addMenu(tr("&Tools"))->addActions({m_actions.blend, m_actions.variance, m_actions.stress});
    menuBar()->addMenu(tr("&Help"))->addActions({m_actions.shortcuts, m_actions.about});
}

QMenu* MainWindow::makePresetMenu() {
    auto* menu = new PresetMenu(
        [this] {
            std::vector<RecipeStep> steps = {{m_inspector->method()->id(), m_inspector->changedValues()}};
            const std::vector<RecipeStep> then = m_inspector->then();
            steps.insert(steps.end(), then.begin(), then.end());
            return steps;
        },
        this);
    connect(menu, &PresetMenu::chosen, this, &MainWindow::usePreset);
    connect(menu, &PresetMenu::told, this,
            [this](const QString& text) { m_messages->say(MessageBar::Kind::Information, text); });
    connect(menu, &PresetMenu::failed, this, &MainWindow::fail);
    return menu;
}

QMenu* MainWindow::makeViewMenu() {
    auto* view = new QMenu(tr("&View"), this);
    view->addActions({m_actions.fit, m_actions.actualSize, m_actions.zoomIn, m_actions.zoomOut,
                      m_actions.repeat, m_actions.seams});
    view->addSeparator();
    view->addActions(
        {m_actions.resultTab, m_actions.synthesisTab, m_actions.positionTab, m_actions.copiesTab});
    view->addSeparator();
    for (const auto* dock : findChildren<QDockWidget*>())
        view->addAction(dock->toggleViewAction());
    view->addAction(m_actions.resetLayout);
    view->addSeparator();
    view->addAction(m_actions.fullScreen);
    view->addMenu(makeAppearanceMenu());
    return view;
}

QMenu* MainWindow::makeAppearanceMenu() {
    auto* menu = new QMenu(tr("&Appearance"), this);
    auto* group = new QActionGroup(menu);
    const std::pair<QString, Appearance> ways[] = {{tr("As the &desktop"), Appearance::System},
                                                   {tr("&Light"), Appearance::Light},
                                                   {tr("Da&rk"), Appearance::Dark}};
    for (const auto& [title, appearance] : ways) {
        QAction* const action = menu->addAction(title);
        action->setCheckable(true);
        action->setChecked(savedAppearance() == appearance);
        group->addAction(action);
        connect(action, &QAction::triggered, this, [appearance = appearance] {
            saveAppearance(appearance);
            applyAppearance(appearance);
        });
    }
    return menu;
}

void MainWindow::makeToolBar() {
    QToolBar* const bar = addToolBar(tr("Toolbar"));
    bar->setObjectName(QStringLiteral("toolBar"));
    bar->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    bar->addActions({m_actions.open, m_actions.paste});
    bar->addSeparator();
    bar->addWidget(m_method);
    bar->addActions({m_actions.run, m_actions.stop, m_actions.quick});
    bar->addSeparator();
    bar->addAction(m_actions.repeat);
    bar->addAction(m_bench->tryAllAction());
    bar->addSeparator();
    bar->addAction(m_actions.exportResult);
}

void MainWindow::setTabOrderThrough() {
    QWidget* const exemplars = m_exemplars->findChild<QWidget*>(QStringLiteral("exemplarList"));
    setTabOrder(exemplars, m_method);
    setTabOrder(m_method, m_inspector->findChild<QWidget*>(QStringLiteral("outputWidth")));
    setTabOrder(m_inspector->findChild<QWidget*>(QStringLiteral("then1")),
                m_runPanel->findChild<QWidget*>(QStringLiteral("runButton")));
    setTabOrder(m_runPanel->findChild<QWidget*>(QStringLiteral("stopButton")),
                m_results->viewer(ResultView::ResultTab));
}

void MainWindow::restoreLayout() {
    resize(fontMetrics().averageCharWidth() * kFirstWidth, fontMetrics().height() * kFirstHeight);
    const int side = fontMetrics().averageCharWidth();
    resizeDocks({findChild<QDockWidget*>(QStringLiteral("exemplarDock")),
                 findChild<QDockWidget*>(QStringLiteral("parameterDock"))},
                {side * 38, side * 46}, Qt::Horizontal);
    resizeDocks({findChild<QDockWidget*>(QStringLiteral("resultDock"))}, {fontMetrics().height() * 11},
                Qt::Vertical);
    m_defaultLayout = saveState(kLayoutVersion);
    const QSettings settings;
    restoreGeometry(settings.value(QStringLiteral("window/geometry")).toByteArray());
    restoreState(settings.value(QStringLiteral("window/layout")).toByteArray(), kLayoutVersion);
    connect(m_actions.resetLayout, &QAction::triggered, this,
            [this] { restoreState(m_defaultLayout, kLayoutVersion); });
}

void MainWindow::closeEvent(QCloseEvent* event) {
    QSettings settings;
    settings.setValue(QStringLiteral("window/geometry"), saveGeometry());
    settings.setValue(QStringLiteral("window/layout"), saveState(kLayoutVersion));
    if (!m_document->mayClose())
        return event->ignore();
    m_bench->queue()->clear();
    m_controller->stop();
    QMainWindow::closeEvent(event);
}

void MainWindow::connectActions() {
    connect(m_actions.open, &QAction::triggered, this, &MainWindow::openDialog);
    connect(m_actions.paste, &QAction::triggered, this, &MainWindow::paste);
    connect(m_actions.exportResult, &QAction::triggered, this, &MainWindow::exportDialog);
    connect(m_actions.quit, &QAction::triggered, this, &QWidget::close);
    connect(m_actions.copyResult, &QAction::triggered, this, &MainWindow::copyResult);
    connect(m_actions.editExemplar, &QAction::toggled, this, &MainWindow::editExemplar);
    connect(m_editor, &ExemplarEditor::done, this, [this] { m_actions.editExemplar->setChecked(false); });
    connect(m_actions.addCompanions, &QAction::triggered, m_exemplars->companions(), &CompanionList::choose);
    connect(m_actions.setMask, &QAction::triggered, m_exemplars, &ExemplarPanel::chooseMask);
    connect(m_actions.clearMask, &QAction::triggered, this, [this] {
        if (const ExemplarEntry* entry = m_store->current())
            m_store->clearMask(entry->id);
    });
    connect(m_actions.removeExemplar, &QAction::triggered, this, [this] {
        if (const ExemplarEntry* entry = m_store->current())
            m_store->remove(entry->id);
    });
    connect(m_actions.run, &QAction::triggered, this, [this] {
        if (!m_inspector->output()->seedLocked())
            m_inspector->output()->drawSeed();
        startRun(false);
    });
    connect(m_actions.addToQueue, &QAction::triggered, this, [this] {
        if (!m_inspector->output()->seedLocked())
            m_inspector->output()->drawSeed();
        queueRun();
    });
    connect(m_actions.quick, &QAction::triggered, this, [this] { startRun(true); });
    connect(m_actions.stop, &QAction::triggered, m_controller, &RunController::stop);
    connect(m_actions.newSeedRun, &QAction::triggered, this, [this] {
        m_inspector->output()->drawSeed();
        startRun(false);
    });
    connect(m_actions.resetParameters, &QAction::triggered, m_inspector, &Inspector::resetAll);
    connect(m_actions.shortcuts, &QAction::triggered, this, &MainWindow::showShortcuts);
    connect(m_actions.about, &QAction::triggered, this, &MainWindow::showAbout);
    connect(m_method, &QComboBox::currentIndexChanged, this, &MainWindow::methodChosen);
    connect(m_start, &StartPage::chosen, this, [this](const QString& path) { openFiles({path}); });
}

void MainWindow::connectViewActions() {
    connect(m_actions.fit, &QAction::triggered, this, [this] { frontViewer()->fit(); });
    connect(m_actions.actualSize, &QAction::triggered, this, [this] { frontViewer()->actualSize(); });
    connect(m_actions.zoomIn, &QAction::triggered, this, [this] { frontViewer()->zoomIn(); });
    connect(m_actions.zoomOut, &QAction::triggered, this, [this] { frontViewer()->zoomOut(); });
    connect(m_actions.seams, &QAction::triggered, this, [this] { frontViewer()->showSeams(); });
    connect(m_actions.repeat, &QAction::toggled, m_results, &ResultView::setRepeats);
    connect(m_actions.repeat, &QAction::triggered, this, [this](bool repeat) {
        if (m_bench->compare()->isVisible())
            frontViewer()->setRepeats(repeat);
    });
    for (const auto tab :
         {ResultView::ResultTab, ResultView::SynthesisTab, ResultView::PositionTab, ResultView::CopiesTab})
        connect(m_results->viewer(tab), &ImageViewer::repeatsChanged, m_actions.repeat, &QAction::setChecked);
    connect(m_actions.resultTab, &QAction::triggered, this,
            [this] { m_results->setTab(ResultView::ResultTab); });
    connect(m_actions.synthesisTab, &QAction::triggered, this,
            [this] { m_results->setTab(ResultView::SynthesisTab); });
    connect(m_actions.positionTab, &QAction::triggered, this,
            [this] { m_results->setTab(ResultView::PositionTab); });
    connect(m_actions.copiesTab, &QAction::triggered, this,
            [this] { m_results->setTab(ResultView::CopiesTab); });
    connect(m_actions.fullScreen, &QAction::toggled, this,
            [this](bool full) { setWindowState(windowState().setFlag(Qt::WindowFullScreen, full)); });
}

ImageViewer* MainWindow::frontViewer() const {
    const CompareView* const compare = m_bench->compare();
    return compare->isVisible() ? compare->front() : m_results->currentViewer();
}

void MainWindow::connectStore() {
    connect(m_store, &ExemplarStore::changed, this, &MainWindow::exemplarsChanged);
    connect(m_store, &ExemplarStore::currentChanged, this, &MainWindow::exemplarsChanged);
    connect(m_store, &ExemplarStore::opened, this, &MainWindow::exemplarOpened);
    connect(m_store, &ExemplarStore::failed, this, &MainWindow::fail);
    connect(m_store, &ExemplarStore::loadingChanged, this, &MainWindow::planSoon);
    connect(m_inspector, &Inspector::edited, this, &MainWindow::settingsEdited);
    connect(m_inspector->output(), &OutputGroup::failed, this, &MainWindow::fail);
}

void MainWindow::connectRun() {
    const JobQueue* const queue = m_bench->queue();
    connect(m_controller, &RunController::progressed, m_runPanel, &RunPanel::showProgress);
    connect(queue, &JobQueue::started, this, &MainWindow::runStarted);
    connect(queue, &JobQueue::previewed, this, &MainWindow::runPreviewed);
    connect(queue, &JobQueue::finished, this, &MainWindow::runFinished);
    connect(queue, &JobQueue::stopped, this, &MainWindow::runStopped);
    connect(queue, &JobQueue::failed, this, &MainWindow::runFailed);
    connect(queue, &JobQueue::changed, this, [this, queue] {
        m_runPanel->setRunning(m_controller->running(), queue->waiting());
        updateActions();
    });
}

void MainWindow::connectHovers() {
    connect(m_results, &ResultView::resultHovered, this, &MainWindow::hoverResult);
    connect(m_results, &ResultView::positionHovered, this,
            [this](QPoint pixel) { hoverExemplar(m_store->current(), pixel); });
    connect(m_results, &ResultView::legendChanged, m_exemplars, &ExemplarPanel::setLegend);
    connect(m_results, &ResultView::unhovered, this, &MainWindow::endHover);
    connect(m_exemplars, &ExemplarPanel::hovered, this,
            [this](QPoint pixel) { hoverExemplar(m_store->current(), pixel); });
    connect(m_exemplars, &ExemplarPanel::unhovered, this, &MainWindow::endHover);
    const CompareView* const compare = m_bench->compare();
    connect(compare, &CompareView::hovered, this,
            [this](const QString& label, QPoint pixel, const QString& values) {
                m_readout->show(tr("%1: x %2, y %3").arg(label).arg(pixel.x()).arg(pixel.y()), values,
                                tr("working space · float"));
            });
    connect(compare, &CompareView::unhovered, this, &MainWindow::endHover);
}

} // namespace texloom::ui
