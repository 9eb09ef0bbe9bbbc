#include "core/base/text.h"
#include "core/base/version.h"
#include "core/session/export/export.h"
#include "core/session/run/exemplar_use.h"
#include "ui/common/background.h"
#include "ui/common/icons.h"
#include "ui/common/message_bar.h"
#include "ui/common/readings.h"
#include "ui/common/shortcuts_dialog.h"
#include "ui/common/text.h"
#include "ui/exemplar/files.h"
#include "ui/exemplar/layer_dialog.h"
#include "ui/exemplar/material.h"
#include "ui/inspector/inspector.h"
#include "ui/inspector/output_group.h"
#include "ui/maps/result_view.h"
#include "ui/ports/result_inputs.h"
#include "ui/session/document.h"
#include "ui/session/undo_history.h"
#include "ui/window/main_window.h"
#include "ui/window/start_page.h"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QImage>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QSettings>
#include <QStatusBar>

#include <algorithm>
#include <utility>

namespace texloom::ui {

namespace {

const QString kOpenFolder = QStringLiteral("folders/open");
constexpr std::chrono::milliseconds kDragGrace{150};

bool isRecipe(const QString& path) {
    return path.endsWith(QStringLiteral(".json"), Qt::CaseInsensitive);
}

/// What a recipe needs, and the files that are not those it was made with.
struct LoadedRecipe {
    RunInput input;
    QStringList changed;
    std::string version; ///< of the build that made it
};

/// Whether the exemplar has something of its own that the methods would take.
bool hasOwnInputs(const ExemplarEntry& entry, const std::vector<RecipeStep>& steps) {
    const InputFiles& own = entry.exemplar.inputs;
    return std::any_of(own.begin(), own.end(),
                       [&steps](const auto& input) { return takesPort(steps, input.first); });
}

LoadedRecipe loadAll(const std::filesystem::path& path) {
    LoadedRecipe loaded;
    const Recipe recipe = readRecipe(path);
    loaded.version = recipe.version;
    loaded.input = loadRecipe(
        recipe, [&](const std::filesystem::path& file) { loaded.changed += toQString(file.filename()); });
    return loaded;
}

} // namespace

/// Everything that the next run, the runs that wait and the result that is shown are made from.
void MainWindow::tellFiles(OutputGuard& guard) const {
    const Session open = session();
    for (const RecipeFile* file : open.settings.files())
        guard.reads(file->path, TR("open here"));
    for (const QueuedJob& job : m_desk->queue()->jobs())
        guard.reads(sourcesOf(job.plan.recipe), TR("a source of a run that waits"));
    if (m_desk->result())
        guard.reads(sourcesOf(m_desk->result()->plan.recipe), TR("a source of the result that is shown"));
}

void MainWindow::openFiles(const QStringList& paths) {
    QStringList pictures;
    for (const QString& path : paths) {
        const QString file = QFileInfo(path).absoluteFilePath();
        if (isMaterial(file))
            openMaterials(file);
        else if (Document::isSession(file))
            m_document->open(file);
        else if (isRecipe(file))
            offerRecipe(file, tr("%1 holds the settings of a result.").arg(QFileInfo(file).fileName()));
        else
            pictures += file;
    }
    m_store->openAll(pictures);
}

void MainWindow::openMaterials(const QString& path) {
    readInBackground(
        this, QFileInfo(path).fileName(), [path] { return materialsIn(path); },
        [this](const std::vector<MaterialFiles>& materials) {
            for (const MaterialFiles& material : materials) {
                QStringList maps;
                for (const std::filesystem::path& map : material.maps)
                    maps += toQString(map);
                m_store->openMaterial(toQString(material.image), maps);
            }
        },
        [this](const QString& why) {
            if (!why.isEmpty())
                fail(why);
        });
}

/// Says which maps of the material lie beside a picture that was opened, until another is looked at.
void MainWindow::offerNeighbours(int id) {
    const ExemplarEntry* const entry = m_store->find(id);
    std::vector<std::filesystem::path> known;
    for (const ExemplarFile& map : entry->exemplar.companions)
        known.push_back(map.path);
    const auto offer = [this, id](const std::vector<std::filesystem::path>& beside) {
        if (beside.empty() || m_store->current() == nullptr || m_store->current()->id != id)
            return;
        QStringList names;
        for (const std::filesystem::path& map : beside)
            names += toQString(map.filename());
        const QString text =
            tr("Maps of the same material lie beside it: %1.").arg(names.join(QStringLiteral(", ")));
        m_messages->say(MessageBar::Kind::Information, text, tr("Add"), [this, id, beside] {
            for (const std::filesystem::path& map : beside)
                m_store->addCompanion(id, toQString(map));
        });
        connect(
            m_store, &ExemplarStore::currentChanged, m_messages, [this, text] { m_messages->dismiss(text); },
            Qt::SingleShotConnection);
    };
    inBackground(
        this, [image = entry->file().path, known] { return neighboursOf(image, known); }, offer,
        [](const QString&) {});
}

void MainWindow::openDialog() {
    const QString folder = QSettings().value(kOpenFolder).toString();
    const QStringList paths =
        QFileDialog::getOpenFileNames(this, tr("Open exemplars"), folder, pictureFilter());
    if (paths.isEmpty())
        return;
    QSettings().setValue(kOpenFolder, QFileInfo(paths.front()).path());
    openFiles(paths);
}

void MainWindow::fillRecentMenu(QMenu* menu) {
    menu->clear();
    for (const QString& path : recentFiles()) {
        QAction* const action =
            menu->addAction(icon(QStringLiteral("folder-recent")), QFileInfo(path).fileName(), this,
                            [this, path] { openFiles({path}); });
        action->setToolTip(path);
    }
    if (menu->isEmpty())
        menu->addAction(tr("Nothing opened yet"))->setEnabled(false);
    menu->setToolTipsVisible(true);
}

void MainWindow::paste() {
    if (const QMimeData* offered = QApplication::clipboard()->mimeData())
        take(*offered);
}

void MainWindow::take(const QMimeData& offered) {
    if (const std::string key = draggedResult(offered); !key.empty())
        return m_resultInputs->open(key);
    const QStringList files = localFiles(offered);
    if (!files.isEmpty())
        return openFiles(files);
    const auto picture = qvariant_cast<QImage>(offered.imageData());
    if (!picture.isNull()) {
        inBackground(
            this, [picture] { return savePastedPicture(picture); },
            [this](const QString& path) { m_store->open(path); }, [this](const QString& why) { fail(why); });
        return;
    }
    fail(offered.hasUrls()
             ? tr("Only files on this computer can be opened; save the picture first, then drop its file.")
             : tr("There is no picture in what was pasted; copy a picture or a picture file first."));
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    const bool result = !draggedResult(*event->mimeData()).empty();
    if (!result && !offersPicture(*event->mimeData()))
        return;
    event->acceptProposedAction();
    const std::vector<Port> ports = m_inspector->output()->ports();
    // A dragged result writes a file for other programs when it is asked for one.
    const bool files = !result && !localFiles(*event->mimeData()).isEmpty();
    const auto dragged = result  ? DropTargets::Dragged::Result
                         : files ? DropTargets::Dragged::Files
                                 : DropTargets::Dragged::Picture;
    if (m_store->current() != nullptr)
        return m_drop->open(dragged, useOf(m_inspector->steps()).masks, ports);
    if (!ports.empty())
        return m_drop->openWithoutExemplar(dragged, ports);
    m_start->setDropping(true);
    statusBar()->showMessage(tr("Let go to open it as an exemplar."));
}

void MainWindow::dragLeaveEvent(QDragLeaveEvent*) {
    m_start->setDropping(false);
    statusBar()->clearMessage();
    // The drag leaves the window when the targets come up under it, too.
    QTimer::singleShot(kDragGrace, m_drop, &DropTargets::closeUnlessEntered);
}

void MainWindow::dropOn(DropTargets::Target target, const QMimeData& offered) {
    const ExemplarEntry* const looked = m_store->current();
    if (looked == nullptr)
        return take(offered);
    const int current = looked->id;
    const QStringList files = localFiles(offered);
    if (target == DropTargets::Target::Companion) {
        for (const QString& file : files)
            m_store->addCompanion(current, file);
        return;
    }
    if (target == DropTargets::Target::Mask)
        return m_store->setMask(current, files.front());
    if (target == DropTargets::Target::Add)
        mixNext();
    if (target == DropTargets::Target::Exemplar)
        connect(
            m_store, &ExemplarStore::opened, this,
            [this, current](int id) {
                if (id != current)
                    m_store->remove(current);
            },
            Qt::SingleShotConnection);
    take(offered);
}

/// What is opened next is mixed with the exemplars in use.
void MainWindow::mixNext() {
    std::vector<int> used;
    for (const ExemplarEntry& entry : m_store->entries())
        if (entry.checked)
            used.push_back(entry.id);
    connect(
        m_store, &ExemplarStore::opened, this,
        [this, used] {
            for (const int id : used)
                m_store->restoreChecked(id, true);
        },
        Qt::SingleShotConnection);
}

void MainWindow::dropInto(const std::string& port, const QMimeData& offered) {
    OutputGroup* const output = m_inspector->output();
    if (const std::string key = draggedResult(offered); !key.empty())
        return m_resultInputs->put(port, key);
    const QStringList files = localFiles(offered);
    for (const QString& file : files)
        output->readInput(port, file);
    if (const auto picture = qvariant_cast<QImage>(offered.imageData()); files.isEmpty() && !picture.isNull())
        inBackground(
            this, [picture] { return savePastedPicture(picture); },
            [output, port](const QString& path) { output->readInput(port, path); },
            [this](const QString& why) { fail(why); });
}

void MainWindow::dropEvent(QDropEvent* event) {
    m_start->setDropping(false);
    m_drop->closeUnlessEntered();
    statusBar()->clearMessage();
    const bool besides = !centralWidget()->geometry().contains(event->position().toPoint());
    if (besides && !draggedResult(*event->mimeData()).empty())
        return; // let go over its own list
    event->acceptProposedAction();
    take(*event->mimeData());
}

void MainWindow::exemplarOpened(int id) {
    const ExemplarEntry* const entry = m_store->find(id);
    const QString path = toQString(entry->file().path);
    const bool own = path.startsWith(pastedFolder()) || path.startsWith(ownFolder());
    if (!own)
        addRecentFile(path);
    if (!entry->file().info.recipe.empty()) {
        offerRecipe(path, tr("%1 was made here and holds its settings.").arg(QFileInfo(path).fileName()));
    } else {
        if (m_messages->kind() == MessageBar::Kind::Error)
            m_messages->dismiss();
        offerNeighbours(id);
    }
    const bool first = m_store->entries().size() == 1 && !m_desk->result() && !m_desk->running();
    if (first && useOf(m_inspector->steps()).any)
        startRun(true);
}

void MainWindow::askForLayer(const LayerQuestion& question) {
    LayerDialog::ask(question, this, this);
}

void MainWindow::offerRecipe(const QString& path, const QString& text) {
    m_messages->say(MessageBar::Kind::Information, text, tr("Restore settings"),
                    [this, path] { loadRecipeFrom(path); });
}

void MainWindow::loadRecipeFrom(const QString& path) {
    readInBackground(
        this, QFileInfo(path).fileName(), [file = toPath(path)] { return loadAll(file); },
        [this](const LoadedRecipe& loaded) {
            restore(loaded.input);
            if (!loaded.changed.isEmpty())
                m_messages->say(
                    MessageBar::Kind::Information,
                    tr("Settings restored, but these files changed since, so the result will differ: %1.")
                        .arg(loaded.changed.join(QStringLiteral(", "))));
            else
                sayOtherBuild(loaded.version,
                              tr("The recipe was made by Texloom %1; this is %2, so the result may differ."));
        },
        [this](const QString& why) {
            if (!why.isEmpty())
                fail(why);
        });
}

void MainWindow::sayOtherBuild(const std::string& version, const QString& sentence) {
    if (!version.empty() && version != kVersion)
        m_messages->say(MessageBar::Kind::Information,
                        sentence.arg(QString::fromStdString(version), QLatin1String(kVersion)));
}

void MainWindow::restore(const RunInput& input) {
    if (input.exemplars.empty()) // what is open stays
        return applySettings(input);
    connect(
        m_store, &ExemplarStore::replaced, this, [this, input] { applySettings(input); },
        Qt::SingleShotConnection);
    m_store->replaceAll(input.exemplars);
}

void MainWindow::applySettings(const RunInput& input) {
    m_undo->asOne([this, &input] {
        m_method->setCurrentIndex(m_method->findData(QString::fromStdString(input.steps.front().method)));
        OutputGroup* const output = m_inspector->output();
        output->setOutputSize(input.size);
        output->setWrap(input.wrap);
        output->setSeed(input.seed);
        output->setPart(input.region);
        m_inspector->setSteps(input.steps);
        output->setInputs(input.inputs);
    });
    plan();
}

bool MainWindow::openExemplarsOf(const Recipe& recipe) {
    std::vector<int> ids;
    std::vector<double> weights;
    for (const RecipeExemplar& wanted : recipe.exemplars) {
        const ExemplarEntry* const entry = m_store->find(wanted);
        if (entry == nullptr || wanted.mask || !wanted.companions.empty() || !wanted.inputs.empty() ||
            hasOwnInputs(*entry, recipe.steps))
            return false;
        ids.push_back(entry->id);
        weights.push_back(wanted.weight);
    }
    if (!ids.empty())
        m_store->setCurrent(ids.front());
    if (!ids.empty())
        for (const ExemplarEntry& entry : std::vector(m_store->entries()))
            m_store->setChecked(entry.id, std::find(ids.begin(), ids.end(), entry.id) != ids.end());
    if (ids.size() > 1)
        for (std::size_t i = 0; i < ids.size(); ++i)
            m_store->setWeight(ids[i], weights[i]);
    return true;
}

void MainWindow::restoreRecipe(const Recipe& recipe, bool keepSize) {
    const Size size = keepSize ? m_inspector->output()->outputSize() : recipe.size;
    sayOtherBuild(recipe.version,
                  tr("The recipe was made by Texloom %1; this is %2, so the result may differ."));
    if (recipe.inputs.empty() && openExemplarsOf(recipe)) {
        RunInput input;
        input.steps = recipe.steps;
        input.size = size;
        input.wrap = recipe.wrap;
        input.seed = recipe.seed;
        if (!keepSize)
            input.region = recipe.region;
        return applySettings(input);
    }
    inBackground(
        this, [recipe] { return loadRecipe(recipe); },
        [this, size, keepSize](RunInput input) {
            input.size = size;
            if (keepSize)
                input.region.reset();
            restore(input);
        },
        [this](const QString& why) { fail(why); });
}

void MainWindow::showShortcuts() {
    auto* dialog = new ShortcutsDialog(findChildren<QAction*>(QString(), Qt::FindDirectChildrenOnly), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
}

void MainWindow::showAbout() {
    auto* box = new QMessageBox(this);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setWindowTitle(tr("About Texloom"));
    box->setTextFormat(Qt::RichText);
    box->setText(tr("<h3>Texloom %1</h3><p>A workbench for exemplar-based texture synthesis.</p><p>Free "
                    "software under the GNU General Public License, version 3 or later.</p>")
                     .arg(QLatin1String(kVersion)));
    box->open();
}

} // namespace texloom::ui
