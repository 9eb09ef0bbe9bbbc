#include "core/image/selection.h"
#include "ui/blend/blend_window.h"
#include "ui/common/message_bar.h"
#include "ui/compare/tries.h"
#include "ui/lattice/lattice_tool.h"
#include "ui/maps/result_view.h"
#include "ui/plots/figures_panel.h"
#include "ui/plots/stress_dialog.h"
#include "ui/plots/variance_dialog.h"
#include "ui/runs/result_text.h"
#include "ui/session/undo_history.h"
#include "ui/window/hovers.h"
#include "ui/window/main_window.h"

#include <QComboBox>

#include <algorithm>
#include <utility>

namespace texloom::ui {

namespace {

/// More earlier results than these are chosen from in their dock.
constexpr std::size_t kMostResults = 40;

/// A result as if it had been read from a file such as `like`.
ExemplarFile fileOf(const std::shared_ptr<const Result>& result, const ExemplarEntry* like) {
    ExemplarFile file = like != nullptr ? like->file() : ExemplarFile{};
    file.path = result->fileName();
    file.image = std::shared_ptr<const Image>(result, &result->synthesis.image);
    return file;
}

} // namespace

std::vector<NamedImage> MainWindow::images() const {
    std::vector<NamedImage> all;
    for (const ExemplarEntry& entry : m_store->entries())
        all.push_back({QString::fromStdString(entry.file().name()), entry.file()});
    if (const auto& result = m_desk->result())
        all.push_back({tr("Result: %1").arg(QString::fromStdString(result->label())),
                       fileOf(result, openExemplar(*m_desk, *m_store, 0))});
    return all;
}

std::vector<NamedImage> MainWindow::earlierResults() {
    std::vector<NamedImage> all;
    const std::vector<ResultEntry>& entries = m_desk->history()->entries();
    for (auto entry = entries.rbegin(); entry != entries.rend() && all.size() < kMostResults; ++entry) {
        const auto fetch = [this, key = entry->key](const NamedImage::Fetched& done,
                                                    const NamedImage::Failed& failed) {
            m_desk->history()->want(
                key,
                [this, done](const std::shared_ptr<const Result>& result) {
                    const ExemplarEntry* const made =
                        result->plan.recipe.exemplars.empty()
                            ? nullptr
                            : m_store->find(result->plan.recipe.exemplars.front());
                    done(fileOf(result, made));
                },
                failed);
        };
        all.push_back({tr("Earlier: %1").arg(labelText(*entry)), {}, fetch});
    }
    return all;
}

void MainWindow::connectLattice() {
    connect(m_actions.lattice, &QAction::triggered, this, [this] {
        m_results->showPage(m_lattice);
        m_lattice->canvas()->setFocus();
    });
    connect(m_lattice, &LatticeTool::drawnAnew, this,
            [this](const LatticeTool::Drawn& before, const LatticeTool::Drawn& after) {
                m_undo->done(
                    tr("Lattice"), QStringLiteral("lattice"), [this, before] { m_lattice->restore(before); },
                    [this, after] { m_lattice->restore(after); });
            });
    connect(m_lattice, &LatticeTool::methodWanted, this,
            [this](const QString& id) { m_method->setCurrentIndex(m_method->findData(id)); });
}

/// @param first images to choose from before those that are open and those made earlier.
BlendWindow* MainWindow::openBlend(std::vector<NamedImage> first) {
    for (const std::vector<NamedImage>& more : {images(), earlierResults()})
        first.insert(first.end(), more.begin(), more.end());
    auto* window = new BlendWindow(first, this);
    window->setAttribute(Qt::WA_DeleteOnClose);
    connect(window, &BlendWindow::exemplarWanted, this, [this](const QString& path) { openFiles({path}); });
    return window;
}

void MainWindow::connectTools() {
    connect(m_actions.blend, &QAction::triggered, this, [this] { openBlend({})->show(); });
    connect(m_tries, &Tries::joinsWanted, this, [this](const std::vector<JoinInput>& joins) {
        // Those of the first join come first, so that they are chosen.
        std::vector<NamedImage> all;
        for (const JoinInput& join : joins)
            for (const ExemplarFile* file : {&join.first, &join.second})
                if (std::none_of(all.begin(), all.end(),
                                 [&](const NamedImage& known) { return known.file.path == file->path; }))
                    all.push_back({QString::fromStdString(file->name()), *file});
        BlendWindow* const window = openBlend(std::move(all));
        window->setTool(*joins.front().tool);
        window->setValues(joins.front().settings);
        if (joins.front().region)
            window->setRegion(selections::inverted(*joins.front().region));
        window->show();
    });
    connect(m_actions.stress, &QAction::triggered, this, [this] {
        RunInput first = input(false);
        first.inputs.clear();
        first.region.reset();
        for (RunExemplar& exemplar : first.exemplars)
            exemplar.companions.clear();
        auto* dialog = new StressDialog(std::move(first), this);
        dialog->setAttribute(Qt::WA_DeleteOnClose);
        dialog->show();
    });
    connect(m_actions.variance, &QAction::triggered, this, [this] {
        if (m_store->entries().empty() && !m_desk->result())
            return m_messages->say(MessageBar::Kind::Information,
                                   tr("Open an exemplar first: its patches are compared with each other."));
        auto* dialog = new VarianceDialog(images(), this);
        dialog->setAttribute(Qt::WA_DeleteOnClose);
        dialog->show();
    });
}

} // namespace texloom::ui
