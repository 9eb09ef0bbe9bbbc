#include "ui/window/run_display.h"

#include "core/base/text.h"
#include "core/generator/generator_source.h"
#include "ui/common/message_bar.h"
#include "ui/common/text.h"
#include "ui/jobs/run_panel.h"
#include "ui/maps/result_view.h"
#include "ui/material/material_page.h"
#include "ui/plots/figures_panel.h"
#include "ui/volume/volume_page.h"

#include <QDesktopServices>
#include <QUrl>

#include <iterator>
#include <utility>
#include <vector>

namespace texloom::ui {

namespace {

/// "Image quilting · seed 1 · 512 × 512 · 2.1 s".
QString titleOf(const Result& result) {
    const RunPlan& plan = result.plan;
    return QStringLiteral("%1 · %2").arg(labelOf(plan), QString::fromStdString(durationText(result.seconds)));
}

/// The title of an output, with its number where there are several.
QString nameOf(const Result& result, const std::string& port, std::size_t number) {
    const Port* const declared = result.plan.steps.back().method->info().output(port);
    const QString title = declared != nullptr ? translated(declared->title) : QString::fromStdString(port);
    return number == 0 ? title : RunDisplay::tr("%1 %2").arg(title).arg(number + 1);
}

/// All volumes that a run made. Generators come first: theirs has no end, also where the store kept a box.
std::vector<NamedVolume> volumesOf(const Result& result) {
    const std::string recipe = result.plan.recipe.toJson(".");
    std::vector<NamedVolume> solids, volumes;
    for (const auto& [port, assets] : result.synthesis.outputs.byPort())
        for (std::size_t i = 0; i < assets.size(); ++i)
            if (const auto* volume = std::get_if<std::shared_ptr<const VolumeSource>>(&assets[i]))
                volumes.push_back({nameOf(result, port, i), {*volume, recipe}});
            else if (const auto* model = std::get_if<std::shared_ptr<const Model>>(&assets[i]);
                     model != nullptr && (*model)->kind == kSolidGenerator)
                solids.push_back(
                    {nameOf(result, port, i), {solidOf(**model, result.plan.request.seed), recipe}});
    if (!solids.empty()) // the same once more
        std::erase_if(volumes, [](const NamedVolume& volume) {
            return dynamic_cast<const GeneratorSource*>(volume.volume.source.get()) != nullptr;
        });
    solids.insert(solids.end(), std::make_move_iterator(volumes.begin()),
                  std::make_move_iterator(volumes.end()));
    return solids;
}

} // namespace

RunDisplay::RunDisplay(RunDesk* desk, const Places& places, QObject* parent)
    : QObject(parent), m_desk(desk), m_to(places), m_volume(new VolumePage(places.results)),
      m_material(new MaterialPage(places.results)) {
    m_to.results->addPage(m_material, tr("Material"),
                          tr("The result and its maps lit, on a shape or a mesh of your own."));
    const auto saySaved = [this](const QString& folder) {
        m_to.messages->say(MessageBar::Kind::Information, tr("Written to %1.").arg(folder), tr("Open folder"),
                           [folder] { QDesktopServices::openUrl(QUrl::fromLocalFile(folder)); });
    };
    connect(m_material, &MaterialPage::saved, this, saySaved);
    connect(m_volume, &VolumePage::saved, this, saySaved);
    connect(m_volume, &VolumePage::changed, this,
            [this] { m_to.results->setPageOffered(m_volume, !m_volume->empty()); });
    m_to.results->addPage(m_volume, tr("Volume"),
                          tr("The volume of the result: slices at any place, a block cut open, a mesh."));
    m_to.results->setPageOffered(m_volume, false);
    connectPanel();
    connect(m_desk, &RunDesk::watching, this, &RunDisplay::announce);
    connect(m_desk, &RunDesk::previewed, this, &RunDisplay::showPreview);
    connect(m_desk, &RunDesk::shown, this, &RunDisplay::showResult);
    connect(m_desk, &RunDesk::curvesGrew, m_to.figures, &FiguresPanel::showCurves);
    connect(m_desk, &RunDesk::cancelled, this, &RunDisplay::sayCancelled);
    connect(m_desk, &RunDesk::emptied, this, &RunDisplay::clear);
    connect(m_desk, &RunDesk::endedUnseen, this, &RunDisplay::offer);
    connect(m_desk, &RunDesk::accepted, m_to.messages, &MessageBar::dismissTold);
    connect(m_desk, &RunDesk::refused, this,
            [this](const QString& sentence) { m_to.messages->say(MessageBar::Kind::Error, sentence); });
}

void RunDisplay::connectPanel() {
    connect(m_desk->controller(), &RunController::progressed, m_to.panel, &RunPanel::showProgress);
    connect(m_desk->controller(), &RunController::pictureAwaited, this, &RunDisplay::sayAwaited);
    connect(m_desk->queue(), &JobQueue::changed, this,
            [this] { m_to.panel->setRunning(m_desk->running(), m_desk->queue()->waiting()); });
    connect(m_desk, &RunDesk::outlookChanged, this, [this](const Outlook& outlook) {
        if (outlook.estimate)
            m_to.panel->setEstimate(*outlook.estimate, outlook.seconds);
        else if (!outlook.refusal.isEmpty())
            m_to.panel->setRefusal(outlook.refusal);
    });
}

void RunDisplay::announce(const QueuedJob& job) {
    m_to.results->setNotes({});
    m_to.results->setTitle(
        (job.quick ? tr("Quick preview under way: %1") : tr("Under way: %1")).arg(job.label));
}

void RunDisplay::showPreview(const RunPictures& pictures) {
    m_to.results->showPictures(pictures);
    m_material->showPictures(pictures);
    if (m_desk->running())
        m_to.results->setBadge(m_desk->controller()->quick() ? tr("Quick preview")
                               : pictures.step > 1           ? tr("Preview 1:%1").arg(pictures.step)
                                                             : QString());
}

void RunDisplay::showResult(const ShownResult& shown) {
    m_to.results->showPictures(shown.pictures);
    m_material->showPictures(shown.pictures);
    const std::optional<double>& stopped = shown.result->stoppedAt;
    const QString title = titleOf(*shown.result);
    if (stopped) {
        const QString mark = tr("Stopped at %1").arg(percentText(*stopped));
        m_to.results->setBadge(mark);
        m_to.results->setTitle(tr("%1: %2").arg(mark, title));
    } else {
        m_to.results->setBadge(shown.quick ? tr("Quick preview") : QString());
        m_to.results->setTitle(shown.quick ? tr("Quick preview: %1").arg(title) : title);
    }
    QStringList notes;
    for (const Message& note : shown.result->synthesis.notes)
        notes += translated(note);
    m_to.results->setNotes(notes);
    m_to.figures->setResult(shown.result);
    m_volume->setVolumes(volumesOf(*shown.result));
}

void RunDisplay::clear() {
    m_to.results->showPictures({});
    m_material->showPictures({});
    m_to.results->setBadge({});
    m_to.results->setTitle({});
    m_to.results->setNotes({});
    m_to.figures->setResult(nullptr);
    m_volume->setVolumes({});
}

void RunDisplay::sayAwaited() {
    const QueuedJob* const job = m_desk->queue()->current();
    if (job == nullptr)
        return;
    const QString sentence =
        tr("There is no picture yet that could be kept; the run ends as soon as there is one.");
    m_to.messages->say(MessageBar::Kind::Information, sentence, tr("Cancel it now"),
                       [this, id = job->id] { m_desk->queue()->cancel(id); });
    connect(
        m_desk->queue(), &JobQueue::changed, m_to.messages,
        [this, sentence] {
            if (m_to.messages->text() == sentence)
                m_to.messages->dismiss();
        },
        Qt::SingleShotConnection);
}

void RunDisplay::sayCancelled(const QueuedJob& job, double fraction) {
    m_to.messages->say(
        MessageBar::Kind::Information,
        tr("Cancelled at %1, and nothing of it kept: %2.").arg(percentText(fraction), job.label));
}

void RunDisplay::offer(const QueuedJob& job, const std::string& key) {
    m_to.messages->say(MessageBar::Kind::Information, tr("Finished: %1.").arg(job.label), tr("Show"),
                       [this, key] { m_desk->show(key); });
}

} // namespace texloom::ui
