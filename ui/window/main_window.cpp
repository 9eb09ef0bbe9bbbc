#include "ui/window/main_window.h"

#include "ui/common/background.h"
#include "ui/common/message_bar.h"
#include "ui/common/reading_bar.h"
#include "ui/common/shortcuts.h"
#include "ui/common/text.h"
#include "ui/compare/compare_view.h"
#include "ui/compare/comparisons.h"
#include "ui/compare/tries.h"
#include "ui/exemplar/exemplar_editor.h"
#include "ui/exemplar/exemplar_panel.h"
#include "ui/inspector/inspector.h"
#include "ui/inspector/method_chooser.h"
#include "ui/inspector/method_hint.h"
#include "ui/inspector/output_group.h"
#include "ui/jobs/job_panel.h"
#include "ui/jobs/run_panel.h"
#include "ui/lattice/lattice_tool.h"
#include "ui/log/log_panel.h"
#include "ui/maps/result_view.h"
#include "ui/plots/figures_panel.h"
#include "ui/ports/exemplar_inputs.h"
#include "ui/ports/port_painting.h"
#include "ui/ports/result_inputs.h"
#include "ui/results/limits_dialog.h"
#include "ui/session/document.h"
#include "ui/session/run_recovery.h"
#include "ui/session/undo_history.h"
#include "ui/window/drop_targets.h"
#include "ui/window/hovers.h"
#include "ui/window/readout.h"
#include "ui/window/result_export.h"
#include "ui/window/result_offers.h"
#include "ui/window/run_display.h"
#include "ui/window/run_notice.h"
#include "ui/window/start_page.h"
#include "ui/window/zoom_box.h"

#include <QAction>
#include <QCloseEvent>
#include <QComboBox>
#include <QDockWidget>
#include <QScreen>
#include <QSettings>
#include <QStackedWidget>
#include <QStatusBar>
#include <QUndoStack>
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
/// On screens wider than this it fills most of them.
constexpr int kSmallScreen = 1000;
/// Screens of fewer points than both show all panels on one another at first: 1920 × 1080 at twice the size.
constexpr int kStackedWidth = 1100, kStackedHeight = 640;
const QString kStacked = QStringLiteral("window/stacked");
constexpr double kShareOfScreen = 0.92;

} // namespace

MainWindow::MainWindow(QWidget* parent)
    : QMainWindow(parent), m_actions(this), m_resultActions(this), m_store(new ExemplarStore(this)),
      m_desk(new RunDesk(resultFolder(), this)), m_comparisons(new Comparisons(m_desk, m_store, this)),
      m_tries(new Tries(
          m_desk, m_store, m_comparisons, [this] { return input(false); }, [this] { return m_hint->order(); },
          this)),
      m_brokenRuns(new RunRecovery(m_desk, this)), m_method(new QComboBox(this)) {
    setObjectName(QStringLiteral("mainWindow"));
    setWindowTitle(tr("Texloom"));
    setAcceptDrops(true);
    m_planTimer.setSingleShot(true);
    m_planTimer.setInterval(kPlanPause);
    connect(&m_planTimer, &QTimer::timeout, this, &MainWindow::plan);

    fillMethods();
    makeCentre();
    makeDocks();
    m_inspector->setMethod(findMethod(m_method->currentData().toString().toStdString()));
    makeDocument();
    connectRecovery();
    makeMenus();
    makeToolBar();
    auto* readout = new Readout(this);
    statusBar()->addWidget(readout, 1);
    auto* zoom = new ZoomBox([this] { return frontViewer(); }, this);
    for (const auto tab :
         {ResultView::ResultTab, ResultView::SynthesisTab, ResultView::PositionTab, ResultView::CopiesTab})
        zoom->follow(m_results->viewer(tab));
    connect(m_results, &ResultView::tabShown, zoom, &ZoomBox::refresh);
    statusBar()->addPermanentWidget(zoom);
    m_display = new RunDisplay(m_desk, {m_results, m_figures, m_runPanel, m_messages}, this);
    new RunNotice(m_desk, this);
    connectSolids();
    auto* offers = new ResultOffers(m_desk, m_store, m_results, m_actions.repeat, this);
    connect(offers, &ResultOffers::runWanted, this, &MainWindow::runLike);
    new Hovers(m_desk, m_store, {m_results, m_exemplars, m_comparisons->view(), readout}, this);
    connectActions();
    connectRunActions();
    connectViewActions();
    connectStore();
    connectDesk();
    connectResults();
    connectLattice();
    connectTools();
    restoreLayout();
    restoreShortcuts(findChildren<QAction*>(QString(), Qt::FindDirectChildrenOnly));
    setTabOrderThrough();
    methodChosen();
    reserveKeys();
    m_firstSettings = settingsOf(*m_method, *m_inspector);
    exemplarsChanged();
    m_document->settle();
    plan();
    QTimer::singleShot(0, m_start, &StartPage::refresh);
}

void MainWindow::fillMethods() {
    m_method->setObjectName(QStringLiteral("method"));
    m_method->setAccessibleName(tr("Method"));
    fillWithMethods(m_method, [](const MethodInfo&) { return true; });
    addAbsentMethods(m_method);
    m_method->setCurrentIndex(m_method->findData(kFirstMethod));
}

MainWindow::~MainWindow() {
    // A field that loses the focus commits what was typed and tells the window: that must come while it is
    // whole.
    if (QWidget* focused = focusWidget())
        focused->clearFocus();
    hide();
    m_desk->halt();
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
    connect(m_drop, &DropTargets::droppedInto, this, &MainWindow::dropInto);
    connect(m_drop, &DropTargets::closed, statusBar(), &QStatusBar::clearMessage);
    m_export = new ResultExport(m_desk, m_messages, this);
    auto* column = new QVBoxLayout(middle);
    column->addWidget(m_messages);
    column->addWidget(new ReadingBar(middle));
    column->addWidget(m_centre, 1);
    setCentralWidget(middle);
}

void MainWindow::makeDocks() {
    m_exemplars =
        new ExemplarPanel(m_store, {m_actions.open, m_actions.editExemplar, m_actions.removeExemplar});
    auto* parameters = new QWidget;
    m_inspector = new Inspector(parameters);
    m_resultInputs = new ResultInputs(m_desk, m_store, m_inspector->output(), this);
    new ExemplarInputs(m_store, m_inspector->output(), this);
    auto* painting = new PortPainting(m_desk, m_store, m_inspector, this);
    connect(painting, &PortPainting::failed, this, &MainWindow::fail);
    connect(painting, &PortPainting::told, this,
            [this](const QString& text) { m_messages->say(MessageBar::Kind::Information, text); });
    connect(m_actions.extend, &QAction::triggered, painting, &PortPainting::extend);
    m_runPanel = new RunPanel(
        {m_actions.run, m_actions.addToQueue, m_actions.quick, m_actions.stop, m_actions.cancelRun},
        parameters);
    auto* column = new QVBoxLayout(parameters);
    m_hint = new MethodHint(parameters);
    connect(m_hint, &MethodHint::methodWanted, this,
            [this](const QString& id) { m_method->setCurrentIndex(m_method->findData(id)); });
    column->addWidget(m_hint);
    column->addWidget(m_inspector, 1);
    column->addWidget(m_runPanel);
    m_lattice = new LatticeTool(m_store, m_inspector, m_results);
    m_results->addPage(
        m_lattice, tr("Lattice"),
        tr("The vectors by which the exemplar repeats itself: found, corrected, and given to the method."));
    m_results->addPage(m_comparisons->view(), tr("Compare"),
                       tr("Several results and exemplars beside one another."));
    m_resultPanel = new ResultPanel(m_desk->history(), m_resultActions);
    m_jobs = new JobPanel(m_desk->queue());
    m_log = new LogPanel;
    m_figures = new FiguresPanel(this);
    addDock(m_exemplars, tr("Exemplars"), "exemplarDock");
    addDock(parameters, tr("Parameters"), "parameterDock");
    addDock(m_resultPanel, tr("Results"), "resultDock");
    addDock(m_jobs, tr("Jobs"), "jobDock");
    addDock(m_log, tr("Log"), "logDock");
    const QDockWidget* const figures = addDock(m_figures, tr("Figures"), "figureDock");
    connect(figures, &QDockWidget::visibilityChanged, m_figures, &FiguresPanel::setSeen);
    arrangePanels(false);
}

QDockWidget* MainWindow::addDock(QWidget* content, const QString& title, const char* name) {
    auto* dock = new QDockWidget(title, this);
    dock->setObjectName(QLatin1String(name));
    dock->setWidget(content);
    m_panels.push_back(dock);
    return dock;
}

/// Exemplars at the left, parameters at the right, the others on one another at the bottom; or all on one
/// another at the right, which leaves the picture most of a small screen.
void MainWindow::arrangePanels(bool stacked) {
    QDockWidget* const parameters = m_panels[1];
    QDockWidget* last = nullptr;
    for (QDockWidget* panel : m_panels) {
        const bool beside = panel == m_panels.front() || panel == parameters;
        addDockWidget(stacked || panel == parameters ? Qt::RightDockWidgetArea
                      : panel == m_panels.front()    ? Qt::LeftDockWidgetArea
                                                     : Qt::BottomDockWidgetArea,
                      panel);
        if (last != nullptr && (stacked || !beside))
            tabifyDockWidget(last, panel);
        last = stacked || !beside ? panel : nullptr;
        panel->setFloating(false);
        panel->show();
    }
    (stacked ? parameters : m_panels[2])->raise();
    const int side = fontMetrics().averageCharWidth();
    if (stacked)
        return resizeDocks({parameters}, {side * 46}, Qt::Horizontal);
    resizeDocks({m_panels.front(), parameters}, {side * 38, side * 46}, Qt::Horizontal);
    resizeDocks({m_panels[2]}, {fontMetrics().height() * 11}, Qt::Vertical);
}

void MainWindow::setTabOrderThrough() {
    QWidget* const exemplars = m_exemplars->findChild<QWidget*>(QStringLiteral("exemplarList"));
    setTabOrder(exemplars, m_method);
    setTabOrder(m_method, m_inspector->findChild<QWidget*>(QStringLiteral("outputWidth")));
    setTabOrder(m_inspector->findChild<QWidget*>(QStringLiteral("then1")),
                m_runPanel->findChild<QWidget*>(QStringLiteral("runButton")));
    setTabOrder(m_runPanel->findChild<QWidget*>(QStringLiteral("cancelRunButton")),
                m_results->viewer(ResultView::ResultTab));
}

void MainWindow::restoreLayout() {
    const QSize room = screen()->availableGeometry().size();
    if (room.width() > kSmallScreen)
        resize(room * kShareOfScreen);
    else
        resize(fontMetrics().averageCharWidth() * kFirstWidth, fontMetrics().height() * kFirstHeight);
    const bool small = room.width() < kStackedWidth && room.height() < kStackedHeight;
    const QSettings settings;
    m_actions.stackPanels->setChecked(settings.value(kStacked, small).toBool());
    arrangePanels(m_actions.stackPanels->isChecked());
    m_defaultLayout = saveState(kLayoutVersion);
    restoreGeometry(settings.value(QStringLiteral("window/geometry")).toByteArray());
    restoreState(settings.value(QStringLiteral("window/layout")).toByteArray(), kLayoutVersion);
    connect(m_actions.resetLayout, &QAction::triggered, this, [this] {
        restoreState(m_defaultLayout, kLayoutVersion); // bars, too
        arrangePanels(m_actions.stackPanels->isChecked());
    });
    connect(m_actions.stackPanels, &QAction::toggled, this, [this](bool stacked) {
        QSettings().setValue(kStacked, stacked);
        arrangePanels(stacked);
    });
}

void MainWindow::closeEvent(QCloseEvent* event) {
    QSettings settings;
    settings.setValue(QStringLiteral("window/geometry"), saveGeometry());
    settings.setValue(QStringLiteral("window/layout"), saveState(kLayoutVersion));
    if (!m_document->mayClose())
        return event->ignore();
    m_desk->breakOff();
    QMainWindow::closeEvent(event);
}

void MainWindow::connectStore() {
    connect(m_store, &ExemplarStore::changed, this, &MainWindow::exemplarsChanged);
    connect(m_store, &ExemplarStore::currentChanged, this, &MainWindow::exemplarsChanged);
    connect(m_store, &ExemplarStore::opened, this, &MainWindow::exemplarOpened);
    connect(m_store, &ExemplarStore::layerWanted, this, &MainWindow::askForLayer);
    connect(m_store, &ExemplarStore::failed, this, &MainWindow::fail);
    connect(m_store, &ExemplarStore::loadingChanged, this, &MainWindow::planSoon);
    connect(m_inspector, &Inspector::edited, this, &MainWindow::settingsEdited);
    connect(m_inspector->output(), &OutputGroup::failed, this, &MainWindow::fail);
    connect(m_inspector->output(), &OutputGroup::exemplarWanted, this, [this](const QString& path) {
        if (path.isEmpty())
            openDialog();
        else
            openFiles({path});
    });
    connect(m_inspector->output(), &OutputGroup::resultLookedAt, this, [this] {
        showResults();
        m_results->setTab(ResultView::ResultTab);
    });
}

void MainWindow::connectDesk() {
    connect(m_desk, &RunDesk::changed, this, &MainWindow::updateActions);
    connect(m_desk, &RunDesk::noted, m_log, &LogPanel::add);
    connect(m_desk, &RunDesk::outlookChanged, this, [this](const Outlook& outlook) {
        m_actions.quick->setToolTip(outlook.quickRefusal.isEmpty() ? m_actions.quick->statusTip()
                                                                   : outlook.quickRefusal);
    });
    connect(m_desk, &RunDesk::watching, this, [this] {
        m_results->setTab(ResultView::ResultTab);
        showResults(); // also from the start page, where no exemplar is open
    });
    connect(m_desk, &RunDesk::shown, this, [this](const ShownResult& shown) {
        if (m_centre->currentWidget() != m_editor) // who edits is not taken away from it
            showResults();
        m_resultPanel->select({shown.key});
    });
    connect(m_jobs, &JobPanel::watchWanted, m_desk, &RunDesk::watch);
}

void MainWindow::connectResults() {
    restoreLimits(*m_desk->history());
    connect(m_resultPanel, &ResultPanel::showWanted, this, [this](const std::string& key) {
        showResults();
        m_results->setTab(ResultView::ResultTab);
        m_desk->show(key);
    });
    connect(m_resultPanel, &ResultPanel::restoreWanted, this, &MainWindow::restoreResult);
    connect(m_resultPanel, &ResultPanel::compareWanted, m_comparisons, &Comparisons::compareChosen);
    connect(m_resultPanel, &ResultPanel::removed, this, &MainWindow::offerToPutBack);
    connect(m_comparisons, &Comparisons::ready, this, [this] {
        showResults();
        m_results->showPage(m_comparisons->view());
    });
    connect(m_comparisons, &Comparisons::useWanted, this, &MainWindow::restoreResult);
    connect(m_comparisons, &Comparisons::failed, this, &MainWindow::fail);
    connect(m_tries, &Tries::failed, this, &MainWindow::fail);
    connect(m_comparisons, &Comparisons::told, this,
            [this](const QString& text) { m_messages->say(MessageBar::Kind::Information, text); });
    connect(m_export, &ResultExport::failed, this, &MainWindow::fail);
    connect(m_resultInputs, &ResultInputs::failed, this, &MainWindow::fail);
}

/// Says that results were removed, until that is undone in one way or another.
void MainWindow::offerToPutBack(const std::vector<std::string>& keys, const QString& sentence) {
    QUndoStack* const stack = m_undo->stack();
    m_undo->removed(m_desk->history(), keys);
    m_messages->say(MessageBar::Kind::Information, sentence, tr("Undo"),
                    [this, stack, keys, at = stack->index()] {
                        if (stack->index() == at)
                            stack->undo();
                        else // other steps came after it
                            m_desk->history()->putBack(keys);
                    });
    connect(
        m_desk->history(), &ResultHistory::rowsInserted, m_messages,
        [this, sentence] {
            if (m_messages->text() == sentence)
                m_messages->dismiss();
        },
        Qt::SingleShotConnection);
}

CompareView* MainWindow::compare() const {
    return m_comparisons->view();
}

} // namespace texloom::ui
