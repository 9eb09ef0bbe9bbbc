#include "ui/exemplar/companion_list.h"

#include "core/image/map_role.h"
#include "ui/common/icons.h"
#include "ui/common/text.h"
#include "ui/exemplar/exemplar_store.h"
#include "ui/exemplar/files.h"
#include "ui/exemplar/material.h"

#include <QComboBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

namespace texloom::ui {

namespace {

constexpr int kIconLines = 2;
constexpr int kMostRows = 5; ///< seen at once

/// "Roughness · bark_orm, green".
QString rowText(const ExemplarFile& map) {
    QString source = QString::fromStdString(map.name());
    if (!map.layer.empty())
        source = CompanionList::tr("%1, layer %2").arg(source, QString::fromStdString(map.layer));
    if (!map.channel.whole()) {
        const QString channels[] = {CompanionList::tr("red"), CompanionList::tr("green"),
                                    CompanionList::tr("blue"), CompanionList::tr("alpha")};
        const int index = map.channel.index;
        source = CompanionList::tr("%1, %2").arg(
            source, index < 4 ? channels[index] : CompanionList::tr("channel %1").arg(index + 1));
        if (map.channel.inverted)
            source = CompanionList::tr("%1, inverted").arg(source);
    }
    if (isDerived(toQString(map.path)))
        source = CompanionList::tr("%1, derived").arg(source);
    return QStringLiteral("%1\n%2").arg(translated(mapRoleTitle(map.role)), source);
}

} // namespace

CompanionList::CompanionList(ExemplarStore* store, QWidget* parent)
    : QWidget(parent), m_store(store), m_empty(new QLabel(tr("None yet"), this)),
      m_list(new QListWidget(this)), m_role(new QComboBox(this)), m_add(new QToolButton(this)),
      m_remove(new QToolButton(this)) {
    m_empty->setToolTip(tr("Drop maps such as bark_normal and bark_rough with bark, or add them."));
    m_list->setObjectName(QStringLiteral("companionList"));
    m_list->setAccessibleName(tr("Companion maps"));
    m_list->setTextElideMode(Qt::ElideMiddle);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    const int side = fontMetrics().height() * kIconLines;
    m_list->setIconSize({side, side});
    m_role->setObjectName(QStringLiteral("companionRole"));
    m_role->setAccessibleName(tr("What the map holds"));
    m_role->setToolTip(tr("What the map holds. Normals turn with the exemplar."));
    m_role->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    for (const MapRoleInfo& role : mapRoles())
        m_role->addItem(translated(role.title), static_cast<int>(role.role));
    m_add->setObjectName(QStringLiteral("addCompanion"));
    m_add->setText(tr("Add…"));
    m_add->setAccessibleName(tr("Add companion maps"));
    m_add->setToolTip(
        tr("Add maps of the exemplar's size, such as normals or heights: they get the result's layout."));
    m_remove->setObjectName(QStringLiteral("removeCompanion"));
    setIconButton(m_remove, QStringLiteral("close"), tr("Remove the map"));
    for (QToolButton* button : {m_add, m_remove})
        button->setFocusPolicy(Qt::StrongFocus);

    auto* row = new QHBoxLayout;
    row->addWidget(m_empty, 1);
    row->addWidget(m_role, 1);
    row->addWidget(m_add);
    row->addWidget(m_remove);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_list);
    column->addLayout(row);

    connect(m_store, &ExemplarStore::changed, this, &CompanionList::fill);
    connect(m_store, &ExemplarStore::currentChanged, this, &CompanionList::fill);
    connect(m_list, &QListWidget::currentRowChanged, this, &CompanionList::showRole);
    connect(m_add, &QToolButton::clicked, this, &CompanionList::choose);
    connect(m_remove, &QToolButton::clicked, this, [this] {
        if (m_list->currentRow() >= 0)
            m_store->removeCompanion(m_shownId, static_cast<std::size_t>(m_list->currentRow()));
    });
    connect(m_role, &QComboBox::activated, this, [this] {
        if (m_list->currentRow() >= 0)
            m_store->setCompanionRole(m_shownId, static_cast<std::size_t>(m_list->currentRow()),
                                      static_cast<MapRole>(m_role->currentData().toInt()));
    });
    fill();
}

void CompanionList::fill() {
    const ExemplarEntry* const entry = m_store->current();
    const int row = m_list->currentRow();
    {
        const QSignalBlocker blocker(m_list);
        m_list->clear();
        m_shownId = entry != nullptr ? entry->id : 0;
        const std::size_t count = entry != nullptr ? entry->exemplar.companions.size() : 0;
        for (std::size_t i = 0; i < count; ++i) {
            const ExemplarFile& map = entry->exemplar.companions[i];
            auto* item = new QListWidgetItem(QIcon(QPixmap::fromImage(entry->companionThumbs[i])),
                                             rowText(map), m_list);
            item->setToolTip(toQString(map.path));
        }
        m_list->setCurrentRow(row < 0 ? 0 : std::min(row, m_list->count() - 1));
    }
    const bool any = m_list->count() > 0;
    m_empty->setVisible(!any);
    m_list->setVisible(any);
    const int rows = std::min(m_list->count(), kMostRows);
    m_list->setFixedHeight(rows * std::max(1, m_list->sizeHintForRow(0)) + 2 * m_list->frameWidth());
    m_add->setEnabled(entry != nullptr);
    showRole();
}

void CompanionList::showRole() {
    const ExemplarEntry* const entry = m_store->find(m_shownId);
    const int row = m_list->currentRow();
    const bool chosen =
        entry != nullptr && row >= 0 && row < static_cast<int>(entry->exemplar.companions.size());
    m_role->setVisible(m_list->count() > 0);
    m_remove->setVisible(m_list->count() > 0);
    m_role->setEnabled(chosen);
    m_remove->setEnabled(chosen);
    if (chosen)
        m_role->setCurrentIndex(m_role->findData(
            static_cast<int>(entry->exemplar.companions[static_cast<std::size_t>(row)].role)));
}

void CompanionList::choose() {
    const ExemplarEntry* const entry = m_store->current();
    if (entry == nullptr)
        return;
    const QStringList paths = QFileDialog::getOpenFileNames(
        window(), tr("Add companion maps"), toQString(entry->file().path.parent_path()), pictureFilter());
    for (const QString& path : paths)
        m_store->addCompanion(entry->id, path);
}

} // namespace texloom::ui
