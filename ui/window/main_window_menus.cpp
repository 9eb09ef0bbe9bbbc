#include "ui/common/appearance.h"
#include "ui/common/menu_keys.h"
#include "ui/common/message_bar.h"
#include "ui/compare/comparisons.h"
#include "ui/compare/tries.h"
#include "ui/exemplar/files.h"
#include "ui/exemplar/map_deriver.h"
#include "ui/inspector/inspector.h"
#include "ui/session/document.h"
#include "ui/session/preset_menu.h"
#include "ui/session/undo_history.h"
#include "ui/viewers/viewer_keys.h"
#include "ui/window/main_window.h"

#include <QActionGroup>
#include <QComboBox>
#include <QDockWidget>
#include <QFileInfo>
#include <QMenuBar>
#include <QToolBar>

namespace texloom::ui {

void MainWindow::makeMenus() {
    menuBar()->addMenu(makeFileMenu());
    QMenu* const edit = menuBar()->addMenu(tr("&Edit"));
    edit->addActions({m_undo->undoAction(), m_undo->redoAction()});
    edit->addSeparator();
    edit->addAction(m_actions.copyResult);
    menuBar()->addMenu(makeExemplarMenu());
    menuBar()->addMenu(makeSynthesisMenu());
    menuBar()->addMenu(makeViewMenu());
    menuBar()->addMenu(m_comparisons->makeMenu());
    menuBar()->addMenu(m_resultActions.makeMenu(this));
    menuBar()
        ->addMenu(tr("&Tools"))
        ->addActions({m_actions.extend, m_actions.blend, m_actions.variance, m_actions.stress});
    menuBar()->addMenu(tr("&Help"))->addActions({m_actions.shortcuts, m_actions.about});
}

QMenu* MainWindow::makeExemplarMenu() {
    auto* exemplar = new QMenu(tr("E&xemplar"), this);
    exemplar->addActions({m_actions.editExemplar, m_actions.addCompanions});
    auto* derive = new MapDeriver(m_store, exemplar);
    connect(derive, &MapDeriver::failed, this, &MainWindow::fail);
    exemplar->addMenu(derive);
    exemplar->addActions(
        {m_actions.lattice, m_actions.setMask, m_actions.clearMask, m_actions.removeExemplar});
    return exemplar;
}

/// F10 goes to the first menu, as everywhere; letters go to the menus before anything else.
void MainWindow::reserveKeys() {
    auto* first = new QAction(this);
    first->setShortcut(Qt::Key_F10);
    addAction(first);
    connect(first, &QAction::triggered, this, [this] {
        menuBar()->setFocus(Qt::MenuBarFocusReason);
        menuBar()->setActiveAction(menuBar()->actions().front());
    });
    reserveMenuKeys(menuBar(), this);
    keepLettersFromNumbers();
}

QMenu* MainWindow::makeFileMenu() {
    auto* file = new QMenu(tr("&File"), this);
    file->addAction(m_actions.open);
    QMenu* const recent = file->addMenu(tr("Open &recent"));
    connect(recent, &QMenu::aboutToShow, this, [this, recent] { fillRecentMenu(recent); });
    QMenu* const samples = file->addMenu(tr("&Samples"));
    for (const QString& path : bundledExemplars())
        samples->addAction(QFileInfo(path).completeBaseName(), this, [this, path] { openFiles({path}); });
    samples->setEnabled(!samples->isEmpty());
    file->addAction(m_actions.paste);
    file->addSeparator();
    m_document->addTo(file);
    file->addSeparator();
    file->addActions({m_actions.exportResult, m_actions.exportAgain});
    file->addSeparator();
    file->addAction(m_actions.quit);
    return file;
}

QMenu* MainWindow::makeSynthesisMenu() {
    auto* synthesis = new QMenu(tr("&Synthesis"), this);
    synthesis->addActions({m_actions.run, m_actions.addToQueue, m_actions.quick, m_actions.newSeedRun});
    synthesis->addSeparator();
    synthesis->addActions({m_actions.stop, m_actions.cancelRun});
    synthesis->addSeparator();
    synthesis->addActions({m_tries->allAction(), m_tries->someAction(), m_tries->sweepAction()});
    synthesis->addMenu(m_tries->exampleMenu());
    synthesis->addMenu(makeSolidMenu());
    synthesis->addSeparator();
    synthesis->addMenu(makePresetMenu());
    synthesis->addAction(m_actions.resetParameters);
    return synthesis;
}

QMenu* MainWindow::makePresetMenu() {
    auto* menu = new PresetMenu([this] { return m_inspector->changedSteps(); }, this);
    connect(menu, &PresetMenu::chosen, this, &MainWindow::usePreset);
    connect(menu, &PresetMenu::told, this,
            [this](const QString& text) { m_messages->say(MessageBar::Kind::Information, text); });
    connect(menu, &PresetMenu::failed, this, &MainWindow::fail);
    connect(menu, &PresetMenu::known, this, [this, menu](const QString& name) {
        m_messages->say(MessageBar::Kind::Information, tr("There is a preset %1 already.").arg(name),
                        tr("Replace it"), [menu, name] { menu->replace(name); });
    });
    return menu;
}

QMenu* MainWindow::makeViewMenu() {
    auto* view = new QMenu(tr("&View"), this);
    view->addActions({m_actions.fit, m_actions.actualSize, m_actions.zoomIn, m_actions.zoomOut,
                      m_actions.repeat, m_actions.seams, m_actions.navigator, m_actions.scope});
    view->addSeparator();
    view->addActions(
        {m_actions.resultTab, m_actions.synthesisTab, m_actions.positionTab, m_actions.copiesTab});
    view->addSeparator();
    for (const auto* dock : findChildren<QDockWidget*>())
        view->addAction(dock->toggleViewAction());
    view->addActions({m_actions.stackPanels, m_actions.resetLayout});
    view->addSeparator();
    view->addAction(m_actions.fullScreen);
    view->addMenu(makeAppearanceMenu());
    return view;
}

QMenu* MainWindow::makeAppearanceMenu() {
    auto* menu = new QMenu(tr("&Appearance"), this);
    auto* group = new QActionGroup(menu);
    const std::pair<QString, Appearance> ways[] = {{tr("As the &desktop"), Appearance::System},
                                                   {tr("&Light"), Appearance::Light},
                                                   {tr("Da&rk"), Appearance::Dark}};
    for (const auto& [title, appearance] : ways) {
        QAction* const action = menu->addAction(title);
        action->setCheckable(true);
        action->setChecked(savedAppearance() == appearance);
        group->addAction(action);
        connect(action, &QAction::triggered, this, [appearance = appearance] {
            saveAppearance(appearance);
            applyAppearance(appearance);
        });
    }
    return menu;
}

void MainWindow::makeToolBar() {
    QToolBar* const bar = addToolBar(tr("Toolbar"));
    bar->setObjectName(QStringLiteral("toolBar"));
    bar->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    bar->addActions({m_actions.open, m_actions.paste});
    bar->addSeparator();
    bar->addWidget(m_method);
    bar->addActions({m_actions.run, m_actions.stop, m_actions.quick});
    bar->addSeparator();
    bar->addAction(m_actions.repeat);
    bar->addAction(m_tries->allAction());
    bar->addSeparator();
    bar->addAction(m_actions.exportResult);
}

} // namespace texloom::ui
