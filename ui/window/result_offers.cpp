#include "ui/window/result_offers.h"

#include "core/base/error.h"
#include "core/session/run/exemplar_use.h"
#include "ui/exemplar/exemplar_store.h"
#include "ui/maps/result_view.h"
#include "ui/runs/run_desk.h"

#include <QAction>

#include <algorithm>

namespace texloom::ui {

namespace {

bool heedsMasks(const Recipe& recipe) {
    try {
        return useOf(recipe.steps).masks;
    } catch (const Error&) { // a method that this build does not have
        return false;
    }
}

bool sameMask(const RunExemplar& open, const RecipeExemplar& wanted) {
    const std::optional<ExemplarFile>& mask = open.original().mask;
    return mask.has_value() == wanted.mask.has_value() && (!mask || mask->hash == wanted.mask->hash);
}

bool means(const RecipeExemplar& wanted, const ExemplarEntry& entry, bool masks) {
    return entry.exemplar.edits == wanted.edits && entry.file().hash == wanted.image.hash &&
           entry.file().space == wanted.image.space && (!masks || sameMask(entry.exemplar, wanted));
}

} // namespace

ResultOffers::ResultOffers(RunDesk* desk, ExemplarStore* store, ResultView* view, QAction* repeat,
                           QObject* parent)
    : QObject(parent), m_desk(desk), m_store(store), m_view(view), m_repeat(repeat) {
    m_desk->history()->setOutdated(
        [this](const ResultEntry& entry) { return madeBeforeEdits(entry.recipe); });
    connect(m_store, &ExemplarStore::changed, m_desk->history(), &ResultHistory::exemplarsChanged);
    connect(m_store, &ExemplarStore::changed, this, &ResultOffers::refresh);
    connect(m_desk, &RunDesk::changed, this, &ResultOffers::refresh);
    connect(m_repeat, &QAction::toggled, this, &ResultOffers::refresh);
    connect(m_view, &ResultView::wrapWanted, this, &ResultOffers::wrap);
    connect(m_view, &ResultView::rerunWanted, this, &ResultOffers::rerun);
}

bool ResultOffers::madeBeforeEdits(const Recipe& recipe) const {
    const std::vector<ExemplarEntry>& open = m_store->entries();
    const bool masks = !open.empty() && heedsMasks(recipe);
    return std::any_of(recipe.exemplars.begin(), recipe.exemplars.end(), [&](const RecipeExemplar& wanted) {
        bool known = false;
        for (const ExemplarEntry& entry : open) {
            if (entry.file().path != wanted.image.path)
                continue;
            if (means(wanted, entry, masks))
                return false;
            known = true;
        }
        return known;
    });
}

void ResultOffers::refresh() {
    if (!m_desk->resultShown())
        return m_view->setOffers(false, false);
    const RunPlan& plan = m_desk->result()->plan;
    const Wrap wrap = plan.request.wrap;
    const bool torn = m_repeat->isChecked() && !(wrap.x && wrap.y) && plan.lastMethod().info().canWrap();
    m_view->setOffers(torn, madeBeforeEdits(plan.recipe));
}

void ResultOffers::wrap() {
    Recipe recipe = m_desk->result()->plan.recipe;
    recipe.wrap = {true, true};
    recipe.region.reset(); // a part of what wraps does not
    Q_EMIT runWanted(recipe, m_desk->last().quick);
}

void ResultOffers::rerun() {
    Q_EMIT runWanted(m_desk->result()->plan.recipe, m_desk->last().quick);
}

} // namespace texloom::ui
