#include "ui/runs/result_history.h"

#include "core/base/text.h"
#include "ui/common/background.h"
#include "ui/common/own_folders.h"
#include "ui/common/text.h"
#include "ui/runs/result_drag.h"
#include "ui/runs/result_text.h"

#include <QMimeData>
#include <QSettings>

#include <algorithm>
#include <utility>

namespace texloom::ui {

namespace {

/// Thumbnails' longer side in pixels, enough for screens with many.
constexpr int kThumbnailSide = 256;
const QString kResults = QStringLiteral("results");

QString thumbnailFile(const ResultFolder& folder, const ResultEntry& entry) {
    return toQString(folder.of(entry) / "thumbnail.png");
}

} // namespace

QString resultFolder() {
    return QSettings().value(QStringLiteral("results/folder"), dataFolder(kResults)).toString();
}

std::string draggedResult(const QMimeData& data) {
    return ResultDrag::keyOf(data);
}

ResultHistory::ResultHistory(const QString& folder, QObject* parent)
    : QAbstractListModel(parent), m_folder(toPath(folder)) {
    m_disk.setMaxThreadCount(1);
    scan();
}

ResultHistory::~ResultHistory() {
    for (const ResultEntry& entry : m_removed)
        purge(entry);
    m_disk.waitForDone();
}

void ResultHistory::scan() {
    inBackground(
        m_disk, this,
        [folder = m_folder] {
            if (folder.path() == toPath(dataFolder(kResults))) {
                folder.takeOver(toPath(earlierFolder(kResults)));
                takeOverFiles(kPasted);
            }
            return folder.scan();
        },
        [this](const ResultFolder::Scan& found) {
            beginResetModel();
            m_store.addEarlier(found.entries);
            endResetModel();
            readThumbnails(found.entries);
            for (const Message& problem : found.problems)
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

QString ResultHistory::accessibleText(const ResultEntry& entry) const {
    QStringList parts = QStringList(titleText(entry)) + chipsOf(entry);
    if (outdated(entry))
        parts += tr("made before the edit");
    if (entry.stars > 0)
        parts += tr("%1 of %2 stars").arg(entry.stars).arg(ResultEntry::kMostStars);
    if (entry.pinned)
        parts += tr("pinned");
    if (entry.key == m_shown)
        parts += tr("shown");
    return parts.join(QStringLiteral(", "));
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
        return accessibleText(entry);
    case KeyRole:
        return QString::fromStdString(entry.key);
    case ChipsRole:
        return outdated(entry) ? QStringList(tr("before the edit")) + chipsOf(entry) : chipsOf(entry);
    case StarsRole:
        return entry.stars;
    case PinnedRole:
        return entry.pinned;
    case PreviewRole:
        return entry.quick;
    case ShownRole:
        return entry.key == m_shown;
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
    return QAbstractListModel::flags(index) | Qt::ItemIsEditable | Qt::ItemIsDragEnabled |
           Qt::ItemNeverHasChildren;
}

QStringList ResultHistory::mimeTypes() const {
    return {ResultDrag::type()};
}

QMimeData* ResultHistory::mimeData(const QModelIndexList& indexes) const {
    if (indexes.isEmpty())
        return new QMimeData;
    const std::string key = entryAt(indexes.front()).key;
    return new ResultDrag(key, m_store.peek(key));
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

void ResultHistory::setStars(const std::string& key, int stars) {
    changeRow(key, [&] { m_store.setStars(key, stars); });
    saveEntry(key);
}

void ResultHistory::setVaried(const std::string& key, const std::vector<Message>& varied) {
    changeRow(key, [&] { m_store.setVaried(key, varied); });
    saveEntry(key);
}

void ResultHistory::exemplarsChanged() {
    if (const int rows = rowCount(); rows > 0)
        Q_EMIT dataChanged(index(0), index(rows - 1), {ChipsRole});
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
    for (const std::string& key : keys)
        takeRow(key);
    purgeBeyondDisk();
}

void ResultHistory::putBack(const std::vector<std::string>& keys) {
    for (const std::string& key : keys) {
        const auto removed = removedWith(key);
        if (removed == m_removed.end())
            continue;
        const auto& all = m_store.entries();
        const auto newer = static_cast<int>(
            std::count_if(all.begin(), all.end(), [&](const ResultEntry& other) { return other.key > key; }));
        beginInsertRows({}, newer, newer);
        m_store.putBack(*removed);
        m_removed.erase(removed);
        endInsertRows();
    }
}

void ResultHistory::purge(const std::vector<std::string>& keys) {
    for (const std::string& key : keys)
        if (const auto removed = removedWith(key); removed != m_removed.end()) {
            purge(*removed);
            m_removed.erase(removed);
        }
}

void ResultHistory::purge(const ResultEntry& entry) {
    m_thumbnails.erase(entry.key);
    m_disk.start([folder = m_folder, entry] { folder.remove(entry); });
}

/// Results that could come back give way to those that are on the list.
void ResultHistory::purgeBeyondDisk() {
    std::uint64_t bytes = m_store.diskUsed();
    for (const ResultEntry& entry : m_removed)
        bytes += entry.bytes;
    auto kept = m_removed.begin();
    for (; kept != m_removed.end() && bytes > m_store.diskBudget(); ++kept) {
        bytes -= kept->bytes;
        purge(*kept);
    }
    m_removed.erase(m_removed.begin(), kept);
}

std::vector<ResultEntry>::iterator ResultHistory::removedWith(const std::string& key) {
    return std::find_if(m_removed.begin(), m_removed.end(),
                        [&](const ResultEntry& entry) { return entry.key == key; });
}

void ResultHistory::setShown(const std::string& key) {
    for (const std::string& changed : {std::exchange(m_shown, key), key})
        changeRow(changed, [] {});
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
    purgeBeyondDisk();
    const std::vector<std::string> beyond = m_store.beyondDisk();
    if (beyond.empty())
        return;
    for (const std::string& key : beyond)
        takeRow(key);
    purge(beyond);
    Q_EMIT remarked(
        tr("The oldest results that are not pinned were removed, %1 in number, to keep the rest within "
           "%2.")
            .arg(beyond.size())
            .arg(QString::fromStdString(byteText(m_store.diskBudget()))));
}

} // namespace texloom::ui
