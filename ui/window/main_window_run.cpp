#include "core/base/text.h"
#include "ui/common/background.h"
#include "ui/common/message_bar.h"
#include "ui/common/text.h"
#include "ui/compare/compare_view.h"
#include "ui/exemplar/exemplar_editor.h"
#include "ui/exemplar/exemplar_panel.h"
#include "ui/inspector/inspector.h"
#include "ui/inspector/output_group.h"
#include "ui/jobs/run_panel.h"
#include "ui/lattice/lattice_tool.h"
#include "ui/log/log_panel.h"
#include "ui/maps/result_view.h"
#include "ui/plots/figures_panel.h"
#include "ui/session/document.h"
#include "ui/session/undo_history.h"
#include "ui/window/main_window.h"
#include "ui/window/readout.h"
#include "ui/window/workbench.h"

#include <QComboBox>
#include <QStackedWidget>

#include <algorithm>
#include <utility>

namespace texloom::ui {

namespace {

/// What can be started now, and what it will need.
struct Outlook {
    std::optional<RunPlan> plan;
    QString refusal;
    QString quickRefusal;

    Outlook(const RunInput& full, const RunInput& quick) {
        try {
            plan = planRun(full);
        } catch (const std::exception& error) {
            refusal = sentence(error);
        }
        try {
            planRun(quick);
        } catch (const std::exception& error) {
            quickRefusal = sentence(error);
        }
    }
};

/// The top left of an image to start from, for a preview of this size.
ExemplarFile croppedTo(const ExemplarFile& file, Size size) {
    ExemplarFile part = file;
    if (file.image->width() >= size.width && file.image->height() >= size.height)
        part.image = std::make_shared<const Image>(file.image->view().crop(0, 0, size));
    return part;
}

} // namespace

Size quickSize(Size size) {
    constexpr int kQuickSide = 384;
    const int longer = size.longerSide();
    if (longer <= kQuickSide)
        return size;
    const auto shortened = [=](int side) {
        return std::max(1, static_cast<int>(static_cast<std::int64_t>(side) * kQuickSide / longer));
    };
    return {shortened(size.width), shortened(size.height)};
}

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
    input.size = quick ? quickSize(output->outputSize()) : output->outputSize();
    input.wrap = output->wrap();
    input.seed = output->seed();
    input.threads = output->threads();
    if (!quick)
        input.region = output->part();
    if (output->initial())
        input.initial = quick ? croppedTo(*output->initial(), input.size) : output->initial();
    return input;
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
    const bool any = !m_store->entries().empty() || m_result;
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
    const int request = ++m_planRequest;
    if (m_store->entries().empty()) {
        m_canRun = m_canQuick = false;
        updateActions();
        m_runPanel->setHint(m_store->loading() > 0 ? tr("Reading the picture…")
                                                   : tr("Open an exemplar first."));
        return;
    }
    inBackground(
        this, [full = input(false), quick = input(true)] { return Outlook(full, quick); },
        [this, request](const Outlook& outlook) {
            if (request != m_planRequest)
                return;
            m_canRun = outlook.refusal.isEmpty();
            m_canQuick = outlook.quickRefusal.isEmpty();
            m_actions.quick->setToolTip(m_canQuick ? m_actions.quick->statusTip() : outlook.quickRefusal);
            if (m_canRun)
                m_runPanel->setEstimate(outlook.plan->estimate,
                                        expectedSeconds(*outlook.plan, m_bench->history()->entries()));
            else
                m_runPanel->setRefusal(outlook.refusal);
            updateActions();
        },
        [this](const QString& why) { fail(why); });
}

void MainWindow::updateActions() {
    for (QAction* action : {m_actions.run, m_actions.newSeedRun, m_actions.addToQueue})
        action->setEnabled(m_canRun && !m_starting);
    m_actions.quick->setEnabled(m_canQuick && !m_starting);
    m_actions.stress->setEnabled(m_canRun);
    m_bench->setCanRun(m_canRun, !m_store->entries().empty());
    m_actions.stop->setEnabled(m_controller->running());
    m_actions.exportResult->setEnabled(m_result && m_resultShown);
    m_actions.copyResult->setEnabled(m_result && m_resultShown);
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
    addRun(quick, true);
}

void MainWindow::queueRun() {
    addRun(false, false);
}

void MainWindow::addRun(bool quick, bool next) {
    if (m_starting)
        return;
    m_starting = true;
    updateActions();
    inBackground(
        this, [wanted = input(quick)] { return planRun(wanted); },
        [this, quick, next](RunPlan plan) {
            m_starting = false;
            m_messages->dismiss();
            const auto expected = expectedSeconds(plan, m_bench->history()->entries());
            m_bench->queue()->add(std::move(plan), quick, next,
                                  next ? JobQueue::Place::Next : JobQueue::Place::Last, expected);
        },
        [this](const QString& why) {
            m_starting = false;
            fail(why);
            updateActions();
        });
}

/// Exemplars that are open stand for those of a run that was read back, so that hovering finds them.
void MainWindow::takeShownExemplars(const RunPlan& plan) {
    m_shownExemplars = plan.request.exemplars;
    for (std::size_t i = 0; i < std::min(m_shownExemplars.size(), plan.recipe.exemplars.size()); ++i)
        if (const ExemplarEntry* entry = m_store->find(plan.recipe.exemplars[i]))
            m_shownExemplars[i].image = entry->file().image;
}

void MainWindow::runStarted(int id) {
    if (m_bench->queue()->find(id)->shown)
        watch(id);
}

void MainWindow::watch(int id) {
    const QueuedJob* const job = m_bench->queue()->find(id);
    m_live = id;
    takeShownExemplars(job->plan);
    if (m_bench->compare()->isVisible())
        m_results->setTab(ResultView::ResultTab);
    m_actions.editExemplar->setChecked(false);
    m_resultShown = false;
    m_results->setNotes({});
    m_results->setTitle(
        (job->quick ? tr("Quick preview under way: %1") : tr("Under way: %1")).arg(job->label));
    updateActions();
}

void MainWindow::runPreviewed(int id, const RunPictures& pictures) {
    if (id != m_live)
        return;
    m_resultShown = false;
    m_results->showPictures(pictures);
    if (m_controller->running())
        m_results->setBadge(m_controller->quick() ? tr("Quick preview")
                            : pictures.step > 1   ? tr("Preview 1:%1").arg(pictures.step)
                                                  : QString());
    updateActions();
}

void MainWindow::runFinished(const QueuedJob& job, const std::shared_ptr<const Result>& result,
                             const RunPictures& pictures) {
    if (job.id == m_live)
        showResult(result, pictures, job.quick);
    else if (job.shown)
        m_messages->say(MessageBar::Kind::Information, tr("Finished: %1.").arg(job.label), tr("Show"),
                        [this, result, pictures, quick = job.quick] { showResult(result, pictures, quick); });
    plan();
}

void MainWindow::showResult(const std::shared_ptr<const Result>& result, const RunPictures& pictures,
                            bool quick) {
    m_result = result;
    m_resultPictures = pictures;
    m_resultQuick = quick;
    showResult();
}

void MainWindow::showResults() {
    m_actions.editExemplar->setChecked(false);
    m_centre->setCurrentIndex(1);
}

void MainWindow::showResult() {
    m_live = 0;
    if (m_centre->currentWidget() != m_editor) // who edits is not taken away from it
        showResults();
    takeShownExemplars(m_result->plan);
    m_results->showPictures(m_resultPictures);
    m_results->setBadge(m_resultQuick ? tr("Quick preview") : QString());
    const Size size = m_result->plan.request.size;
    const QString label = tr("%1 · seed %2 · %3 · %4")
                              .arg(titleOf(m_result->plan))
                              .arg(m_result->plan.request.seed)
                              .arg(sizeText(size), QString::fromStdString(durationText(m_result->seconds)));
    m_results->setTitle(m_resultQuick ? tr("Quick preview: %1").arg(label) : label);
    QStringList notes;
    for (const std::string& note : m_result->synthesis.notes)
        notes += translated(note);
    m_results->setNotes(notes);
    m_figures->setResult(m_result);
    m_resultShown = true;
    updateActions();
}

void MainWindow::runStopped(const QueuedJob& job, double fraction) {
    if (job.id != m_live)
        return;
    const QString text = tr("Stopped at %1").arg(percentText(fraction));
    m_results->setTitle(tr("%1: %2").arg(text, job.label));
    m_results->setBadge(text);
    if (m_result)
        m_messages->say(MessageBar::Kind::Information, tr("%1. The picture is as far as it got.").arg(text),
                        tr("Back to the last result"), [this] { showResult(); });
    updateActions();
}

void MainWindow::runFailed(const QueuedJob& job) {
    if (job.id == m_live) {
        if (m_result)
            showResult();
        else
            m_results->setTitle({});
    }
    if (job.shown)
        m_messages->say(MessageBar::Kind::Error, job.problem); // the queue's failures are in the log already
    updateActions();
}

void MainWindow::fail(const QString& sentence) {
    m_bench->log()->add(sentence);
    m_messages->say(MessageBar::Kind::Error, sentence);
}

void MainWindow::hoverResult(QPoint pixel) {
    const RunPictures& shown = m_results->pictures();
    const Source source = shown.sourceOf(pixel.x(), pixel.y());
    QString place = tr("x %1, y %2").arg(pixel.x()).arg(pixel.y());
    const ExemplarEntry* entry = nullptr;
    if (source.valid() && source.exemplar < m_shownExemplars.size()) {
        const Exemplar& exemplar = m_shownExemplars[source.exemplar];
        entry = m_store->find(exemplar.image);
        place = tr("%1 → %2 x %3, y %4")
                    .arg(place, QString::fromStdString(exemplar.name))
                    .arg(source.x)
                    .arg(source.y);
    }
    m_readout->show(place, shown.result ? shown.result->valueText(pixel.x(), pixel.y()) : QString(),
                    tr("working space · float"));
    if (entry != nullptr)
        m_exemplars->showSource(*entry, {source.x, source.y});
    else
        m_exemplars->hideSource();
    m_results->markPosition(entry, {source.x, source.y});
    m_results->hideCopies();
}

void MainWindow::hoverExemplar(const ExemplarEntry* entry, QPoint pixel) {
    if (entry == nullptr)
        return;
    const ExemplarFile& file = entry->file();
    m_readout->show(
        tr("%1 x %2, y %3").arg(QString::fromStdString(file.name())).arg(pixel.x()).arg(pixel.y()),
        entry->picture->valueText(pixel.x(), pixel.y()),
        tr("%1 · %2").arg(QString::fromStdString(file.space), QString::fromStdString(file.info.depth)));
    m_results->markPosition(entry, pixel);
    m_exemplars->showSource(*entry, pixel);
    showCopies(*entry, pixel);
}

void MainWindow::showCopies(const ExemplarEntry& entry, QPoint pixel) {
    for (std::size_t i = 0; i < m_shownExemplars.size(); ++i) {
        if (m_store->find(m_shownExemplars[i].image) != &entry)
            continue;
        const auto number = [](std::size_t value) { return static_cast<std::uint16_t>(value); };
        const std::size_t count = m_results->showCopies(
            {static_cast<std::uint16_t>(pixel.x()), static_cast<std::uint16_t>(pixel.y()), number(i)});
        if (count > 0)
            m_readout->addToPlace(count == 1 ? tr("once in the result")
                                             : tr("%1 times in the result").arg(count));
        return;
    }
    m_results->hideCopies();
}

void MainWindow::endHover() {
    m_readout->clear();
    m_exemplars->hideSource();
    m_results->markPosition(nullptr, {});
    m_results->hideCopies();
}

} // namespace texloom::ui
