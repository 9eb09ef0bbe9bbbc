#include "ui/common/message_bar.h"
#include "ui/compare/tries.h"
#include "ui/exemplar/exemplar_editor.h"
#include "ui/exemplar/exemplar_panel.h"
#include "ui/inspector/inspector.h"
#include "ui/inspector/output_group.h"
#include "ui/jobs/run_panel.h"
#include "ui/lattice/lattice_tool.h"
#include "ui/log/log_panel.h"
#include "ui/maps/result_view.h"
#include "ui/runs/quick_run.h"
#include "ui/session/document.h"
#include "ui/session/undo_history.h"
#include "ui/window/main_window.h"

#include <QAction>
#include <QComboBox>
#include <QStackedWidget>

#include <algorithm>
#include <utility>

namespace texloom::ui {

std::vector<RunExemplar> MainWindow::usedExemplars() const {
    std::vector<RunExemplar> used;
    const bool several = m_inspector->allMethods(&MethodInfo::severalExemplars);
    const bool masks = m_inspector->allMethods(&MethodInfo::usesMask);
    const bool weights = m_inspector->allMethods(&MethodInfo::weighsExemplars);
    for (const ExemplarEntry& entry : m_store->entries())
        if (several ? entry.checked : &entry == m_store->current()) {
            used.push_back(entry.exemplar);
            if (!masks)
                used.back().mask.reset();
            if (!weights)
                used.back().weight = 1;
        }
    return used;
}

RunInput MainWindow::input(bool quick) const {
    const OutputGroup* const output = m_inspector->output();
    RunInput input;
    input.method = m_inspector->method()->id();
    input.settings = m_inspector->values();
    input.then = m_inspector->then();
    input.exemplars = usedExemplars();
    input.size = output->outputSize();
    input.wrap = output->wrap();
    input.seed = output->seed();
    input.threads = output->threads();
    input.region = output->part();
    input.initial = output->initial();
    return quick ? quickOf(std::move(input)) : input;
}

void MainWindow::methodChosen() {
    m_undo->asOne(
        [this] { m_inspector->setMethod(findMethod(m_method->currentData().toString().toStdString())); });
    m_method->setToolTip(m_method->currentData(Qt::ToolTipRole).toString());
    settingsEdited();
}

void MainWindow::settingsEdited() {
    m_exemplars->setAbilities({m_inspector->allMethods(&MethodInfo::severalExemplars),
                               m_inspector->allMethods(&MethodInfo::weighsExemplars),
                               m_inspector->allMethods(&MethodInfo::usesMask)});
    m_editor->setMaskUsed(m_inspector->allMethods(&MethodInfo::usesMask));
    m_undo->settingsEdited();
    m_document->touch();
    planSoon();
}

void MainWindow::usePreset(const Preset& preset) {
    m_undo->asOne([this, &preset] {
        const RecipeStep& first = preset.steps.front();
        m_method->setCurrentIndex(m_method->findData(QString::fromStdString(first.method)));
        m_inspector->setValues(first.parameters);
        m_inspector->setThen({preset.steps.begin() + 1, preset.steps.end()});
    });
}

void MainWindow::exemplarsChanged() {
    const bool any = !m_store->entries().empty() || m_desk->result();
    if (m_centre->currentWidget() != m_editor || m_store->entries().empty())
        m_centre->setCurrentIndex(any ? 1 : 0);
    const UndoHistory::Pause pause(m_undo);
    m_document->touch();
    const std::vector<RunExemplar> used = usedExemplars();
    m_inspector->setExemplarSize(used.empty() ? Size{} : used.front().image.image->size());
    m_lattice->followExemplar();

    const ExemplarEntry* const current = m_store->current();
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
    if (!m_store->entries().empty())
        return m_desk->lookAhead(input(false));
    m_desk->lookAway();
    m_runPanel->setHint(m_store->loading() > 0 ? tr("Reading the picture…") : tr("Open an exemplar first."));
}

void MainWindow::updateActions() {
    for (QAction* action : {m_actions.run, m_actions.newSeedRun, m_actions.addToQueue})
        action->setEnabled(m_desk->canRun());
    m_actions.quick->setEnabled(m_desk->canQuick());
    m_actions.stress->setEnabled(m_desk->canRun());
    m_tries->updateActions();
    m_actions.stop->setEnabled(m_desk->running());
    m_actions.exportResult->setEnabled(m_desk->resultShown());
    m_actions.copyResult->setEnabled(m_desk->resultShown());
    const ExemplarEntry* const current = m_store->current();
    const bool masks = m_inspector->allMethods(&MethodInfo::usesMask);
    m_actions.editExemplar->setEnabled(current != nullptr);
    m_actions.addCompanions->setEnabled(current != nullptr);
    m_actions.setMask->setEnabled(current != nullptr && masks);
    m_actions.clearMask->setEnabled(current != nullptr && current->exemplar.mask);
    m_actions.removeExemplar->setEnabled(current != nullptr);
    m_actions.lattice->setEnabled(current != nullptr);
}

void MainWindow::startRun(bool quick) {
    m_desk->run(input(false), quick);
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
