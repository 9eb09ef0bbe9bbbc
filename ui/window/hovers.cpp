#include "ui/window/hovers.h"

#include "ui/compare/compare_view.h"
#include "ui/exemplar/exemplar_panel.h"
#include "ui/exemplar/exemplar_store.h"
#include "ui/maps/result_view.h"
#include "ui/runs/run_desk.h"
#include "ui/window/readout.h"

namespace texloom::ui {

const ExemplarEntry* openExemplar(const RunDesk& desk, const ExemplarStore& store, std::size_t index) {
    if (!desk.shownPlan() || index >= desk.shownPlan()->request.exemplars.size())
        return nullptr;
    const RunPlan& plan = *desk.shownPlan();
    if (const ExemplarEntry* entry = store.find(plan.request.exemplars[index].image))
        return entry;
    // That of a run that was read back has pixels of its own.
    return index < plan.recipe.exemplars.size() ? store.find(plan.recipe.exemplars[index]) : nullptr;
}

Hovers::Hovers(const RunDesk* desk, const ExemplarStore* store, const Places& places, QObject* parent)
    : QObject(parent), m_desk(desk), m_store(store), m_in(places) {
    connect(m_in.results, &ResultView::resultHovered, this, &Hovers::overResult);
    connect(m_in.results, &ResultView::positionHovered, this, &Hovers::overExemplar);
    connect(m_in.results, &ResultView::legendChanged, m_in.exemplars, &ExemplarPanel::setLegend);
    connect(m_in.results, &ResultView::unhovered, this, &Hovers::end);
    connect(m_in.exemplars, &ExemplarPanel::hovered, this, &Hovers::overExemplar);
    connect(m_in.exemplars, &ExemplarPanel::unhovered, this, &Hovers::end);
    connect(m_in.compare, &CompareView::hovered, this,
            [this](const QString& label, QPoint pixel, const QString& values) {
                m_in.readout->show(tr("%1: x %2, y %3").arg(label).arg(pixel.x()).arg(pixel.y()), values,
                                   tr("working space · float"));
            });
    connect(m_in.compare, &CompareView::unhovered, this, &Hovers::end);
}

void Hovers::overResult(QPoint pixel) {
    const RunPictures& shown = m_in.results->pictures();
    const Source source = shown.sourceOf(pixel.x(), pixel.y());
    QString place = tr("x %1, y %2").arg(pixel.x()).arg(pixel.y());
    const ExemplarEntry* entry = nullptr;
    const auto& plan = m_desk->shownPlan();
    if (source.valid() && plan && source.exemplar < plan->request.exemplars.size()) {
        entry = openExemplar(*m_desk, *m_store, source.exemplar);
        place = tr("%1 → %2 x %3, y %4")
                    .arg(place, QString::fromStdString(plan->request.exemplars[source.exemplar].name))
                    .arg(source.x)
                    .arg(source.y);
    }
    m_in.readout->show(place, shown.result ? shown.result->valueText(pixel.x(), pixel.y()) : QString(),
                       tr("working space · float"));
    if (entry != nullptr)
        m_in.exemplars->showSource(*entry, {source.x, source.y});
    else
        m_in.exemplars->hideSource();
    m_in.results->markPosition(entry, {source.x, source.y});
    m_in.results->hideCopies();
}

void Hovers::overExemplar(QPoint pixel) {
    const ExemplarEntry* const entry = m_store->current();
    if (entry == nullptr)
        return;
    const ExemplarFile& file = entry->file();
    m_in.readout->show(
        tr("%1 x %2, y %3").arg(QString::fromStdString(file.name())).arg(pixel.x()).arg(pixel.y()),
        entry->picture->valueText(pixel.x(), pixel.y()),
        tr("%1 · %2").arg(QString::fromStdString(file.space), QString::fromStdString(file.info.depth)));
    m_in.results->markPosition(entry, pixel);
    m_in.exemplars->showSource(*entry, pixel);
    showCopies(*entry, pixel);
}

void Hovers::showCopies(const ExemplarEntry& entry, QPoint pixel) {
    const auto number = [](auto value) { return static_cast<std::uint16_t>(value); };
    const std::size_t all = m_desk->shownPlan() ? m_desk->shownPlan()->request.exemplars.size() : 0;
    for (std::size_t i = 0; i < all; ++i) {
        if (openExemplar(*m_desk, *m_store, i) != &entry)
            continue;
        const std::size_t count = m_in.results->showCopies({number(pixel.x()), number(pixel.y()), number(i)});
        if (count > 0)
            m_in.readout->addToPlace(count == 1 ? tr("once in the result")
                                                : tr("%1 times in the result").arg(count));
        return;
    }
    m_in.results->hideCopies();
}

void Hovers::end() {
    m_in.readout->clear();
    m_in.exemplars->hideSource();
    m_in.results->markPosition(nullptr, {});
    m_in.results->hideCopies();
}

} // namespace texloom::ui
