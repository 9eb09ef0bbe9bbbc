#include "ui/export/export_table.h"

#include "ui/common/text.h"

#include <QComboBox>
#include <QHeaderView>

namespace texloom::ui {

namespace {

constexpr int kTableLines = 8;

} // namespace

QString depthText(Depth depth) {
    switch (depth) {
    case Depth::Bits8:
        return ExportTable::tr("8-bit");
    case Depth::Bits16:
        return ExportTable::tr("16-bit");
    case Depth::Half:
        return ExportTable::tr("half");
    case Depth::Float:
        break;
    }
    return ExportTable::tr("float");
}

ExportTable::ExportTable(QWidget* parent) : QTableWidget(0, 4, parent) {
    setObjectName(QStringLiteral("exportTable"));
    setHorizontalHeaderLabels({tr("File"), tr("Holds"), tr("Depth"), tr("On disk")});
    setAccessibleName(tr("Files that will be written"));
    verticalHeader()->hide();
    verticalHeader()->setDefaultSectionSize(QComboBox().sizeHint().height());
    // Names are never cut: where they are long, the table scrolls.
    horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setSelectionMode(QAbstractItemView::NoSelection);
    setTabKeyNavigation(false);
    setTextElideMode(Qt::ElideNone);
    setMinimumHeight(fontMetrics().height() * kTableLines);
}

void ExportTable::fill(const std::vector<ExportEntry>& entries,
                       const std::function<QString(const ExportEntry&)>& holds) {
    setRowCount(static_cast<int>(entries.size()));
    m_replaced.clear();
    for (int row = 0; row < rowCount(); ++row) {
        const ExportEntry& entry = entries[static_cast<std::size_t>(row)];
        if (entry.exists)
            m_replaced.insert(entry.path);
        auto* file = new QTableWidgetItem(toQString(entry.path.filename()));
        file->setToolTip(toQString(entry.path));
        auto* disk = new QTableWidgetItem(entry.foreign  ? tr("replaces a file that is not Texloom's")
                                          : entry.exists ? tr("replaces the file there")
                                                         : tr("new"));
        QFont bold = font();
        bold.setBold(entry.exists);
        disk->setFont(bold);
        setItem(row, 0, file);
        setItem(row, 1, new QTableWidgetItem(holds(entry)));
        QWidget* const chooser = depthCell(entry);
        const bool said = entry.depth && chooser == nullptr;
        setItem(row, 2, new QTableWidgetItem(said ? depthText(*entry.depth) : QString()));
        setCellWidget(row, 2, chooser);
        setItem(row, 3, disk);
    }
}

/// The choice of a companion map's depth; null where there is none to be made in the table.
QWidget* ExportTable::depthCell(const ExportEntry& entry) {
    if (entry.word.empty())
        return nullptr;
    const std::vector<Depth> held = depthsFor(entry.path);
    if (held.size() < 2)
        return nullptr;
    auto* chooser = new QComboBox(this);
    chooser->setObjectName(QStringLiteral("depth-%1").arg(QString::fromStdString(entry.word)));
    chooser->setAccessibleName(tr("Depth of %1").arg(toQString(entry.path.filename())));
    for (const Depth depth : held)
        chooser->addItem(depthText(depth), static_cast<int>(depth));
    chooser->setCurrentIndex(chooser->findData(static_cast<int>(*entry.depth)));
    connect(chooser, &QComboBox::activated, this, [this, chooser, word = entry.word] {
        m_depths[word] = static_cast<Depth>(chooser->currentData().toInt());
    });
    return chooser;
}

} // namespace texloom::ui
