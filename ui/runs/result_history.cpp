#include "ui/runs/result_history.h"

#include "core/base/text.h"
#include "ui/common/background.h"
#include "ui/common/text.h"
#include "ui/runs/result_text.h"

#include <QSettings>
#include <QStandardPaths>

#include <algorithm>
#include <utility>

namespace texloom::ui {

namespace {

/// Thumbnails' longer side in pixels, enough for screens with many.
constexpr int kThumbnailSide = 256;

QString thumbnailFile(const ResultFolder& folder, const ResultEntry& entry) {
    return toQString(folder.of(entry) / "thumbnail.png");
}

} // namespace

QString resultFolder() {
    const QString cache = QStandardPaths::writableLocation(QStandardPaths::CacheLocation);
    return QSettings().value(QStringLiteral("results/folder"), cache + QStringLiteral("/results")).toString();
}

ResultHistory::ResultHistory(const QString& folder, QObject* parent)
    : QAbstractListModel(parent), m_folder(toPath(folder)) {
    m_disk.setMaxThreadCount(1);
    scan();
}

ResultHistory::~ResultHistory() {
    purgeRemoved();
    m_disk.waitForDone();
}

void ResultHistory::scan() {
    inBackground(
        m_disk, this, [folder = m_folder] { return folder.scan(); },
        [this](const ResultFolder::Scan& found) {
            beginResetModel();
            m_store.addEarlier(found.entries);
            endResetModel();
            readThumbnails(found.entries);
            for (const std::string& problem : found.problems)
                Q_EMIT remarked(translated(problem));
            m_ready = true;
            Q_EMIT scanned();
        },
        [this](const QString& why) { Q_EMIT remarked(why); });
}

void ResultHistory::readThumbnails(const std::vector<ResultEntry>& entries) {
    for (auto entry = entries.rbegin(); entry != entries.rend(); ++entry)
        inBackground(
            m_disk, this, [file = thumbnailFile(m_folder, *entry)] { return QImage(file); },
            [this, key = entry->key](const QImage& image) {
                changeRow(key, [&] { m_thumbnails[key] = image; });
            },
            [](const QString&) {});
}

template <class Change> void ResultHistory::changeRow(const std::string& key, const Change& change) {
    const QModelIndex index = indexOf(key);
    if (!index.isValid())
        return;
    change();
    Q_EMIT dataChanged(index, index);
}

int ResultHistory::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_store.entries().size());
}

const ResultEntry& ResultHistory::entryAt(const QModelIndex& index) const {
    return *(m_store.entries().rbegin() + index.row());
}

int ResultHistory::rowOf(const std::string& key) const {
    const auto& all = m_store.entries();
    const auto found =
        std::find_if(all.rbegin(), all.rend(), [&](const ResultEntry& entry) { return entry.key == key; });
    return found == all.rend() ? -1 : static_cast<int>(found - all.rbegin());
}

QImage ResultHistory::thumbnail(const std::string& key) const {
    const auto found = m_thumbnails.find(key);
    return found == m_thumbnails.end() ? QImage() : found->second;
}

QModelIndex ResultHistory::indexOf(const std::string& key) const {
    const int row = rowOf(key);
    return row < 0 ? QModelIndex() : index(row);
}

QVariant ResultHistory::data(const QModelIndex& index, int role) const {
    if (!index.isValid())
        return {};
    const ResultEntry& entry = entryAt(index);
    switch (role) {
    case Qt::DisplayRole:
    case Qt::EditRole:
        return titleText(entry);
    case Qt::DecorationRole:
        return thumbnail(entry.key);
    case Qt::ToolTipRole:
        return detailsText(entry);
    case Qt::AccessibleTextRole:
        return entry.pinned
                   ? tr("%1, %2, pinned").arg(titleText(entry), chipsOf(entry).join(QStringLiteral(", ")))
                   : tr("%1, %2").arg(titleText(entry), chipsOf(entry).join(QStringLiteral(", ")));
    case KeyRole:
        return QString::fromStdString(entry.key);
    case ChipsRole:
        return chipsOf(entry);
    case PinnedRole:
        return entry.pinned;
    case PreviewRole:
        return entry.quick;
    case SearchRole:
        return searchText(entry);
    default:
        return {};
    }
}

bool ResultHistory::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (!index.isValid() || role != Qt::EditRole)
        return false;
    const std::string key = entryAt(index).key;
    const QString title = value.toString().trimmed();
    const bool own = !title.isEmpty() && title != methodsText(entryAt(index));
    changeRow(key, [&] { m_store.setTitle(key, own ? title.toStdString() : std::string()); });
    saveEntry(key);
    return true;
}

Qt::ItemFlags ResultHistory::flags(const QModelIndex& index) const {
    return QAbstractListModel::flags(index) | Qt::ItemIsEditable | Qt::ItemNeverHasChildren;
}

std::string ResultHistory::add(const std::shared_ptr<const Result>& result, bool quick,
                               const QImage& picture) {
    const ResultEntry entry = entryFor(*result, quick);
    beginInsertRows({}, 0, 0);
    m_store.add(entry, result);
    const QImage& thumbnail = m_thumbnails[entry.key] =
        picture.scaled(kThumbnailSide, kThumbnailSide, Qt::KeepAspectRatio, Qt::SmoothTransformation);
    endInsertRows();
    save(entry, result, thumbnail);
    return entry.key;
}

void ResultHistory::save(const ResultEntry& entry, const std::shared_ptr<const Result>& result,
                         const QImage& thumbnail) {
    const auto write = [folder = m_folder, entry, result, thumbnail] {
        folder.write(entry, *result);
        thumbnail.save(thumbnailFile(folder, entry));
        return folder.bytesOf(entry);
    };
    inBackground(
        m_disk, this, write,
        [this, key = entry.key](std::uint64_t bytes) {
            m_store.saved(key, bytes);
            keepWithinDisk();
            Q_EMIT usageChanged();
        },
        [this](const QString& why) {
            Q_EMIT remarked(
                tr("A result stays in memory only and is lost when the window closes: %1").arg(why));
        });
}

void ResultHistory::saveEntry(const std::string& key) {
    if (const ResultEntry* entry = find(key))
        inBackground(
            m_disk, this,
            [folder = m_folder, entry = *entry] {
                folder.writeEntry(entry);
                return true;
            },
            [](bool) {}, [this](const QString& why) { Q_EMIT remarked(why); });
}

void ResultHistory::want(const std::string& key, const Wanted& done, const Missing& failed) {
    const ResultEntry* const entry = find(key);
    if (entry == nullptr)
        return failed(tr("This result was removed."));
    if (const auto result = m_store.inMemory(key))
        return done(result);
    inBackground(
        m_disk, this, [folder = m_folder, entry = *entry] { return folder.read(entry); },
        [this, key, done](const StoredResult& stored) {
            m_store.loaded(key, stored.result);
            Q_EMIT usageChanged();
            if (!stored.problem.empty())
                Q_EMIT remarked(translated(stored.problem));
            done(stored.result);
        },
        failed);
}

void ResultHistory::setPinned(const std::string& key, bool pinned) {
    changeRow(key, [&] { m_store.setPinned(key, pinned); });
    saveEntry(key);
}

void ResultHistory::takeRow(const std::string& key) {
    const int row = rowOf(key);
    if (row < 0)
        return;
    beginRemoveRows({}, row, row);
    m_removed.push_back(*m_store.take(key));
    endRemoveRows();
}

void ResultHistory::remove(const std::vector<std::string>& keys) {
    purgeRemoved();
    for (const std::string& key : keys)
        takeRow(key);
}

void ResultHistory::undoRemove() {
    for (const ResultEntry& entry : std::exchange(m_removed, {})) {
        const auto& all = m_store.entries();
        const auto newer = std::count_if(all.begin(), all.end(),
                                         [&](const ResultEntry& other) { return other.key > entry.key; });
        beginInsertRows({}, static_cast<int>(newer), static_cast<int>(newer));
        m_store.putBack(entry);
        endInsertRows();
    }
}

void ResultHistory::purgeRemoved() {
    for (const ResultEntry& entry : std::exchange(m_removed, {})) {
        m_thumbnails.erase(entry.key);
        m_disk.start([folder = m_folder, entry] { folder.remove(entry); });
    }
}

void ResultHistory::setMemoryBudget(std::uint64_t bytes) {
    m_store.setMemoryBudget(bytes);
    Q_EMIT usageChanged();
}

void ResultHistory::setDiskBudget(std::uint64_t bytes) {
    m_store.setDiskBudget(bytes);
    keepWithinDisk();
}

void ResultHistory::keepWithinDisk() {
    const std::vector<std::string> beyond = m_store.beyondDisk();
    if (beyond.empty())
        return;
    std::vector<ResultEntry> undoable = std::exchange(m_removed, {});
    for (const std::string& key : beyond)
        takeRow(key);
    purgeRemoved();
    m_removed = std::move(undoable);
    Q_EMIT remarked(
        tr("The oldest results that are not pinned were removed, %1 in number, to keep the rest within "
           "%2.")
            .arg(beyond.size())
            .arg(QString::fromStdString(byteText(m_store.diskBudget()))));
}

} // namespace texloom::ui
