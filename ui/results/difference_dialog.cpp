#include "ui/results/difference_dialog.h"

#include "ui/common/text.h"
#include "ui/runs/result_text.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace texloom::ui {

namespace {

constexpr int kTextLines = 20;
constexpr int kTextWidth = 104;

QString shown(const Message& text) {
    return text.empty() ? QStringLiteral("–") : translated(text);
}

/// A line for each part of the label, so that none is cut.
QString headerOf(const ResultEntry& entry) {
    const QString text = entry.title.empty() ? labelText(entry) : titleText(entry);
    return QString(text).replace(QStringLiteral(" · "), QStringLiteral("\n"));
}

} // namespace

DifferenceDialog::DifferenceDialog(const ResultEntry& first, const ResultEntry& second, QWidget* parent)
    : QDialog(parent) {
    setObjectName(QStringLiteral("differenceDialog"));
    setWindowTitle(tr("Differences in settings"));
    const std::vector<RecipeDifference> rows = differences(first.recipe, second.recipe);
    auto* table = new QTableWidget(static_cast<int>(rows.size()), 3, this);
    table->setObjectName(QStringLiteral("differenceTable"));
    table->setAccessibleName(windowTitle());
    table->setHorizontalHeaderLabels({tr("Setting"), headerOf(first), headerOf(second)});
    table->verticalHeader()->hide();
    table->verticalHeader()->setDefaultSectionSize(fontMetrics().height() * 3 / 2);
    table->horizontalHeader()->setTextElideMode(Qt::ElideRight);
    table->setShowGrid(false);
    table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table->setSelectionBehavior(QAbstractItemView::SelectRows);
    table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    table->horizontalHeader()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    for (int row = 0; row < table->rowCount(); ++row) {
        const RecipeDifference& difference = rows[static_cast<std::size_t>(row)];
        table->setItem(row, 0, new QTableWidgetItem(translated(difference.what)));
        table->setItem(row, 1, new QTableWidgetItem(shown(difference.first)));
        table->setItem(row, 2, new QTableWidgetItem(shown(difference.second)));
    }
    auto* same = new QLabel(tr("Both were made with the same settings, so they are the same."), this);
    same->setWordWrap(true);
    same->setVisible(rows.empty());
    table->setVisible(!rows.empty());
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* column = new QVBoxLayout(this);
    column->addWidget(same);
    column->addWidget(table, 1);
    column->addWidget(buttons);
    resize(fontMetrics().averageCharWidth() * kTextWidth, fontMetrics().height() * kTextLines);
}

} // namespace texloom::ui
