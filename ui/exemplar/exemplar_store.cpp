#include "ui/exemplar/exemplar_store.h"

#include "core/base/error.h"
#include "core/image/mask_paint.h"
#include "core/io/decoder_process.h"
#include "core/session/run/edited_exemplar.h"
#include "core/tools/edits.h"
#include "ui/common/background.h"
#include "ui/common/text.h"
#include "ui/exemplar/files.h"
#include "ui/exemplar/material.h"

#include <QFileInfo>

#include <algorithm>
#include <utility>

namespace texloom::ui {

namespace {

/// Loads the companion maps in a file and checks that they fit. @throws Error, UsageError
std::vector<ExemplarFile> loadFitting(const RunExemplar& original, const QString& path,
                                      const std::string& layer = {}) {
    std::vector<ExemplarFile> companions = loadCompanions(toPath(path), layer);
    checkSizeLike(original.image, companions.front(), TR("companion"));
    return companions;
}

} // namespace

template <class Work, class Done> void ExemplarStore::load(const QString& what, Work work, Done done) {
    beginLoading(1);
    readInBackground(
        this, what, std::move(work),
        [this, done = std::move(done)](auto loaded) {
            beginLoading(-1);
            done(std::move(loaded));
        },
        [this](const QString& why) {
            beginLoading(-1);
            if (!why.isEmpty())
                Q_EMIT failed(why);
        });
}

void ExemplarStore::beginLoading(int step) {
    m_loading += step;
    Q_EMIT loadingChanged(m_loading);
}

const ExemplarEntry* ExemplarStore::find(int id) const {
    const auto it =
        std::find_if(m_entries.begin(), m_entries.end(), [=](const auto& entry) { return entry.id == id; });
    return it == m_entries.end() ? nullptr : &*it;
}

const ExemplarEntry* ExemplarStore::find(const std::shared_ptr<const Image>& image) const {
    const auto it = std::find_if(m_entries.begin(), m_entries.end(),
                                 [&](const auto& entry) { return entry.file().image == image; });
    return it == m_entries.end() ? nullptr : &*it;
}

const ExemplarEntry* ExemplarStore::find(const RecipeExemplar& wanted) const {
    const auto it = std::find_if(m_entries.begin(), m_entries.end(), [&](const ExemplarEntry& entry) {
        return entry.file().path == wanted.image.path && entry.file().hash == wanted.image.hash &&
               entry.file().space == wanted.image.space && entry.file().layer == wanted.image.layer &&
               entry.exemplar.edits == wanted.edits;
    });
    return it == m_entries.end() ? nullptr : &*it;
}

ExemplarEntry* ExemplarStore::entry(int id) {
    return const_cast<ExemplarEntry*>(std::as_const(*this).find(id));
}

int ExemplarStore::add(ShownExemplar made) {
    m_entries.push_back({std::move(made), ++m_lastId});
    return m_lastId;
}

void ExemplarStore::open(const QString& path) {
    readFirst(path, {}, std::nullopt);
}

void ExemplarStore::openAll(const QStringList& paths) {
    for (const QString& path : paths) {
        const bool companion = isCompanion(path);
        const auto together = [&path](const QString& other) { return belongTogether(path, other); };
        if (companion && std::any_of(paths.begin(), paths.end(), together))
            continue; // it comes with the other
        const auto known = std::find_if(m_entries.begin(), m_entries.end(), [&](const ExemplarEntry& entry) {
            return together(toQString(entry.file().path));
        });
        if (companion && known != m_entries.end()) {
            addCompanion(known->id, path);
            continue;
        }
        QStringList companions;
        for (const QString& other : paths)
            if (isCompanion(other) && belongTogether(other, path))
                companions += other;
        openMaterial(path, companions);
    }
}

/// The entry that a file, or a layer of it, is open as; of a file with several layers only a chosen one.
const ExemplarEntry* ExemplarStore::known(const std::filesystem::path& file,
                                          const std::optional<std::string>& layer) const {
    const auto it = std::find_if(m_entries.begin(), m_entries.end(), [&](const ExemplarEntry& entry) {
        const bool same = layer ? entry.file().layer == *layer : entry.file().info.layers.empty();
        return entry.file().path == file && same;
    });
    return it == m_entries.end() ? nullptr : &*it;
}

void ExemplarStore::openMaterial(const QString& path, const QStringList& companions) {
    readFirst(path, companions, std::nullopt);
}

/// Asks which layer is to be taken where a file has several.
void ExemplarStore::withLayer(const QString& path, std::function<void(const std::string&)> take) {
    load(
        QFileInfo(path).fileName(), [file = toPath(path)] { return layerEntries(readImageInfo(file)); },
        [this, path, take = std::move(take)](const std::vector<LayerEntry>& entries) {
            if (entries.empty())
                take({});
            else
                Q_EMIT layerWanted({path, entries, take});
        });
}

void ExemplarStore::readFirst(const QString& path, const QStringList& companions,
                              const std::optional<std::string>& layer) {
    if (const ExemplarEntry* const open = known(toPath(path), layer)) {
        const int id = open->id;
        for (const QString& companion : companions)
            addCompanion(id, companion);
        useAlone(id);
        setCurrent(id);
        Q_EMIT opened(id);
        return;
    }
    load(
        QFileInfo(path).fileName(), [path, companions, layer] { return opening(path, companions, layer); },
        [this, path, companions](Opening made) {
            if (!made.shown) {
                Q_EMIT layerWanted({path, made.layers, [this, path, companions](const std::string& chosen) {
                                        readFirst(path, companions, chosen);
                                    }});
                return;
            }
            const int id = add(std::move(*made.shown));
            useAlone(id);
            setCurrent(id);
            Q_EMIT opened(id);
            for (const QString& refusal : made.refused)
                Q_EMIT failed(refusal);
        });
}

ExemplarStore::Opening ExemplarStore::opening(const QString& path, const QStringList& companions,
                                              const std::optional<std::string>& layer) {
    const std::filesystem::path file = toPath(path);
    Opening made;
    if (!layer) {
        made.layers = layerEntries(readImageInfo(file));
        if (!made.layers.empty())
            return made;
    }
    RunExemplar exemplar{loadExemplar(file, {}, layer.value_or("")), {}, {}};
    for (const QString& companion : companions)
        try {
            putCompanions(exemplar, loadFitting(exemplar, companion));
        } catch (const std::exception& error) {
            made.refused += sentence(error);
        }
    made.shown = shown(std::move(exemplar));
    return made;
}

void ExemplarStore::replaceAll(std::vector<RunExemplar> exemplars) {
    const auto make = [exemplars = std::move(exemplars)] {
        std::vector<ShownExemplar> made;
        for (const RunExemplar& exemplar : exemplars)
            made.push_back(shown(exemplar));
        return made;
    };
    load(tr("exemplars"), make, [this](std::vector<ShownExemplar> made) {
        m_entries.clear();
        for (ShownExemplar& one : made)
            add(std::move(one));
        m_current = m_entries.empty() ? 0 : m_entries.front().id;
        Q_EMIT changed();
        Q_EMIT currentChanged();
        Q_EMIT replaced();
    });
}

void ExemplarStore::remove(int id) {
    const auto it =
        std::find_if(m_entries.begin(), m_entries.end(), [=](const auto& entry) { return entry.id == id; });
    if (it == m_entries.end())
        return;
    const auto next = m_entries.erase(it);
    if (m_current == id)
        m_current = m_entries.empty() ? 0 : next == m_entries.end() ? m_entries.back().id : next->id;
    if (inUse() == 0)
        if (ExemplarEntry* const left = entry(m_current))
            left->checked = true;
    Q_EMIT changed();
    Q_EMIT currentChanged();
}

void ExemplarStore::setCurrent(int id) {
    if (m_current == id || find(id) == nullptr)
        return;
    m_current = id;
    if (inUse() <= 1)
        useAlone(id);
    Q_EMIT currentChanged();
}

int ExemplarStore::inUse() const {
    return static_cast<int>(std::count_if(m_entries.begin(), m_entries.end(),
                                          [](const ExemplarEntry& entry) { return entry.checked; }));
}

void ExemplarStore::useAlone(int id) {
    for (ExemplarEntry& entry : m_entries)
        entry.checked = entry.id == id;
    Q_EMIT changed();
}

void ExemplarStore::setChecked(int id, bool checked) {
    const ExemplarEntry* const known = find(id);
    if (known == nullptr || known->checked == checked)
        return;
    restoreChecked(id, checked);
    Q_EMIT ticked(id, checked, checked ? tr("Use exemplar") : tr("Leave exemplar out"));
}

void ExemplarStore::restoreChecked(int id, bool checked) {
    ExemplarEntry* const changing = entry(id);
    if (changing == nullptr)
        return;
    changing->checked = checked;
    Q_EMIT changed();
}

void ExemplarStore::setWeight(int id, double weight) {
    const ExemplarEntry* const known = find(id);
    if (known == nullptr || known->exemplar.weight == weight)
        return;
    change({id, tr("Weight"), QStringLiteral("weight"),
            [weight](ExemplarState& state) { state.original.weight = weight; }, true});
}

void ExemplarStore::change(Change change) {
    if (find(change.id) == nullptr)
        return;
    const std::size_t waiting = m_changes.size() - (m_changing ? 1 : 0);
    const bool replaces = waiting > 0 && !change.key.isEmpty() && m_changes.back().id == change.id &&
                          m_changes.back().key == change.key;
    const bool edits = change.edits.has_value();
    const int id = change.id;
    if (supersedes(change)) {
        m_superseded = true;
        m_making->stopped = true;
    }
    if (replaces)
        m_changes.back() = std::move(change);
    else
        m_changes.push_back(std::move(change));
    if (edits)
        Q_EMIT pendingChanged(id);
    nextChange();
}

/// Whether what is being made would be made anew at once, as while a slider is dragged.
bool ExemplarStore::supersedes(const Change& change) const {
    return m_changing && m_making && m_changes.size() == 1 && change.edits && m_changes.front().edits &&
           change.id == m_changes.front().id && !change.key.isEmpty() && change.key == m_changes.front().key;
}

void ExemplarStore::nextChange() {
    if (m_changing || m_changes.empty())
        return;
    const Change& next = m_changes.front();
    const ExemplarEntry* const known = find(next.id);
    if (known == nullptr) {
        m_changes.pop_front();
        return nextChange();
    }
    m_changing = true;
    m_superseded = false;
    beginLoading(1);
    m_making = readInBackground(
        this, toQString(known->file().path.filename()),
        [apply = next.apply, entry = *known] {
            ExemplarState state = stateOf(entry.exemplar);
            apply(state);
            return shown(madeFrom(state, entry.exemplar, &DecoderProcess::check), &entry);
        },
        [this, before = stateOf(known->exemplar)](ShownExemplar made) {
            const Change done = std::move(m_changes.front());
            endChange();
            changeDone(done, before, std::move(made));
            nextChange();
        },
        [this, id = next.id](const QString& why) {
            const bool byUser = why.isEmpty() && !m_superseded;
            endChange();
            if (!why.isEmpty())
                Q_EMIT failed(why);
            if (byUser)
                brokenOff(id);
            Q_EMIT pendingChanged(id);
            nextChange();
        },
        next.edits ? Readings::Doing::Edit : Readings::Doing::Read);
}

void ExemplarStore::endChange() {
    m_changes.pop_front();
    m_changing = false;
    m_making.reset();
    beginLoading(-1);
}

/// Whoever breaks one change off wants none of those that wait for it.
void ExemplarStore::brokenOff(int id) {
    std::erase_if(m_changes, [id](const Change& change) { return change.id == id; });
}

ExemplarEdits ExemplarStore::wantedEdits(int id) const {
    for (auto change = m_changes.rbegin(); change != m_changes.rend(); ++change)
        if (change->id == id && change->edits)
            return *change->edits;
    const ExemplarEntry* const known = find(id);
    return known != nullptr ? known->exemplar.edits : ExemplarEdits{};
}

void ExemplarStore::changeDone(const Change& change, const ExemplarState& before, ShownExemplar made) {
    ExemplarEntry* const changing = entry(change.id);
    if (changing == nullptr)
        return;
    static_cast<ShownExemplar&>(*changing) = std::move(made);
    const ExemplarState after = stateOf(changing->exemplar);
    Q_EMIT changed();
    Q_EMIT currentChanged();
    if (change.undoable)
        Q_EMIT edited(change.id, before, after, change.what, change.key);
}

void ExemplarStore::setSpace(int id, const QString& space) {
    const ExemplarEntry* const known = find(id);
    if (known == nullptr || known->file().space == space.toStdString())
        return;
    change({id,
            tr("Colour space"),
            {},
            [space = space.toStdString()](ExemplarState& state) {
                state.original.image =
                    loadExemplar(state.original.image.path, space, state.original.image.layer);
            },
            true});
}

void ExemplarStore::setLayer(int id, const std::string& layer) {
    const ExemplarEntry* const known = find(id);
    if (known == nullptr || known->file().layer == layer)
        return;
    change({id,
            tr("Layer"),
            {},
            [layer](ExemplarState& state) {
                RunExemplar& original = state.original;
                original.image = loadExemplar(original.image.path, original.image.space, layer);
                if (original.mask)
                    checkSizeLike(original.image, *original.mask, TR("mask"));
                for (const ExemplarFile& companion : original.companions)
                    checkSizeLike(original.image, companion, TR("companion"));
            },
            true});
}

void ExemplarStore::setMask(int id, const QString& path) {
    withLayer(path, [this, id, file = toPath(path)](const std::string& layer) {
        change({id,
                tr("Mask"),
                {},
                [file, layer](ExemplarState& state) {
                    ExemplarFile mask = loadMask(file, layer);
                    checkSizeLike(state.original.image, mask, TR("mask"));
                    state.original.mask = std::move(mask);
                },
                true});
    });
}

void ExemplarStore::clearMask(int id) {
    change({id, tr("Clear mask"), {}, [](ExemplarState& state) { state.original.mask.reset(); }, true});
}

void ExemplarStore::paintMask(int id, Image stroke, bool hide) {
    const auto painted = std::make_shared<const Image>(std::move(stroke));
    change({id,
            hide ? tr("Paint mask") : tr("Erase mask"),
            {},
            [painted, hide](ExemplarState& state) {
                const Image* const known = state.original.mask ? state.original.mask->image.get() : nullptr;
                const Size size = state.original.image.image->size();
                state.original.mask =
                    saveMask(paintedMask(known, size, warpOf(state.edits, size), *painted, hide),
                             state.original.image.name());
            },
            true});
}

void ExemplarStore::setInputs(int id, const std::string& port, std::vector<InputFile> files,
                              const QString& what) {
    change({id,
            what,
            {},
            [port, files = std::move(files)](ExemplarState& state) {
                for (const InputFile& input : files)
                    if (input.image() != nullptr)
                        checkSizeLike(state.original.image, input.file, TR("picture"));
                if (files.empty())
                    state.original.inputs.erase(port);
                else
                    state.original.inputs[port] = files;
            },
            true});
}

void ExemplarStore::addCompanion(int id, const QString& path) {
    withLayer(path, [this, id, path](const std::string& layer) {
        change({id,
                tr("Add companion map"),
                {},
                [path, layer](ExemplarState& state) {
                    putCompanions(state.original, loadFitting(state.original, path, layer));
                },
                true});
    });
}

void ExemplarStore::addCompanion(int id, const QString& path, MapRole role) {
    change({id,
            tr("Add companion map"),
            {},
            [path, role](ExemplarState& state) {
                std::vector<ExemplarFile> maps = loadFitting(state.original, path);
                maps.resize(1);
                maps.front().role = role;
                putCompanions(state.original, std::move(maps));
            },
            true});
}

void ExemplarStore::removeCompanion(int id, std::size_t index) {
    change({id,
            tr("Remove companion map"),
            {},
            [index](ExemplarState& state) {
                std::vector<ExemplarFile>& companions = state.original.companions;
                if (index < companions.size())
                    companions.erase(companions.begin() + static_cast<std::ptrdiff_t>(index));
            },
            true});
}

void ExemplarStore::setCompanionRole(int id, std::size_t index, MapRole role) {
    change({id,
            tr("Kind of companion map"),
            {},
            [index, role](ExemplarState& state) {
                if (index < state.original.companions.size())
                    state.original.companions[index].role = role;
            },
            true});
}

void ExemplarStore::setEdits(int id, const ExemplarEdits& edits, const QString& what, const QString& key) {
    change({id, what, key, [edits](ExemplarState& state) { state.edits = edits; }, true, edits});
}

void ExemplarStore::restoreState(int id, const ExemplarState& state) {
    change({id, {}, {}, [state](ExemplarState& restored) { restored = state; }, false, state.edits});
}

} // namespace texloom::ui
