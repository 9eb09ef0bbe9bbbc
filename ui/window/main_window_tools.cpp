#include "ui/blend/blend_window.h"
#include "ui/lattice/lattice_tool.h"
#include "ui/plots/figures_panel.h"
#include "ui/plots/variance_dialog.h"
#include "ui/viewers/result_view.h"
#include "ui/window/main_window.h"
#include "ui/window/message_bar.h"

#include <QComboBox>

namespace texloom::ui {

std::vector<NamedImage> MainWindow::images() const {
    std::vector<NamedImage> all;
    for (const ExemplarEntry& entry : m_store->entries())
        all.push_back({QString::fromStdString(entry.file().name()), entry.file()});
    if (m_result) {
        const ExemplarEntry* const made = m_store->find(m_shownExemplars.front().image);
        ExemplarFile file = made != nullptr ? made->file() : ExemplarFile{};
        file.path = m_result->fileName();
        file.image = std::shared_ptr<const Image>(m_result, &m_result->synthesis.image);
        all.push_back({tr("Result: %1").arg(QString::fromStdString(m_result->label())), std::move(file)});
    }
    return all;
}

void MainWindow::connectLattice() {
    connect(m_actions.lattice, &QAction::triggered, this, [this] {
        m_results->showPage(m_lattice);
        m_lattice->canvas()->setFocus();
    });
    connect(m_lattice, &LatticeTool::methodWanted, this,
            [this](const QString& id) { m_method->setCurrentIndex(m_method->findData(id)); });
}

void MainWindow::connectTools() {
    connect(m_actions.blend, &QAction::triggered, this, [this] {
        auto* window = new BlendWindow(images(), this);
        window->setAttribute(Qt::WA_DeleteOnClose);
        connect(window, &BlendWindow::exemplarWanted, this,
                [this](const QString& path) { openFiles({path}); });
        window->show();
    });
    connect(m_actions.variance, &QAction::triggered, this, [this] {
        if (m_store->entries().empty() && !m_result)
            return m_messages->say(MessageBar::Kind::Information,
                                   tr("Open an exemplar first: its patches are compared with each other."));
        auto* dialog = new VarianceDialog(images(), this);
        dialog->setAttribute(Qt::WA_DeleteOnClose);
        dialog->show();
    });
}

} // namespace texloom::ui
