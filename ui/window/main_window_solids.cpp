#include "ui/common/message_bar.h"
#include "ui/exemplar/resource_folder.h"
#include "ui/maps/result_view.h"
#include "ui/volume/volume_page.h"
#include "ui/window/main_window.h"
#include "ui/window/run_display.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QStackedWidget>

namespace texloom::ui {

/// Generators that come with the program, and those of the user's own files.
QMenu* MainWindow::makeSolidMenu() {
    auto* menu = new QMenu(tr("S&olids"), this);
    menu->setObjectName(QStringLiteral("solids"));
    menu->setToolTipsVisible(true);
    const QString folder = resourceFolder(QStringLiteral("solids"));
    if (!folder.isEmpty())
        for (const QFileInfo& file :
             QDir(folder).entryInfoList({QStringLiteral("*.safetensors")}, QDir::Files))
            menu->addAction(file.completeBaseName().replace(QLatin1Char('_'), QLatin1Char(' ')), this,
                            [this, path = file.filePath()] { m_display->volumes()->openFile(path); })
                ->setToolTip(tr("A generator that was trained already: look at it in the Volume tab."));
    if (!menu->isEmpty())
        menu->addSeparator();
    menu->addAction(tr("&Open a solid…"), this, [this] {
        const QString path = QFileDialog::getOpenFileName(
            this, tr("Solid to look at"), {},
            tr("Generators and volumes (*.safetensors *.json);;Slices of a volume (*.png *.tif *.exr)"));
        if (!path.isEmpty())
            m_display->volumes()->openFile(path);
    });
    return menu;
}

void MainWindow::connectSolids() {
    VolumePage* const page = m_display->volumes();
    connect(page, &VolumePage::opened, this, [this, page] {
        m_centre->setCurrentWidget(m_results);
        m_results->showPage(page);
        page->setFocus();
    });
    connect(page, &VolumePage::refused, this, [this, page](const QString& why) {
        if (!page->isVisible())
            m_messages->say(MessageBar::Kind::Error, why);
    });
}

} // namespace texloom::ui
