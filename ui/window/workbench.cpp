#include "ui/window/workbench.h"

#include "core/base/text.h"
#include "ui/common/background.h"
#include "ui/common/icons.h"
#include "ui/common/message_bar.h"
#include "ui/common/shortcuts.h"
#include "ui/common/text.h"
#include "ui/compare/compare_view.h"
#include "ui/compare/contact_sheet.h"
#include "ui/compare/grid_run.h"
#include "ui/compare/methods_dialog.h"
#include "ui/compare/sweep_dialog.h"
#include "ui/jobs/job_panel.h"
#include "ui/log/log_panel.h"
#include "ui/maps/result_view.h"
#include "ui/results/difference_dialog.h"
#include "ui/results/limits_dialog.h"
#include "ui/runs/result_text.h"
#include "ui/window/main_window.h"

#include <QAction>
#include <QDir>
#include <QDockWidget>
#include <QFileDialog>
#include <QMenu>
#include <QSettings>
#include <QStandardPaths>

#include <algorithm>
#include <utility>

namespace texloom::ui {

namespace {

const QString kFolder = QStringLiteral("results/folder");
const QString kMemory = QStringLiteral("results/memory");
const QString kDisk = QStringLiteral("results/disk");
const QString kSheetFolder = QStringLiteral("folders/sheet");

QString resultFolder() {
    const QString cache = QStandardPaths::writableLocation(QStandardPaths::CacheLocation);
    return QSettings().value(kFolder, cache + QStringLiteral("/results")).toString();
}

/// A picture from which a thumbnail can be made quickly.
const QImage& smallPicture(const DisplayPicture& picture) {
    constexpr double kSide = 512;
    return picture.levelFor(kSide / picture.size().longerSide());
}

/// The picture that a comparison shows of a result, with its label.
CompareItem itemOf(const ResultEntry& entry, const std::shared_ptr<const Result>& result) {
    const std::shared_ptr<const Image> image(result, &result->synthesis.image);
    const QString label = entry.title.empty() ? labelText(entry) : titleText(entry);
    return {label, std::make_shared<const DisplayPicture>(image), {}, entry.key};
}

/// "Patch size 16 px · Seed 2".
QString labelOf(const SweepCell& cell) {
    QStringList parts;
    for (const SweepCell::Part& part : cell.parts) {
        parts += QStringLiteral("%1 %2").arg(translated(part.title), translated(part.value));
        if (!part.unit.empty())
            parts.back() += QLatin1Char(' ') + translated(part.unit);
    }
    return parts.join(QStringLiteral(" · "));
}

/// What the runs of a sweep have in common: "Image quilting · bark · 512 × 512".
QString headingOf(const RunInput& input) {
    QStringList methods{translated(findMethod(input.method).info().title)};
    for (const RecipeStep& step : input.then)
        methods += translated(findMethod(step.method).info().title);
    QStringList names;
    for (const RunExemplar& exemplar : input.exemplars)
        names += QString::fromStdString(exemplar.image.name());
    return QStringLiteral("%1 · %2 · %3")
        .arg(methods.join(QStringLiteral(" + ")), names.join(QStringLiteral(", ")), sizeText(input.size));
}

QString durationOf(double seconds) {
    return QString::fromStdString(durationText(seconds));
}

} // namespace

Workbench::Workbench(RunController* controller, MainWindow* window)
    : QObject(window), m_window(window), m_queue(new JobQueue(controller, this)),
      m_history(new ResultHistory(resultFolder(), this)), m_resultActions(window),
      m_results(new ResultPanel(m_history, m_resultActions, window)), m_jobs(new JobPanel(m_queue, window)),
      m_log(new LogPanel(window)), m_compareActions(window),
      m_compare(new CompareView(m_compareActions, window)),
      m_grid(new GridRun(m_queue, m_history, m_compare, this)), m_tryAll(new QAction(window)),
      m_trySome(new QAction(window)), m_sweep(new QAction(window)) {
    const QSettings settings;
    m_history->setMemoryBudget(settings.value(kMemory, quint64{ResultStore::kMemoryBudget}).toULongLong());
    m_history->setDiskBudget(settings.value(kDisk, quint64{ResultStore::kDiskBudget}).toULongLong());
    connectQueue();
    connectResults();
    connectCompare();
}

void Workbench::addDocks() {
    QDockWidget* before = nullptr;
    const std::tuple<QWidget*, QString, const char*> docks[] = {{m_results, tr("Results"), "resultDock"},
                                                                {m_jobs, tr("Jobs"), "jobDock"},
                                                                {m_log, tr("Log"), "logDock"}};
    for (const auto& [content, title, name] : docks) {
        auto* dock = new QDockWidget(title, m_window);
        dock->setObjectName(QLatin1String(name));
        dock->setWidget(content);
        m_window->addDockWidget(Qt::BottomDockWidgetArea, dock);
        if (before != nullptr)
            m_window->tabifyDockWidget(before, dock);
        before = dock;
    }
    m_window->findChild<QDockWidget*>(QStringLiteral("resultDock"))->raise();
}

QMenu* Workbench::makeResultsMenu() {
    auto* menu = new QMenu(tr("&Results"), m_window);
    menu->addActions(
        {m_resultActions.show, m_resultActions.restore, m_resultActions.compare, m_resultActions.difference});
    menu->addSeparator();
    menu->addActions({m_resultActions.pin, m_resultActions.rename, m_resultActions.remove});
    menu->addSeparator();
    menu->addAction(tr("&Limits…"), this, &Workbench::setLimits)
        ->setObjectName(QStringLiteral("resultLimits"));
    return menu;
}

void Workbench::connectQueue() {
    connect(m_queue, &JobQueue::started, this,
            [this](int id) { m_log->add(tr("Started: %1").arg(m_queue->find(id)->label)); });
    connect(m_queue, &JobQueue::finished, this, &Workbench::keep);
    connect(m_jobs, &JobPanel::watchWanted, m_window, &MainWindow::watch);
    connect(m_queue, &JobQueue::stopped, this, [this](const QueuedJob& job, double fraction) {
        m_log->add(tr("Stopped at %1: %2").arg(percentText(fraction), job.label));
    });
    connect(m_queue, &JobQueue::failed, this,
            [this](const QueuedJob& job) { m_log->add(tr("Failed: %1: %2").arg(job.label, job.problem)); });
}

void Workbench::connectResults() {
    connect(m_history, &ResultHistory::remarked, m_log, &LogPanel::add);
    connect(m_results, &ResultPanel::showWanted, this, &Workbench::show);
    connect(m_results, &ResultPanel::restoreWanted, this, &Workbench::restore);
    connect(m_results, &ResultPanel::differenceWanted, this, &Workbench::showDifference);
    connect(m_results, &ResultPanel::compareWanted, this, [this](const std::vector<std::string>& keys) {
        compareResults(keys, m_compareActions.exemplar->isChecked());
    });
    connect(m_results, &ResultPanel::removed, this, [this](const QString& sentence) {
        m_window->messages()->say(MessageBar::Kind::Information, sentence, tr("Undo"),
                                  [this] { m_history->undoRemove(); });
    });
}

void Workbench::keep(const QueuedJob& job, const std::shared_ptr<const Result>& result,
                     const RunPictures& pictures) {
    const std::string key = m_history->add(result, job.quick, smallPicture(*pictures.result));
    m_grid->keep(job.id, key, pictures);
    if (job.shown)
        m_results->select({key});
    m_log->add(tr("Finished in %1: %2").arg(durationOf(result->seconds), job.label));
    for (const std::string& note : result->synthesis.notes)
        m_log->add(tr("Note: %1").arg(translated(note)));
}

void Workbench::show(const std::string& key) {
    const auto show = [this, key](const std::shared_ptr<const Result>& result) {
        const ResultEntry* const entry = m_history->find(key);
        const bool quick = entry != nullptr && entry->quick;
        inBackground(
            this, [result] { return picturesOf(result); },
            [this, key, result, quick](const RunPictures& pictures) {
                m_window->showResult(result, pictures, quick);
                m_tabs->setTab(ResultView::ResultTab);
                m_results->select({key});
            },
            [this](const QString& why) { m_window->fail(why); });
    };
    m_history->want(key, show, [this](const QString& why) { m_window->fail(why); });
}

void Workbench::restore(const std::string& key) {
    if (const ResultEntry* entry = m_history->find(key))
        m_window->restoreRecipe(entry->recipe, entry->quick);
}

void Workbench::showDifference(const std::string& first, const std::string& second) {
    auto* dialog = new DifferenceDialog(*m_history->find(first), *m_history->find(second), m_window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
}

void Workbench::setLimits() {
    auto* dialog = new LimitsDialog(m_history->store().memoryBudget(), m_history->store().diskBudget(),
                                    resultFolder(), m_window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog] {
        QSettings settings;
        settings.setValue(kMemory, quint64{dialog->memory()});
        settings.setValue(kDisk, quint64{dialog->disk()});
        m_history->setMemoryBudget(dialog->memory());
        m_history->setDiskBudget(dialog->disk());
    });
    dialog->open();
}

void Workbench::addPages(ResultView* tabs) {
    m_tabs = tabs;
    tabs->addPage(m_compare, tr("Compare"), tr("Several results and exemplars beside one another."));
}

QMenu* Workbench::makeCompareMenu() {
    auto* menu = new QMenu(tr("&Compare"), m_window);
    menu->addActions(
        {m_compareActions.grid, m_compareActions.wipe, m_compareActions.toggle, m_compareActions.difference});
    menu->addSeparator();
    menu->addAction(m_compareActions.exemplar);
    menu->addMenu(m_compareActions.exemplars);
    menu->addActions({m_compareActions.link, m_compareActions.sheet});
    return menu;
}

void Workbench::connectCompare() {
    for (const auto mode :
         {CompareMode::Grid, CompareMode::Wipe, CompareMode::Toggle, CompareMode::Difference})
        connect(m_compareActions.mode(mode), &QAction::triggered, this, [this, mode] { chooseMode(mode); });
    connect(m_compareActions.exemplar, &QAction::triggered, this,
            [this](bool shown) { showExemplars(shown ? exemplarsOf(m_compared) : std::set<int>()); });
    connect(m_compareActions.exemplars, &QMenu::aboutToShow, this, &Workbench::listExemplars);
    connect(m_compareActions.sheet, &QAction::triggered, this, &Workbench::writeContactSheet);
    connect(m_compare, &CompareView::useWanted, this, &Workbench::restore);
    m_tryAll->setText(tr("Try &all methods"));
    m_tryAll->setObjectName(QStringLiteral("tryAll"));
    m_tryAll->setIcon(icon(QStringLiteral("grid")));
    setHelp(m_tryAll, tr("Make a preview with every method, the quickest first, and compare them"));
    m_trySome->setText(tr("Try &some methods…"));
    m_trySome->setObjectName(QStringLiteral("trySome"));
    setHelp(m_trySome, tr("Choose methods, make a run with each and compare them"));
    m_sweep->setText(tr("Parameter s&weep…"));
    m_sweep->setObjectName(QStringLiteral("sweep"));
    setHelp(m_sweep, tr("Make a run for every combination of some values and compare them"));
    connect(m_trySome, &QAction::triggered, this, &Workbench::trySome);
    connect(m_tryAll, &QAction::triggered, this, &Workbench::tryAll);
    connect(m_sweep, &QAction::triggered, this, &Workbench::startSweep);
}

void Workbench::setCanRun(bool settings, bool exemplar) {
    m_tryAll->setEnabled(exemplar);
    m_trySome->setEnabled(exemplar);
    m_sweep->setEnabled(settings);
}

void Workbench::showCompare() {
    m_window->showResults();
    m_tabs->showPage(m_compare);
}

void Workbench::chooseMode(CompareMode mode) {
    const bool seen = m_compare->isVisible();
    if (m_compare->pictures() >= 2 || seen) {
        // Choosing Toggle again shows the other picture, but not while nobody sees the first.
        if (seen || m_compare->mode() != mode)
            m_compare->setMode(mode);
        return showCompare();
    }
    std::vector<std::string> lastTwo;
    for (const ResultEntry& entry : m_history->entries())
        lastTwo.push_back(entry.key);
    if (lastTwo.size() > 2)
        lastTwo.erase(lastTwo.begin(), lastTwo.end() - 2);
    if (lastTwo.empty())
        return showCompare();
    compareResults(lastTwo, false);
    connect(
        m_compare, &CompareView::replaced, this, [this, mode] { m_compare->setMode(mode); },
        static_cast<Qt::ConnectionType>(Qt::QueuedConnection | Qt::SingleShotConnection));
}

struct Workbench::Gathering {
    std::vector<std::string> keys;
    std::vector<CompareItem> items;
};

void Workbench::compareResults(const std::vector<std::string>& keys, bool exemplar) {
    m_compared = keys;
    std::erase_if(m_compared, [this](const std::string& key) { return m_history->find(key) == nullptr; });
    auto gathering = std::make_shared<Gathering>();
    if (exemplar)
        gathering->items = exemplarItems(exemplarsOf(m_compared));
    gathering->keys = m_compared;
    std::sort(gathering->keys.begin(), gathering->keys.end());
    gather(gathering);
}

void Workbench::gather(const std::shared_ptr<Gathering>& gathering) {
    if (gathering->keys.empty()) {
        m_compare->setItems(std::move(gathering->items));
        return showCompare();
    }
    const std::string key = gathering->keys.front();
    gathering->keys.erase(gathering->keys.begin());
    const auto failed = [this, gathering, key](const QString& why) {
        const ResultEntry* const entry = m_history->find(key);
        gathering->items.push_back({entry != nullptr ? labelText(*entry) : QString(), nullptr, why, {}});
        gather(gathering);
    };
    const auto got = [this, gathering, key, failed](const std::shared_ptr<const Result>& result) {
        const ResultEntry* const entry = m_history->find(key);
        if (entry == nullptr)
            return failed(tr("This result was removed."));
        inBackground(
            this, [entry = *entry, result] { return itemOf(entry, result); },
            [this, gathering](CompareItem item) {
                gathering->items.push_back(std::move(item));
                gather(gathering);
            },
            failed);
    };
    m_history->want(key, got, failed);
}

/// Those exemplars of the results that are open; the one that is looked at if there are none.
std::set<int> Workbench::exemplarsOf(const std::vector<std::string>& keys) const {
    const ExemplarStore& store = *m_window->store();
    std::set<int> ids;
    for (const std::string& key : keys)
        for (const RecipeExemplar& wanted : m_history->find(key)->recipe.exemplars)
            if (const ExemplarEntry* entry = store.find(wanted))
                ids.insert(entry->id);
    if (ids.empty() && store.current() != nullptr)
        ids.insert(store.current()->id);
    return ids;
}

std::vector<CompareItem> Workbench::exemplarItems(const std::set<int>& ids) const {
    std::vector<CompareItem> items;
    for (const int id : ids)
        if (const ExemplarEntry* entry = m_window->store()->find(id)) {
            const QString name = QString::fromStdString(entry->file().name());
            items.push_back({tr("%1 · exemplar · %2").arg(name, sizeText(entry->file().image->size())),
                             entry->picture,
                             {},
                             {}});
            items.back().exemplar = id;
        }
    return items;
}

std::set<int> Workbench::exemplarsShown() const {
    std::set<int> ids;
    for (const CompareItem& item : m_compare->items())
        if (item.exemplar > 0)
            ids.insert(item.exemplar);
    return ids;
}

/// Shows these exemplars before the results of the comparison, which stay.
void Workbench::showExemplars(const std::set<int>& ids) {
    std::vector<CompareItem> items = exemplarItems(ids);
    for (const CompareItem& item : m_compare->items())
        if (item.exemplar == 0)
            items.push_back(item);
    m_compare->setItems(std::move(items), 0, QString(m_compare->heading()));
    m_compareActions.exemplar->setChecked(!ids.empty());
}

void Workbench::listExemplars() {
    QMenu* const menu = m_compareActions.exemplars;
    menu->clear();
    const std::set<int> shown = exemplarsShown();
    for (const ExemplarEntry& entry : m_window->store()->entries()) {
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
            showCompare();
        });
    }
    if (menu->isEmpty())
        menu->addAction(tr("No exemplar is open"))->setEnabled(false);
}

void Workbench::tryAll() {
    std::vector<std::string> ids;
    for (const Method& method : methods())
        ids.push_back(method.id());
    tryMethods(ids, true);
}

void Workbench::trySome() {
    auto* dialog = new MethodsDialog(sizeText(m_window->input(false).size), m_window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this,
            [this, dialog] { tryMethods(dialog->chosen(), dialog->quick()); });
    dialog->open();
}

/// One run with each method on the exemplar that is looked at, with its defaults.
void Workbench::tryMethods(const std::vector<std::string>& ids, bool quick) {
    const ExemplarEntry* const current = m_window->store()->current();
    if (current == nullptr)
        return;
    const RunInput asked = m_window->input(quick);
    std::vector<GridEntry> entries;
    for (const std::string& id : ids) {
        const Method& method = findMethod(id);
        RunInput input;
        input.method = id;
        input.exemplars = {current->exemplar};
        if (!method.info().usesMask)
            input.exemplars.front().mask.reset();
        input.size = asked.size;
        input.wrap = method.info().wraps ? asked.wrap : Wrap{};
        input.seed = asked.seed;
        input.threads = asked.threads;
        const QString label = tr("%1 · seed %2 · %3")
                                  .arg(translated(method.info().title))
                                  .arg(input.seed)
                                  .arg(sizeText(input.size));
        entries.push_back({label, std::move(input)});
    }
    showCompare();
    m_compared.clear();
    const QString heading = tr("%1 · seed %2 · %3")
                                .arg(QString::fromStdString(current->file().name()))
                                .arg(asked.seed)
                                .arg(sizeText(asked.size));
    m_grid->start(std::move(entries), exemplarItems({current->id}), {heading, 0, quick, true});
}

void Workbench::startSweep() {
    auto* dialog = new SweepDialog(m_window->input(false), m_window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog] {
        std::vector<GridEntry> entries;
        for (const SweepCell& cell : dialog->cells()) {
            entries.push_back({labelOf(cell), cell.input});
            if (dialog->quick())
                entries.back().input.size = quickSize(cell.input.size);
        }
        showCompare();
        m_compared.clear();
        const QString heading = entries.empty() ? QString() : headingOf(entries.front().input);
        m_grid->start(std::move(entries), {}, {heading, dialog->columns(), dialog->quick(), false});
    });
    dialog->open();
}

void Workbench::writeContactSheet() {
    constexpr int kSide = 512;
    const QString folder = QSettings().value(kSheetFolder, QDir::homePath()).toString();
    const QString path = QFileDialog::getSaveFileName(m_window, tr("Write a contact sheet"),
                                                      folder + QStringLiteral("/contact_sheet.png"),
                                                      tr("PNG pictures (*.png)"));
    if (path.isEmpty())
        return;
    QSettings().setValue(kSheetFolder, QFileInfo(path).path());
    inBackground(
        this,
        [items = m_compare->items(), heading = m_compare->heading(), columns = m_compare->columns(),
         font = m_window->font(), path] {
            writeSheet(contactSheet(items, heading, columns, kSide, font), path);
            return QString(path);
        },
        [this](const QString& written) {
            m_window->messages()->say(MessageBar::Kind::Information, tr("Wrote %1.").arg(written));
        },
        [this](const QString& why) { m_window->fail(why); });
}

} // namespace texloom::ui
