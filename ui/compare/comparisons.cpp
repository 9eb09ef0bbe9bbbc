#include "ui/compare/comparisons.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/methods/method.h"
#include "core/session/run/input_file.h"
#include "ui/common/background.h"
#include "ui/common/save_guard.h"
#include "ui/common/text.h"
#include "ui/compare/compare_view.h"
#include "ui/compare/contact_sheet.h"
#include "ui/exemplar/exemplar_store.h"
#include "ui/runs/result_text.h"
#include "ui/runs/run_desk.h"

#include <QAction>
#include <QDir>
#include <QFileInfo>
#include <QMenu>
#include <QSettings>

#include <algorithm>
#include <optional>
#include <utility>

namespace texloom::ui {

namespace {

const QString kSheetFolder = QStringLiteral("folders/sheet");

/// The picture that a comparison shows of a result, with its label.
CompareItem itemOf(const ResultEntry& entry, const std::shared_ptr<const Result>& result) {
    const std::shared_ptr<const Image> image(result, &result->synthesis.image);
    const QString label = entry.title.empty() ? labelText(entry) : titleText(entry);
    CompareItem item{label, std::make_shared<const DisplayPicture>(image), {}, entry.key};
    item.figures = figuresText(result->figures);
    return item;
}

/// An image that a result was made from, other than its exemplars.
struct GivenImage {
    Port port;
    RecipeFile file;
};

/// The first such image that a recipe's methods were given, those of the output's size before others.
std::optional<GivenImage> imageGivenTo(const Recipe& recipe) {
    for (const bool output : {true, false})
        for (const RecipeStep& step : recipe.steps)
            for (const Port& port : findMethod(step.method).info().takes) {
                const auto found = recipe.inputs.find(port.id);
                if (port.kind == AssetKind::Image && (port.extent == Extent::Output) == output &&
                    found != recipe.inputs.end() && !found->second.empty())
                    return GivenImage{port, found->second.front()};
            }
    return {};
}

/// The picture of such an image, or of that part of it which was made. Called on a worker.
CompareItem itemOf(const GivenImage& given, const Recipe& recipe) {
    InputFile input = loadInput(given.port, given.file, {});
    if (!given.file.hash.empty() && input.file.hash != given.file.hash)
        fail("{} is not the file any more that the result was made from.", given.file.path.string());
    std::shared_ptr<const Image> image = input.file.image;
    if (recipe.region && recipe.region->within(image->size()))
        image = std::make_shared<const Image>(
            image->view().crop(recipe.region->x, recipe.region->y, recipe.region->size));
    const QString name = QString::fromStdString(input.file.name());
    const QString label =
        QStringLiteral("%1 · %2 · %3").arg(name, translated(given.port.title), sizeText(image->size()));
    return {label, std::make_shared<const DisplayPicture>(image), {}, {}};
}

} // namespace

struct Comparisons::Gathering {
    std::vector<std::string> keys;
    std::vector<CompareItem> items;
};

Comparisons::Comparisons(RunDesk* desk, const ExemplarStore* store, QWidget* window)
    : QObject(window), m_desk(desk), m_store(store), m_window(window), m_actions(window),
      m_view(new CompareView(m_actions, window)) {
    for (const auto mode :
         {CompareMode::Grid, CompareMode::Wipe, CompareMode::Toggle, CompareMode::Difference})
        connect(m_actions.mode(mode), &QAction::triggered, this, [this, mode] { chooseMode(mode); });
    connect(m_actions.input, &QAction::triggered, this, &Comparisons::compareWithInput);
    connect(m_actions.exemplar, &QAction::triggered, this,
            [this](bool shown) { showExemplars(shown ? exemplarsOf(m_compared) : std::set<int>()); });
    connect(m_actions.exemplars, &QMenu::aboutToShow, this, &Comparisons::listExemplars);
    connect(m_actions.sheet, &QAction::triggered, this, &Comparisons::writeContactSheet);
    connect(m_view, &CompareView::useWanted, this, &Comparisons::useWanted);
}

QMenu* Comparisons::makeMenu() {
    auto* menu = new QMenu(tr("&Compare"), m_window);
    menu->addActions({m_actions.grid, m_actions.wipe, m_actions.toggle, m_actions.difference});
    menu->addSeparator();
    menu->addActions({m_actions.input, m_actions.exemplar});
    menu->addMenu(m_actions.exemplars);
    menu->addActions({m_actions.link, m_actions.sheet});
    return menu;
}

void Comparisons::chooseMode(CompareMode mode) {
    const bool seen = m_view->isVisible();
    if (m_view->pictures() >= 2 || seen) {
        // Choosing Toggle again shows the other picture, but not while nobody sees the first.
        if (seen || m_view->mode() != mode)
            m_view->setMode(mode);
        return Q_EMIT ready();
    }
    std::vector<std::string> lastTwo;
    for (const ResultEntry& entry : m_desk->history()->entries())
        lastTwo.push_back(entry.key);
    if (lastTwo.size() > 2)
        lastTwo.erase(lastTwo.begin(), lastTwo.end() - 2);
    if (lastTwo.empty())
        return Q_EMIT ready();
    compare(lastTwo, false);
    connect(
        m_view, &CompareView::replaced, this, [this, mode] { m_view->setMode(mode); },
        static_cast<Qt::ConnectionType>(Qt::QueuedConnection | Qt::SingleShotConnection));
}

void Comparisons::compareChosen(const std::vector<std::string>& keys) {
    compare(keys, m_actions.exemplar->isChecked());
}

void Comparisons::compareWithInput() {
    const ResultEntry* const entry = m_desk->history()->find(m_desk->last().key);
    if (entry == nullptr || !m_desk->result() || m_desk->result()->synthesis.image.empty())
        return Q_EMIT told(tr("There is no result yet that could be compared; press Run first."));
    const std::optional<GivenImage> given = imageGivenTo(entry->recipe);
    if (!given)
        return Q_EMIT told(tr("This result was not made from an image beside the exemplar; show one that "
                              "completes or changes an image."));
    inBackground(
        this,
        [given = *given, entry = *entry, result = m_desk->result()] {
            return std::vector<CompareItem>{itemOf(given, entry.recipe), itemOf(entry, result)};
        },
        [this, key = entry->key](std::vector<CompareItem> items) {
            m_compared = {key};
            m_view->setItems(std::move(items));
            m_view->setMode(CompareMode::Wipe);
            Q_EMIT ready();
        },
        [this](const QString& why) { Q_EMIT failed(why); });
}

void Comparisons::leaveFor() {
    m_compared.clear();
    Q_EMIT ready();
}

void Comparisons::compare(const std::vector<std::string>& keys, bool exemplar) {
    m_compared = keys;
    std::erase_if(m_compared,
                  [this](const std::string& key) { return m_desk->history()->find(key) == nullptr; });
    auto gathering = std::make_shared<Gathering>();
    if (exemplar)
        gathering->items = exemplarItems(exemplarsOf(m_compared));
    gathering->keys = m_compared;
    std::sort(gathering->keys.begin(), gathering->keys.end());
    gather(gathering);
}

void Comparisons::gather(const std::shared_ptr<Gathering>& gathering) {
    if (gathering->keys.empty()) {
        m_view->setItems(std::move(gathering->items));
        return Q_EMIT ready();
    }
    const std::string key = gathering->keys.front();
    gathering->keys.erase(gathering->keys.begin());
    const auto without = [this, gathering, key](const QString& why) {
        const ResultEntry* const entry = m_desk->history()->find(key);
        gathering->items.push_back({entry != nullptr ? labelText(*entry) : QString(), nullptr, why, {}});
        gather(gathering);
    };
    const auto got = [this, gathering, key, without](const std::shared_ptr<const Result>& result) {
        const ResultEntry* const entry = m_desk->history()->find(key);
        if (entry == nullptr)
            return without(tr("This result was removed."));
        inBackground(
            this, [entry = *entry, result] { return itemOf(entry, result); },
            [this, gathering](CompareItem item) {
                gathering->items.push_back(std::move(item));
                gather(gathering);
            },
            without);
    };
    m_desk->history()->want(key, got, without);
}

/// Those exemplars of the results that are open; the one that is looked at if there are none.
std::set<int> Comparisons::exemplarsOf(const std::vector<std::string>& keys) const {
    std::set<int> ids;
    for (const std::string& key : keys)
        if (const ResultEntry* result = m_desk->history()->find(key))
            for (const RecipeExemplar& wanted : result->recipe.exemplars)
                if (const ExemplarEntry* entry = m_store->find(wanted))
                    ids.insert(entry->id);
    if (ids.empty() && m_store->current() != nullptr)
        ids.insert(m_store->current()->id);
    return ids;
}

std::vector<CompareItem> Comparisons::exemplarItems(const std::set<int>& ids) const {
    std::vector<CompareItem> items;
    for (const int id : ids)
        if (const ExemplarEntry* entry = m_store->find(id)) {
            const QString name = QString::fromStdString(entry->file().name());
            items.push_back({tr("%1 · exemplar · %2").arg(name, sizeText(entry->file().image->size())),
                             entry->picture,
                             {},
                             {}});
            items.back().exemplar = id;
        }
    return items;
}

std::set<int> Comparisons::exemplarsShown() const {
    std::set<int> ids;
    for (const CompareItem& item : m_view->items())
        if (item.exemplar > 0)
            ids.insert(item.exemplar);
    return ids;
}

/// Shows these exemplars before the results of the comparison, which stay.
void Comparisons::showExemplars(const std::set<int>& ids) {
    std::vector<CompareItem> items = exemplarItems(ids);
    for (const CompareItem& item : m_view->items())
        if (item.exemplar == 0)
            items.push_back(item);
    m_view->setItems(std::move(items), 0, QString(m_view->heading()));
    m_actions.exemplar->setChecked(!ids.empty());
}

void Comparisons::listExemplars() {
    QMenu* const menu = m_actions.exemplars;
    menu->clear();
    const std::set<int> shown = exemplarsShown();
    for (const ExemplarEntry& entry : m_store->entries()) {
        QAction* const action = menu->addAction(QString::fromStdString(entry.file().name()));
        action->setCheckable(true);
        action->setChecked(shown.contains(entry.id));
        connect(action, &QAction::toggled, this, [this, id = entry.id](bool wanted) {
            std::set<int> ids = exemplarsShown();
            if (wanted)
                ids.insert(id);
            else
                ids.erase(id);
            showExemplars(ids);
            Q_EMIT ready();
        });
    }
    if (menu->isEmpty())
        menu->addAction(tr("No exemplar is open"))->setEnabled(false);
}

void Comparisons::writeContactSheet() {
    const QString folder = QSettings().value(kSheetFolder, QDir::homePath()).toString();
    const QString path =
        askWhereToSave(m_window, tr("Write a contact sheet"), folder + QStringLiteral("/contact_sheet.png"),
                       tr("PNG pictures (*.png)"), {QStringLiteral("png"), true});
    if (path.isEmpty())
        return;
    QSettings().setValue(kSheetFolder, QFileInfo(path).path());
    saveSheet(path);
}

void Comparisons::saveSheet(const QString& path) {
    constexpr int kSide = 512;
    inBackground(
        this,
        [items = m_view->items(), heading = m_view->heading(), columns = m_view->columns(),
         font = m_window->font(), path, guard = SaveGuard()] {
            guard.check(toPath(path), TR("contact sheet"));
            writeSheet(contactSheet(items, heading, columns, kSide, font), path);
            return QString(path);
        },
        [this](const QString& written) { Q_EMIT told(tr("Wrote %1.").arg(written)); },
        [this](const QString& why) { Q_EMIT failed(why); });
}

} // namespace texloom::ui
