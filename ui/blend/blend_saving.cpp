#include "core/base/text.h"
#include "core/session/export/export.h"
#include "ui/blend/blend_window.h"
#include "ui/common/save_guard.h"
#include "ui/common/text.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QFileInfo>
#include <QMenu>
#include <QPushButton>
#include <QSettings>

#include <algorithm>
#include <memory>

namespace texloom::ui {

void BlendWindow::fillSaveMenu() {
    QMenu* const menu = m_save->menu();
    menu->clear();
    for (std::size_t way = 0; way < m_cells.size(); ++way) {
        QAction* const action =
            menu->addAction(tr("%1…").arg(m_cells[way].title), this, [this, way] { saveAs(way); });
        connect(menu, &QMenu::aboutToShow, action, [this, action, way] {
            action->setVisible(m_cells[way].shown->isChecked());
            action->setEnabled(viewer(way)->picture() != nullptr);
        });
    }
}

void BlendWindow::offerToSave() {
    m_save->setEnabled(std::any_of(m_cells.begin(), m_cells.end(), [](const Cell& cell) {
        return cell.shown->isChecked() && cell.viewer->picture() != nullptr;
    }));
}

void BlendWindow::saveAs(std::size_t way) {
    const NamedImage* const first = chosen(0);
    const NamedImage* const second = chosen(1);
    const QString name = tr("%1 and %2.png").arg(first->title, second->title);
    const QString folder = QSettings().value(kBlendFolder).toString();
    const QString path =
        askWhereToSave(this, tr("Save the blend"), QDir(folder).filePath(name),
                       tr("Pictures (*.png *.jpg *.tif *.exr *.hdr)"), {QStringLiteral("png")});
    if (path.isEmpty())
        return;
    QSettings().setValue(kBlendFolder, QFileInfo(path).path());
    save(way, path);
}

void BlendWindow::save(std::size_t way, const QString& path) {
    const NamedImage* const first = chosen(0);
    const std::shared_ptr<const DisplayPicture> picture = viewer(way)->picture();
    if (first == nullptr || !picture)
        return;
    m_writing.start(
        {},
        [picture, path, like = first->file, guard = SaveGuard()](JobContext& context) {
            guard.check(toPath(path), TR("blend"));
            exportPicture(toPath(path), picture->values(), like, [&] { context.check(); });
            return path;
        },
        [this](const QString& written) {
            m_written = written;
            m_use->show();
            say(tr("Wrote %1.").arg(written));
        },
        [this](const QString& why) { say(why); });
}

} // namespace texloom::ui
