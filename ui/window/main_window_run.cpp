#include "core/session/run/exemplar_use.h"
#include "ui/common/background.h"
#include "ui/common/menu_keys.h"
#include "ui/common/message_bar.h"
#include "ui/compare/tries.h"
#include "ui/exemplar/exemplar_editor.h"
#include "ui/exemplar/exemplar_panel.h"
#include "ui/inspector/inspector.h"
#include "ui/inspector/method_hint.h"
#include "ui/inspector/output_group.h"
#include "ui/jobs/run_panel.h"
#include "ui/lattice/lattice_tool.h"
#include "ui/log/log_panel.h"
#include "ui/maps/result_view.h"
#include "ui/runs/quick_run.h"
#include "ui/session/document.h"
#include "ui/session/undo_history.h"
#include "ui/volume/volume_page.h"
#include "ui/window/main_window.h"
#include "ui/window/result_export.h"
#include "ui/window/run_display.h"

#include <QAction>
#include <QComboBox>
#include <QMenuBar>
#include <QStackedWidget>

#include <algorithm>
#include <utility>

namespace texloom::ui {

std::vector<RunExemplar> MainWindow::usedExemplars() const {
    std::vector<RunExemplar> all;
    std::vector<bool> ticked;
    std::size_t current = 0;
    for (const ExemplarEntry& entry : m_store->entries()) {
        if (&entry == m_store->current())
            current = all.size();
        all.push_back(entry.exemplar);
        ticked.push_back(entry.checked);
    }
    return exemplarsFor(m_inspector->steps(), all, ticked, current);
}

RunInput MainWindow::input(bool quick) const {
    const OutputGroup* const output = m_inspector->output();
    RunInput input;
    input.steps = m_inspector->steps();
    input.exemplars = usedExemplars();
    input.size = output->outputSize();
    input.wrap = output->wrap();
    input.seed = output->seed();
    input.threads = output->threads();
    input.region = output->part();
    input.inputs = output->inputs();
    return quick ? quickOf(std::move(input)) : input;
}

void MainWindow::methodChosen() {
    m_undo->asOne(
        [this] { m_inspector->setMethod(findMethod(m_method->currentData().toString().toStdString())); });
    m_method->setToolTip(m_method->currentData(Qt::ToolTipRole).toString());
    reserveMenuKeys(menuBar(), this); // the form's labels are new
    settingsEdited();
}

void MainWindow::settingsEdited() {
    const ExemplarUse use = useOf(m_inspector->steps());
    m_exemplars->setAbilities(use);
    m_editor->setMaskUsed(use.masks);
    m_undo->settingsEdited();
    m_document->touch();
    planSoon();
}

void MainWindow::usePreset(const Preset& preset) {
    m_undo->asOne([this, &preset] {
        m_method->setCurrentIndex(m_method->findData(QString::fromStdString(preset.steps.front().method)));
        m_inspector->setSteps(preset.steps);
    });
}

void MainWindow::exemplarsChanged() {
    const bool any = !m_store->entries().empty() || m_desk->result() ||
                     (m_display != nullptr && !m_display->volumes()->empty());
    if (m_centre->currentWidget() != m_editor || m_store->entries().empty())
        m_centre->setCurrentIndex(any ? 1 : 0);
    const UndoHistory::Pause pause(m_undo);
    m_document->touch();
    const std::vector<RunExemplar> used = usedExemplars();
    const ExemplarEntry* const current = m_store->current();
    // The size of what is open helps methods without exemplars, too.
    m_inspector->setExemplarSize(!used.empty()        ? used.front().image.image->size()
                                 : current != nullptr ? current->file().image->size()
                                                      : Size{});
    std::vector<Size> sizes;
    for (const RunExemplar& exemplar : used)
        sizes.push_back(exemplar.image.image->size());
    m_inspector->output()->setExemplarSizes(sizes);
    m_lattice->followExemplar();
    m_hint->setExemplar(current != nullptr ? current->file().image : nullptr);

    int index = 0;
    for (std::size_t i = 0; i < used.size(); ++i)
        if (current != nullptr && used[i].image.image == current->file().image)
            index = static_cast<int>(i);
    m_results->setExemplar(current, index, std::max(1, static_cast<int>(used.size())));
    updateActions();
    planSoon();
}

void MainWindow::planSoon() {
    m_planTimer.start();
}

void MainWindow::plan() {
    if (!m_store->entries().empty() || !useOf(m_inspector->steps()).needed)
        return m_desk->lookAhead(input(false));
    m_desk->lookAway();
    m_runPanel->setHint(m_store->loading() > 0 ? tr("Reading the picture…") : tr("Open an exemplar first."));
}

void MainWindow::updateActions() {
    for (QAction* action : {m_actions.run, m_actions.newSeedRun, m_actions.addToQueue})
        action->setEnabled(m_desk->canRun());
    m_actions.quick->setEnabled(m_desk->canQuick());
    m_tries->updateActions();
    for (QAction* action : {m_actions.stop, m_actions.cancelRun})
        action->setEnabled(m_desk->running());
    m_actions.exportResult->setEnabled(m_desk->resultShown());
    m_actions.exportAgain->setEnabled(m_desk->resultShown() && ResultExport::knowsHow());
    m_actions.copyResult->setEnabled(m_desk->resultShown());
    const ExemplarEntry* const current = m_store->current();
    const ExemplarUse use = useOf(m_inspector->steps());
    m_actions.stress->setEnabled(m_desk->canRun() && use.any && current != nullptr);
    m_actions.editExemplar->setEnabled(current != nullptr);
    m_actions.addCompanions->setEnabled(current != nullptr);
    m_actions.setMask->setEnabled(current != nullptr && use.masks);
    m_actions.clearMask->setEnabled(current != nullptr && current->exemplar.mask);
    m_actions.removeExemplar->setEnabled(current != nullptr);
    m_actions.lattice->setEnabled(current != nullptr);
}

void MainWindow::startRun(bool quick) {
    m_desk->run(input(false), quick);
}

bool MainWindow::lookAtExemplarsOf(const Recipe& recipe) {
    std::vector<int> ids;
    for (const RecipeExemplar& wanted : recipe.exemplars) {
        const auto& open = m_store->entries();
        const auto found = std::find_if(open.begin(), open.end(), [&](const ExemplarEntry& entry) {
            return entry.file().path == wanted.image.path;
        });
        if (found == open.end())
            return false;
        ids.push_back(found->id);
    }
    if (!ids.empty())
        m_store->setCurrent(ids.front());
    for (const ExemplarEntry& entry : std::vector(m_store->entries()))
        if (!ids.empty())
            m_store->setChecked(entry.id, std::find(ids.begin(), ids.end(), entry.id) != ids.end());
    return true;
}

/// Takes over a result's settings, on its exemplars as they are now where they are open, and runs.
void MainWindow::runLike(const Recipe& recipe, bool quick) {
    Recipe wanted = recipe;
    const bool open = lookAtExemplarsOf(recipe);
    if (open)
        wanted.exemplars.clear();
    inBackground(
        this, [wanted] { return loadRecipe(wanted); },
        [this, quick, open](RunInput input) {
            if (quick)
                input.size = m_inspector->output()->outputSize();
            restore(input);
            if (open || input.exemplars.empty())
                return startRun(quick);
            connect(
                m_store, &ExemplarStore::replaced, this, [this, quick] { startRun(quick); },
                Qt::SingleShotConnection);
        },
        [this](const QString& why) { fail(why); });
}

void MainWindow::showResults() {
    m_actions.editExemplar->setChecked(false);
    m_centre->setCurrentIndex(1);
}

void MainWindow::restoreResult(const std::string& key) {
    if (const ResultEntry* entry = m_desk->history()->find(key))
        restoreRecipe(entry->recipe, entry->quick);
}

void MainWindow::fail(const QString& sentence) {
    m_log->add(sentence);
    m_messages->say(MessageBar::Kind::Error, sentence);
}

} // namespace texloom::ui
