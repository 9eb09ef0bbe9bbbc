#include "core/base/version.h"
#include "ui/common/background.h"
#include "ui/common/message_bar.h"
#include "ui/common/save_guard.h"
#include "ui/exemplar/exemplar_editor.h"
#include "ui/exemplar/files.h"
#include "ui/inspector/inspector.h"
#include "ui/inspector/output_group.h"
#include "ui/session/document.h"
#include "ui/session/run_recovery.h"
#include "ui/session/undo_history.h"
#include "ui/window/main_window.h"

#include <QAction>
#include <QComboBox>
#include <QFileInfo>
#include <QStackedWidget>

#include <algorithm>

namespace texloom::ui {

void MainWindow::makeDocument() {
    const auto read = [this] { return settingsOf(*m_method, *m_inspector); };
    const auto write = [this](const SettingsState& state) { showSettings(state, *m_method, *m_inspector); };
    m_undo = new UndoHistory(m_store, read, write, this);
    m_document =
        new Document({this, [this] { return session(); },
                      [this](const LoadedSession& loaded, const std::function<void()>& shown) {
                          showSession(loaded, shown);
                      },
                      [this](const std::function<void()>& shown) { startAfresh(shown); },
                      [this](const QString& text) { m_messages->say(MessageBar::Kind::Information, text); },
                      [this](const QString& text) { fail(text); }, [this] { return handmade(); }},
                     this);
    FilesInUse::all().add(this, [this](OutputGuard& guard) { tellFiles(guard); });
    connect(m_document, &Document::titleChanged, this, &MainWindow::showTitle);
    connect(m_desk->history(), &ResultHistory::scanned, this, &MainWindow::tidyFiles);
    showTitle();
}

void MainWindow::connectRecovery() {
    m_desk->setCheckpointFolder(m_document->recovery()->folder());
    connect(m_brokenRuns, &RunRecovery::failed, this, &MainWindow::fail);
    connect(m_brokenRuns, &RunRecovery::restoreWanted, this,
            [this](const Recipe& recipe) { restoreRecipe(recipe, false); });
    connect(m_brokenRuns, &RunRecovery::resumed, this, [this](const Recipe& recipe) {
        if (m_store->entries().empty()) // what is open stays
            restoreRecipe(recipe, false);
    });
}

void MainWindow::offerRecovery() {
    m_document->offerRecovery();
    m_brokenRuns->offer(m_document->recovery()->folder());
}

/// Whether an exemplar was edited or given a mask.
bool MainWindow::handmade() const {
    const std::vector<ExemplarEntry>& open = m_store->entries();
    return std::any_of(open.begin(), open.end(), [](const ExemplarEntry& entry) {
        return !entry.exemplar.edits.empty() || entry.exemplar.original().mask;
    });
}

/// Files made here that no result, and nothing that is to be recovered, names are of no use any more.
void MainWindow::tidyFiles() {
    std::vector<Recipe> recipes;
    for (const ResultEntry& entry : m_desk->history()->entries())
        recipes.push_back(entry.recipe);
    inBackground(
        this,
        [recipes, recovery = m_document->recovery()->folder()] {
            removeOldFiles(recipes, recovery);
            return true;
        },
        [](bool) {}, [](const QString&) {});
}

void MainWindow::showTitle() {
    const QString name = QFileInfo(m_document->file()).completeBaseName();
    setWindowTitle(name.isEmpty() ? tr("Texloom") : tr("%1[*] – Texloom").arg(name));
    setWindowModified(m_document->modified() && !name.isEmpty());
}

Session MainWindow::session() const {
    const SettingsState state = settingsOf(*m_method, *m_inspector);
    Session session;
    session.settings = state.settings;
    session.settings.version = kVersion;
    session.seedLocked = state.seedLocked;
    session.settings.inputs = recipeInputs(state.inputs);
    for (const ExemplarEntry& entry : m_store->entries()) {
        if (&entry == m_store->current())
            session.current = static_cast<int>(session.used.size());
        RecipeExemplar exemplar = recipeExemplar(entry.exemplar.original());
        exemplar.edits = entry.exemplar.edits;
        session.settings.exemplars.push_back(std::move(exemplar));
        session.used.push_back(entry.checked);
    }
    return session;
}

void MainWindow::showSession(const LoadedSession& loaded, const std::function<void()>& shown) {
    m_actions.editExemplar->setChecked(false);
    connect(
        m_store, &ExemplarStore::replaced, this,
        [this, loaded, shown] {
            std::vector<int> ids;
            for (const ExemplarEntry& entry : m_store->entries())
                ids.push_back(entry.id);
            if (!ids.empty())
                m_store->setCurrent(ids[static_cast<std::size_t>(loaded.session.current)]);
            for (std::size_t i = 0; i < ids.size(); ++i)
                m_store->setChecked(ids[i], loaded.session.used[i]);
            {
                const UndoHistory::Pause pause(m_undo);
                showSettings({loaded.session.settings, loaded.inputs, loaded.session.seedLocked}, *m_method,
                             *m_inspector);
            }
            m_undo->clear();
            shown();
            sayOtherBuild(loaded.session.settings.version,
                          tr("The session was saved by Texloom %1; this is %2, so results may differ."));
            plan();
        },
        Qt::SingleShotConnection);
    m_store->replaceAll(loaded.exemplars);
}

void MainWindow::startAfresh(const std::function<void()>& shown) {
    m_actions.editExemplar->setChecked(false);
    connect(
        m_store, &ExemplarStore::replaced, this,
        [this, shown] {
            const UndoHistory::Pause pause(m_undo);
            m_desk->clear();
            m_messages->dismiss();
            showSettings(m_firstSettings, *m_method, *m_inspector);
            m_inspector->output()->forgetSize();
            m_centre->setCurrentIndex(0);
            m_undo->clear();
            shown();
            plan();
        },
        Qt::SingleShotConnection);
    m_store->replaceAll({});
}

void MainWindow::editExemplar(bool edit) {
    if (edit)
        m_centre->setCurrentWidget(m_editor);
    else if (m_centre->currentWidget() == m_editor)
        m_centre->setCurrentIndex(1);
}

} // namespace texloom::ui
