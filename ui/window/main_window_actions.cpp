#include "ui/common/message_bar.h"
#include "ui/compare/compare_view.h"
#include "ui/compare/comparisons.h"
#include "ui/compare/tries.h"
#include "ui/exemplar/companion_list.h"
#include "ui/exemplar/exemplar_editor.h"
#include "ui/exemplar/exemplar_panel.h"
#include "ui/inspector/inspector.h"
#include "ui/inspector/output_group.h"
#include "ui/maps/result_view.h"
#include "ui/window/main_window.h"
#include "ui/window/result_export.h"
#include "ui/window/start_page.h"

#include <QAction>
#include <QComboBox>

namespace texloom::ui {

void MainWindow::connectActions() {
    connect(m_actions.open, &QAction::triggered, this, &MainWindow::openDialog);
    connect(m_actions.paste, &QAction::triggered, this, &MainWindow::paste);
    connect(m_actions.exportResult, &QAction::triggered, m_export, &ResultExport::openDialog);
    connect(m_actions.exportAgain, &QAction::triggered, m_export, &ResultExport::exportAgain);
    connect(m_actions.quit, &QAction::triggered, this, &QWidget::close);
    connect(m_actions.copyResult, &QAction::triggered, m_export, &ResultExport::copy);
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
    connect(m_actions.resetParameters, &QAction::triggered, m_inspector, &Inspector::resetAll);
    connect(m_actions.shortcuts, &QAction::triggered, this, &MainWindow::showShortcuts);
    connect(m_actions.about, &QAction::triggered, this, &MainWindow::showAbout);
    connect(m_method, &QComboBox::currentIndexChanged, this, &MainWindow::methodChosen);
    connect(m_start, &StartPage::chosen, this, [this](const QString& path) { openFiles({path}); });
}

void MainWindow::connectRunActions() {
    connect(m_actions.run, &QAction::triggered, this, [this] {
        drawSeedUnlessLocked();
        startRun(false);
    });
    connect(m_actions.addToQueue, &QAction::triggered, this, [this] {
        drawSeedUnlessLocked();
        m_desk->enqueue(input(false));
    });
    connect(m_actions.quick, &QAction::triggered, this, [this] { startRun(true); });
    connect(m_actions.stop, &QAction::triggered, this, &MainWindow::stopRuns);
    connect(m_actions.cancelRun, &QAction::triggered, m_desk, &RunDesk::cancel);
    connect(m_actions.newSeedRun, &QAction::triggered, this, [this] {
        m_inspector->output()->drawSeed();
        startRun(false);
    });
}

/// Ends the run under way; of many that are made to be compared those that wait, too.
void MainWindow::stopRuns() {
    const int left = m_tries->stop().value_or(0);
    m_desk->stopAndKeep();
    if (left > 0)
        m_messages->sayBriefly(left == 1 ? tr("Stopped. One run that waited was given up.")
                                         : tr("Stopped. %1 runs that waited were given up.").arg(left));
}

void MainWindow::drawSeedUnlessLocked() {
    if (!m_inspector->output()->seedLocked())
        m_inspector->output()->drawSeed();
}

void MainWindow::connectViewActions() {
    connect(m_actions.fit, &QAction::triggered, this, [this] { frontViewer()->fit(); });
    connect(m_actions.actualSize, &QAction::triggered, this, [this] { frontViewer()->actualSize(); });
    connect(m_actions.zoomIn, &QAction::triggered, this, [this] { frontViewer()->zoomIn(); });
    connect(m_actions.zoomOut, &QAction::triggered, this, [this] { frontViewer()->zoomOut(); });
    connect(m_actions.navigator, &QAction::triggered, this, [this] { frontViewer()->toggleNavigator(); });
    connect(m_actions.scope, &QAction::triggered, this, [this] { frontViewer()->showNextScope(); });
    connect(m_actions.seams, &QAction::triggered, this, [this] { frontViewer()->showSeams(); });
    connect(m_actions.repeat, &QAction::toggled, m_results, &ResultView::setRepeats);
    connect(m_actions.repeat, &QAction::triggered, this, [this](bool repeat) {
        if (m_comparisons->view()->isVisible())
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
    const CompareView* const compare = m_comparisons->view();
    return compare->isVisible() ? compare->front() : m_results->currentViewer();
}

} // namespace texloom::ui
