#include "ui/window/shortcuts_dialog.h"

#include <QAction>
#include <QDialogButtonBox>
#include <QHeaderView>
#include <QTableWidget>
#include <QVBoxLayout>

#include <utility>

namespace texloom::ui {

namespace {

constexpr int kLines = 36;
constexpr int kWidth = 112;

void addRow(QTableWidget* table, const QString& keys, const QString& what) {
    const int row = table->rowCount();
    table->insertRow(row);
    table->setItem(row, 0, new QTableWidgetItem(keys));
    table->setItem(row, 1, new QTableWidgetItem(what));
}

} // namespace

ShortcutsDialog::ShortcutsDialog(const QList<QAction*>& actions, QWidget* parent) : QDialog(parent) {
    setObjectName(QStringLiteral("shortcutsDialog"));
    setWindowTitle(tr("Keyboard shortcuts"));
    auto* table = new QTableWidget(0, 2, this);
    table->setObjectName(QStringLiteral("shortcutsTable"));
    table->setHorizontalHeaderLabels({tr("Keys"), tr("What they do")});
    table->verticalHeader()->hide();
    table->verticalHeader()->setDefaultSectionSize(fontMetrics().height() * 3 / 2);
    table->horizontalHeader()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    table->horizontalHeader()->setStretchLastSection(true);
    table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table->setSelectionBehavior(QAbstractItemView::SelectRows);
    table->setShowGrid(false);
    table->setAccessibleName(windowTitle());
    for (const QAction* action : actions)
        if (!action->shortcut().isEmpty()) {
            const QString keys = action->shortcut().toString(QKeySequence::NativeText);
            addRow(table, keys, action->statusTip().remove(QStringLiteral(" (%1)").arg(keys)));
        }
    const std::pair<QString, QString> inViewer[] = {
        {tr("Wheel"), tr("In a picture: zoom at the cursor")},
        {tr("Drag"), tr("In a picture: move it")},
        {tr("Arrow keys"), tr("In a picture: move it")},
        {tr("Shift+arrow keys"), tr("In a picture: move from pixel to pixel and show where each came from")},
        {tr("Space"),
         tr("In the lattice: go to the next handle; the arrow keys move it by 1 px, with Shift by "
            "10 px, with Ctrl by 0.1 px")},
        {tr("Double click"), tr("On a parameter's label: reset it")},
        {tr("Return"), tr("In a comparison: take over the settings of the picture in use")},
        {tr("Ctrl+arrow keys"), tr("In a wipe: move the line")},
        {tr("Ctrl+Shift+arrow keys"), tr("In a wipe: turn the line")},
        {tr("Shift+R, G, B, A, C"), tr("In a comparison: show red, green, blue, alpha, or colour")}};
    for (const auto& [keys, what] : inViewer)
        addRow(table, keys, what);

    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* column = new QVBoxLayout(this);
    column->addWidget(table, 1);
    column->addWidget(buttons);
    resize(fontMetrics().averageCharWidth() * kWidth, fontMetrics().height() * kLines);
}

} // namespace texloom::ui
