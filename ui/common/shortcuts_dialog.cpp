#include "ui/common/shortcuts_dialog.h"

#include "ui/common/screen_size.h"
#include "ui/common/shortcuts.h"

#include <QAction>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include <utility>

namespace texloom::ui {

namespace {

constexpr int kLines = 38;
constexpr int kWidth = 112;

void setRow(QTableWidget* table, int row, const QString& keys, const QString& what) {
    table->setItem(row, 0, new QTableWidgetItem(keys));
    table->setItem(row, 1, new QTableWidgetItem(what));
    table->item(row, 1)->setToolTip(what);
}

} // namespace

ShortcutsDialog::ShortcutsDialog(const QList<QAction*>& actions, QWidget* parent)
    : QDialog(parent), m_table(makeTable()), m_keys(new QKeySequenceEdit(this)),
      m_take(new QPushButton(tr("&Use these keys"), this)),
      m_reset(new QPushButton(tr("&Back to the original"), this)), m_said(new QLabel(this)) {
    setObjectName(QStringLiteral("shortcutsDialog"));
    setWindowTitle(tr("Keyboard shortcuts"));
    m_table->setAccessibleName(windowTitle());
    for (const bool withKeys : {true, false}) // those that have none yet come last
        for (QAction* action : actions)
            if (!action->objectName().isEmpty() && action->shortcut().isEmpty() != withKeys)
                m_actions += action;
    m_table->setRowCount(static_cast<int>(m_actions.size()));
    for (int row = 0; row < m_table->rowCount(); ++row)
        showKeys(row);
    addFixedRows();
    m_said->setObjectName(QStringLiteral("shortcutSaid"));
    m_said->setWordWrap(true);

    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* column = new QVBoxLayout(this);
    column->addWidget(m_table, 1);
    column->addLayout(makeEditor());
    column->addWidget(m_said);
    column->addWidget(buttons);
    connect(m_table, &QTableWidget::currentCellChanged, this, &ShortcutsDialog::rowChosen);
    m_table->setCurrentCell(0, 0);
    m_table->setFocus();
    resizeWithinScreen(this, {fontMetrics().averageCharWidth() * kWidth, fontMetrics().height() * kLines});
}

QTableWidget* ShortcutsDialog::makeTable() {
    auto* table = new QTableWidget(0, 2, this);
    table->setObjectName(QStringLiteral("shortcutsTable"));
    table->setHorizontalHeaderLabels({tr("Keys"), tr("What they do")});
    table->verticalHeader()->hide();
    // What takes two lines gets them.
    table->verticalHeader()->setMinimumSectionSize(fontMetrics().height() * 3 / 2);
    table->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table->horizontalHeader()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    table->horizontalHeader()->setStretchLastSection(true);
    table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table->setSelectionBehavior(QAbstractItemView::SelectRows);
    table->setSelectionMode(QAbstractItemView::SingleSelection);
    table->setTabKeyNavigation(false);
    table->setShowGrid(false);
    return table;
}

QLayout* ShortcutsDialog::makeEditor() {
    m_keys->setObjectName(QStringLiteral("shortcutKeys"));
    m_keys->setAccessibleName(tr("New keys"));
    m_keys->setClearButtonEnabled(true);
    m_take->setObjectName(QStringLiteral("shortcutTake"));
    m_take->setAutoDefault(false);
    m_reset->setObjectName(QStringLiteral("shortcutReset"));
    m_reset->setAutoDefault(false);
    auto* label = new QLabel(tr("&New keys"), this);
    label->setBuddy(m_keys);
    auto* row = new QHBoxLayout;
    row->addWidget(label);
    row->addWidget(m_keys, 1);
    row->addWidget(m_take);
    row->addWidget(m_reset);
    connect(m_take, &QPushButton::clicked, this, &ShortcutsDialog::take);
    connect(m_reset, &QPushButton::clicked, this, &ShortcutsDialog::reset);
    return row;
}

void ShortcutsDialog::addFixedRows() {
    const std::pair<QString, QString> fixed[] = {
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
    for (const auto& [keys, what] : fixed) {
        m_table->insertRow(m_table->rowCount());
        setRow(m_table, m_table->rowCount() - 1, keys, what);
    }
}

void ShortcutsDialog::showKeys(int row) {
    const QAction* const action = m_actions[row];
    setRow(m_table, row, action->shortcut().toString(QKeySequence::NativeText), helpOf(action));
    QFont font = m_table->font();
    font.setBold(!hasOwnShortcut(action)); // as with changed parameters
    m_table->item(row, 0)->setFont(font);
}

QAction* ShortcutsDialog::chosen() const {
    const int row = m_table->currentRow();
    return row >= 0 && row < m_actions.size() ? m_actions[row] : nullptr;
}

void ShortcutsDialog::rowChosen() {
    const QAction* const action = chosen();
    m_keys->setKeySequence(action != nullptr ? action->shortcut() : QKeySequence());
    for (QWidget* widget : {static_cast<QWidget*>(m_keys), static_cast<QWidget*>(m_take)})
        widget->setEnabled(action != nullptr);
    m_reset->setEnabled(action != nullptr && !hasOwnShortcut(action));
    say(action != nullptr ? QString()
                          : tr("These keys work only in the place that is named, and cannot be changed."));
}

void ShortcutsDialog::take() {
    QAction* const action = chosen();
    const QKeySequence typed = m_keys->keySequence();
    const QKeySequence keys = typed.isEmpty() ? typed : QKeySequence(typed[0]);
    const QAction* const other = keys.isEmpty() ? nullptr : actionFor(keys, m_actions);
    if (other != nullptr && other != action)
        return say(tr("%1 is taken by “%2”; give that other keys first.")
                       .arg(keys.toString(QKeySequence::NativeText), helpOf(other)));
    chooseShortcut(action, keys);
    showKeys(m_table->currentRow());
    rowChosen();
}

void ShortcutsDialog::reset() {
    resetShortcut(chosen());
    showKeys(m_table->currentRow());
    rowChosen();
}

void ShortcutsDialog::say(const QString& text) {
    m_said->setText(text);
}

} // namespace texloom::ui
