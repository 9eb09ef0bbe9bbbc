#pragma once

#include "core/session/results/result_store.h"

#include <QAbstractListModel>
#include <QImage>
#include <QString>
#include <QThreadPool>

#include <functional>
#include <map>
#include <memory>
#include <utility>
#include <vector>

class QMimeData;

namespace texloom::ui {

/// The folder in which results are kept, as the settings have it.
QString resultFolder();

/// The key of a result that is dragged; empty if something else is.
std::string draggedResult(const QMimeData& data);

/// All results, newest first, as a model for views: every run that ended, those of earlier sessions too. They
/// are written to a folder as they come and read back when they are wanted, on a thread of its own.
class ResultHistory : public QAbstractListModel {
    Q_OBJECT

public:
    enum Role {
        KeyRole = Qt::UserRole,
        ChipsRole,
        PinnedRole,
        PreviewRole,
        SearchRole,
        ShownRole,
        StarsRole
    };
    using Wanted = std::function<void(const std::shared_ptr<const Result>&)>;
    using Missing = std::function<void(const QString&)>;

    /// @param folder made when the first result comes.
    explicit ResultHistory(const QString& folder, QObject* parent = nullptr);
    /// Waits until all is written.
    ~ResultHistory() override;

    int rowCount(const QModelIndex& parent = {}) const override;
    /// Title, chips, thumbnail and details.
    QVariant data(const QModelIndex& index, int role) const override;
    /// Renames.
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    /// What draggedResult() reads: of several, the first.
    QMimeData* mimeData(const QModelIndexList& indexes) const override;
    QStringList mimeTypes() const override;

    /// Adds a finished run. @param picture of it, for its thumbnail. @return its key.
    std::string add(const std::shared_ptr<const Result>& result, bool quick, const QImage& picture);
    const ResultEntry* find(const std::string& key) const { return m_store.find(key); }
    /// Oldest first.
    const std::vector<ResultEntry>& entries() const { return m_store.entries(); }
    QModelIndex indexOf(const std::string& key) const;
    /// Hands a result to `done`, at once if it is in memory, else when it was read back; or says in `failed`
    /// why it cannot be.
    void want(const std::string& key, const Wanted& done, const Missing& failed);
    QImage thumbnail(const std::string& key) const;

    void setPinned(const std::string& key, bool pinned);
    /// @param stars 0 to ResultEntry::kMostStars.
    void setStars(const std::string& key, int stars);
    void setVaried(const std::string& key, const std::vector<Message>& varied);
    /// Tells which results are of an exemplar as it was before it was edited; asked anew by
    /// exemplarsChanged().
    void setOutdated(std::function<bool(const ResultEntry&)> outdated) { m_outdated = std::move(outdated); }
    void exemplarsChanged();
    bool outdated(const ResultEntry& entry) const { return m_outdated && m_outdated(entry); }
    /// The result that a window shows, which views mark; none if empty.
    void setShown(const std::string& key);
    /// Takes results off the list. Their files stay, so that they can come back, until purge(), the end of
    /// the window, or until the disk's budget needs the room.
    void remove(const std::vector<std::string>& keys);
    /// Puts removed results back, those whose files are still there.
    void putBack(const std::vector<std::string>& keys);
    /// Deletes the files of removed results.
    void purge(const std::vector<std::string>& keys);
    /// The budget of memory for results, in bytes.
    void setMemoryBudget(std::uint64_t bytes);
    void setDiskBudget(std::uint64_t bytes);
    const ResultStore& store() const { return m_store; }
    /// Whether the results of earlier sessions are there.
    bool ready() const { return m_ready; }
    /// Waits until everything is written; for tests.
    void waitForDisk() { m_disk.waitForDone(); }

Q_SIGNALS:
    /// Results of earlier sessions are there.
    void scanned();
    /// Results take more or less memory than before, or may.
    void usageChanged();
    /// Something that the user may want to know but need not act on.
    void remarked(const QString& sentence);

private:
    template <class Change> void changeRow(const std::string& key, const Change& change);
    void scan();
    void readThumbnails(const std::vector<ResultEntry>& entries);
    void save(const ResultEntry& entry, const std::shared_ptr<const Result>& result, const QImage& thumbnail);
    void saveEntry(const std::string& key);
    void purge(const ResultEntry& entry);
    void purgeBeyondDisk();
    void keepWithinDisk();
    void takeRow(const std::string& key);
    std::vector<ResultEntry>::iterator removedWith(const std::string& key);
    QString accessibleText(const ResultEntry& entry) const;
    int rowOf(const std::string& key) const;
    const ResultEntry& entryAt(const QModelIndex& index) const;

    ResultFolder m_folder;
    ResultStore m_store;
    std::map<std::string, QImage> m_thumbnails;
    std::vector<ResultEntry> m_removed; ///< those that putBack() would put back, the first removed first
    std::function<bool(const ResultEntry&)> m_outdated;
    std::string m_shown;
    QThreadPool m_disk; ///< one thread, so that what is written keeps its order
    bool m_ready = false;
};

} // namespace texloom::ui
