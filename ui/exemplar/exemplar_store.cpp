#include "ui/exemplar/exemplar_store.h"

#include "ui/jobs/background.h"
#include "ui/window/text.h"

#include <algorithm>
#include <utility>

namespace texloom::ui {

namespace {

/// A file with the picture that shows it.
struct Loaded {
    ExemplarFile file;
    std::shared_ptr<const DisplayPicture> picture;
};

Loaded loadShown(const std::filesystem::path& path, const std::string& space) {
    Loaded loaded{loadExemplar(path, space), nullptr};
    loaded.picture = std::make_shared<const DisplayPicture>(loaded.file.image);
    return loaded;
}

} // namespace

template <class Work, class Done> void ExemplarStore::load(Work work, Done done) {
    beginLoading(1);
    inBackground(
        this, std::move(work),
        [this, done = std::move(done)](auto loaded) {
            beginLoading(-1);
            done(std::move(loaded));
        },
        [this](const QString& why) {
            beginLoading(-1);
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
               entry.file().space == wanted.image.space && entry.exemplar.edits == wanted.edits;
    });
    return it == m_entries.end() ? nullptr : &*it;
}

ExemplarEntry* ExemplarStore::entry(int id) {
    return const_cast<ExemplarEntry*>(std::as_const(*this).find(id));
}

int ExemplarStore::add(RunExemplar exemplar, std::shared_ptr<const DisplayPicture> picture) {
    m_entries.push_back({++m_lastId, std::move(exemplar), true, std::move(picture)});
    return m_lastId;
}

void ExemplarStore::open(const QString& path) {
    const auto file = toPath(path);
    const auto known = std::find_if(m_entries.begin(), m_entries.end(),
                                    [&](const auto& entry) { return entry.file().path == file; });
    if (known != m_entries.end()) {
        const int id = known->id;
        setCurrent(id);
        Q_EMIT opened(id);
        return;
    }
    load([file] { return loadShown(file, {}); },
         [this](Loaded loaded) {
             const int id = add({std::move(loaded.file), {}, {}}, std::move(loaded.picture));
             Q_EMIT changed();
             setCurrent(id);
             Q_EMIT opened(id);
         });
}

void ExemplarStore::replaceAll(std::vector<RunExemplar> exemplars) {
    const auto make = [exemplars = std::move(exemplars)] {
        std::vector<std::pair<RunExemplar, std::shared_ptr<const DisplayPicture>>> made;
        for (const RunExemplar& exemplar : exemplars)
            made.emplace_back(exemplar, std::make_shared<const DisplayPicture>(exemplar.image.image));
        return made;
    };
    load(make, [this](auto made) {
        m_entries.clear();
        for (auto& [exemplar, picture] : made)
            add(std::move(exemplar), std::move(picture));
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
    Q_EMIT changed();
    Q_EMIT currentChanged();
}

void ExemplarStore::setCurrent(int id) {
    if (m_current == id || find(id) == nullptr)
        return;
    m_current = id;
    Q_EMIT currentChanged();
}

void ExemplarStore::setChecked(int id, bool checked) {
    ExemplarEntry* const changing = entry(id);
    if (changing == nullptr || changing->checked == checked)
        return;
    changing->checked = checked;
    Q_EMIT changed();
}

void ExemplarStore::setSpace(int id, const QString& space) {
    const ExemplarEntry* const known = find(id);
    if (known == nullptr || known->file().space == space.toStdString())
        return;
    load([file = known->file().path, space = space.toStdString()] { return loadShown(file, space); },
         [this, id](Loaded loaded) {
             if (ExemplarEntry* const changing = entry(id)) {
                 changing->exemplar.image = std::move(loaded.file);
                 changing->picture = std::move(loaded.picture);
                 Q_EMIT changed();
                 Q_EMIT currentChanged();
             }
         });
}

void ExemplarStore::setMask(int id, const QString& path) {
    load([file = toPath(path)] { return loadMask(file); },
         [this, id](ExemplarFile mask) {
             if (ExemplarEntry* const changing = entry(id)) {
                 changing->exemplar.mask = std::move(mask);
                 Q_EMIT changed();
             }
         });
}

void ExemplarStore::clearMask(int id) {
    if (ExemplarEntry* const changing = entry(id)) {
        changing->exemplar.mask.reset();
        Q_EMIT changed();
    }
}

} // namespace texloom::ui
