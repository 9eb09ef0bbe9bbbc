#include "ui/export/preset_files_table.h"

#include "ui/common/text.h"
#include "ui/export/export_table.h"

#include <QComboBox>
#include <QHeaderView>

#include <array>
#include <utility>

namespace texloom::ui {

namespace {

constexpr int kBoxLetters = 9, kWidth = 148;
constexpr int kOtherwise = Qt::UserRole + 1; ///< what a channel holds where its map is missing
constexpr int kPacked = -1, kAsSource = -1, kNoChannel = -1;

/// What a channel of a packed file can hold.
const std::vector<std::pair<QString, PackedChannel>>& channelChoices() {
    static const std::vector<std::pair<QString, PackedChannel>> choices = [] {
        std::vector<std::pair<QString, PackedChannel>> all;
        const auto add = [&all](MapRole role, float otherwise) {
            all.emplace_back(translated(mapRoleTitle(role)), PackedChannel{role, otherwise, false});
        };
        add(MapRole::Occlusion, 1);
        add(MapRole::Roughness, 1);
        all.emplace_back(PresetFilesTable::tr("Smoothness"), PackedChannel{MapRole::Roughness, 1, true});
        add(MapRole::Metallic, 0);
        add(MapRole::Height, 0.5F);
        add(MapRole::Opacity, 1);
        all.emplace_back(PresetFilesTable::tr("Black"), PackedChannel{MapRole::Other, 0, false});
        all.emplace_back(PresetFilesTable::tr("White"), PackedChannel{MapRole::Other, 1, false});
        return all;
    }();
    return choices;
}

int indexOf(const PackedChannel& channel) {
    const auto& choices = channelChoices();
    for (std::size_t i = 0; i < choices.size(); ++i) {
        const PackedChannel& known = choices[i].second;
        const bool filled =
            channel.role == MapRole::Other && (channel.otherwise < 0.5F) != (known.otherwise < 0.5F);
        if (known.role == channel.role && known.inverted == channel.inverted && !filled)
            return static_cast<int>(i);
    }
    return kNoChannel;
}

} // namespace

PresetFilesTable::PresetFilesTable(QWidget* parent) : QTableWidget(0, 7, parent) {
    setObjectName(QStringLiteral("presetFiles"));
    setAccessibleName(tr("Files beside the colours"));
    setHorizontalHeaderLabels(
        {tr("$map"), tr("Holds"), tr("Red"), tr("Green"), tr("Blue"), tr("Alpha"), tr("Depth")});
    horizontalHeaderItem(Word)->setToolTip(tr("The word that stands for $map in the file's name"));
    verticalHeader()->hide();
    constexpr std::array kLetters = {16, 27, 22, 22, 22, 22, 15}; // of the columns
    for (int column = Word; column <= DepthColumn; ++column)
        horizontalHeader()->resizeSection(column, fontMetrics().averageCharWidth() *
                                                      kLetters[static_cast<std::size_t>(column)]);
    horizontalHeader()->setStretchLastSection(true);
    horizontalHeader()->setHighlightSections(false);
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setSelectionMode(QAbstractItemView::SingleSelection);
    setTabKeyNavigation(false);
    connect(this, &QTableWidget::cellChanged, this, [this] {
        if (!m_filling)
            Q_EMIT edited();
    });
}

QSize PresetFilesTable::sizeHint() const {
    return {fontMetrics().averageCharWidth() * kWidth, QTableWidget::sizeHint().height()};
}

QComboBox* PresetFilesTable::makeBox(const QString& name) {
    auto* box = new QComboBox;
    box->setAccessibleName(name);
    box->setFrame(false);
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(kBoxLetters);
    connect(box, &QComboBox::activated, this, [this, box] {
        showChannels(rowOf(box));
        Q_EMIT edited();
    });
    return box;
}

int PresetFilesTable::rowOf(const QWidget* cell) const {
    for (int row = 0; row < rowCount(); ++row)
        for (int column = Holds; column <= DepthColumn; ++column)
            if (cellWidget(row, column) == cell)
                return row;
    return -1;
}

QComboBox* PresetFilesTable::box(int row, int column) const {
    return qobject_cast<QComboBox*>(cellWidget(row, column));
}

void PresetFilesTable::addRow(const PresetFile& file) {
    const int row = rowCount();
    insertRow(row);
    setItem(row, Word, new QTableWidgetItem(QString::fromStdString(file.word)));
    QComboBox* const holds = makeBox(tr("What the file holds"));
    for (const MapRoleInfo& role : mapRoles())
        if (role.role != MapRole::Other && role.role != MapRole::Color && role.role != MapRole::NormalDx)
            holds->addItem(isNormal(role.role) ? tr("Normals") : translated(role.title),
                           static_cast<int>(role.role));
    holds->addItem(tr("Several, by channel"), kPacked);
    const MapRole role = isNormal(file.role) ? MapRole::NormalGl : file.role;
    holds->setCurrentIndex(holds->findData(file.packed() ? kPacked : static_cast<int>(role)));
    setCellWidget(row, Holds, holds);
    for (int column = Red; column <= Alpha; ++column) {
        QComboBox* const channel = makeBox(horizontalHeaderItem(column)->text());
        if (column != Red)
            channel->addItem(tr("None"), kNoChannel);
        for (std::size_t i = 0; i < channelChoices().size(); ++i)
            channel->addItem(channelChoices()[i].first, static_cast<int>(i));
        const auto at = static_cast<std::size_t>(column - Red);
        if (at < file.channels.size()) {
            channel->setCurrentIndex(channel->findData(indexOf(file.channels[at])));
            channel->setItemData(channel->currentIndex(), file.channels[at].otherwise, kOtherwise);
        }
        setCellWidget(row, column, channel);
    }
    QComboBox* const depth = makeBox(tr("Depth of the file"));
    depth->addItem(tr("As the map’s"), kAsSource);
    for (const Depth each : {Depth::Bits8, Depth::Bits16})
        depth->addItem(depthText(each), static_cast<int>(each));
    depth->setCurrentIndex(depth->findData(file.depth ? static_cast<int>(*file.depth) : kAsSource));
    setCellWidget(row, DepthColumn, depth);
    showChannels(row);
}

/// Channels count only where the file holds several maps, and up to the first that holds nothing.
void PresetFilesTable::showChannels(int row) {
    if (row < 0)
        return;
    bool open = box(row, Holds)->currentData().toInt() == kPacked;
    for (int column = Red; column <= Alpha; ++column) {
        QComboBox* const channel = box(row, column);
        channel->setEnabled(open);
        if (!open)
            channel->setCurrentIndex(-1); // says nothing where it counts for nothing
        else if (channel->currentIndex() < 0)
            channel->setCurrentIndex(0);
        open = open && channel->currentData().toInt() != kNoChannel;
    }
}

void PresetFilesTable::setFiles(const std::vector<PresetFile>& files) {
    m_filling = true;
    setRowCount(0);
    for (const PresetFile& file : files)
        addRow(file);
    m_filling = false;
}

PresetFile PresetFilesTable::fileIn(int row) const {
    PresetFile file{item(row, Word)->text().trimmed().toStdString(), MapRole::Other};
    if (const int role = box(row, Holds)->currentData().toInt(); role != kPacked) {
        file.role = static_cast<MapRole>(role);
    } else {
        for (int column = Red; column <= Alpha && box(row, column)->isEnabled(); ++column)
            if (const int chosen = box(row, column)->currentData().toInt(); chosen != kNoChannel) {
                file.channels.push_back(channelChoices()[static_cast<std::size_t>(chosen)].second);
                if (const QVariant kept = box(row, column)->currentData(kOtherwise); kept.isValid())
                    file.channels.back().otherwise = kept.toFloat();
            }
    }
    if (const int depth = box(row, DepthColumn)->currentData().toInt(); depth != kAsSource)
        file.depth = static_cast<Depth>(depth);
    return file;
}

std::vector<PresetFile> PresetFilesTable::files() const {
    std::vector<PresetFile> all;
    for (int row = 0; row < rowCount(); ++row)
        all.push_back(fileIn(row));
    return all;
}

void PresetFilesTable::addFile() {
    m_filling = true;
    addRow({tr("map").toStdString(), MapRole::Height});
    m_filling = false;
    Q_EMIT edited();
    setCurrentCell(rowCount() - 1, Word);
    editItem(item(rowCount() - 1, Word));
}

void PresetFilesTable::removeFile() {
    if (currentRow() < 0)
        return;
    removeRow(currentRow());
    Q_EMIT edited();
}

} // namespace texloom::ui
