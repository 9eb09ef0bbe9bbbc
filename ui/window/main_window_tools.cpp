#include "ui/blend/blend_window.h"
#include "ui/common/message_bar.h"
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

void MainWindow::connectTools() {
    connect(m_actions.blend, &QAction::triggered, this, [this] {
        std::vector<NamedImage> all = images();
        const std::vector<NamedImage> earlier = earlierResults();
        all.insert(all.end(), earlier.begin(), earlier.end());
        auto* window = new BlendWindow(all, this);
        window->setAttribute(Qt::WA_DeleteOnClose);
        connect(window, &BlendWindow::exemplarWanted, this,
                [this](const QString& path) { openFiles({path}); });
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
