#pragma once

#include "core/session/results/result_files.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace texloom {

/// The list of all results and which of them are in memory. Files are the ResultFolder's: this only says what
/// may leave the memory, once it is on the disk, and what may leave the disk. Used on one thread.
class ResultStore {
public:
    /// Memory for the pixels of results, unless set otherwise: the latest ones stay at hand.
    static constexpr std::uint64_t kMemoryBudget = 1ULL << 30;
    /// Disk for results; beyond it the oldest that are not pinned go.
    static constexpr std::uint64_t kDiskBudget = 8ULL << 30;

    /// Oldest first.
    const std::vector<ResultEntry>& entries() const { return m_entries; }
    /// Null if there is none of this key.
    const ResultEntry* find(const std::string& key) const;

    /// Adds what an earlier session left, before all that is there.
    void addEarlier(std::vector<ResultEntry> entries);
    /// Adds a new result, which stays in memory at least until saved() says that it is on the disk.
    void add(const ResultEntry& entry, std::shared_ptr<const Result> result);
    /// Its files are written and take this much.
    void saved(const std::string& key, std::uint64_t bytesOnDisk);
    /// It was read back.
    void loaded(const std::string& key, std::shared_ptr<const Result> result);
    /// The result, if it is in memory; then it counts as used just now.
    std::shared_ptr<const Result> inMemory(const std::string& key);

    /// The same without counting as a use; null where it is not in memory.
    std::shared_ptr<const Result> peek(const std::string& key) const;

    void setTitle(const std::string& key, const std::string& title);
    void setPinned(const std::string& key, bool pinned);
    /// @param stars 0 to ResultEntry::kMostStars.
    void setStars(const std::string& key, int stars);
    void setVaried(const std::string& key, const std::vector<Message>& varied);
    /// Takes an entry off the list; its files stay. @return it, so that it can be put back.
    std::optional<ResultEntry> take(const std::string& key);
    /// Puts it back where it was.
    void putBack(const ResultEntry& entry);

    void setMemoryBudget(std::uint64_t bytes);
    std::uint64_t memoryBudget() const { return m_memoryBudget; }
    void setDiskBudget(std::uint64_t bytes) { m_diskBudget = bytes; }
    /// Bytes of results in memory.
    std::uint64_t memoryUsed() const;
    std::uint64_t diskUsed() const;
    std::uint64_t diskBudget() const { return m_diskBudget; }
    /// The oldest results that would have to go so that the others fit on the disk; never pinned ones, nor
    /// the newest.
    std::vector<std::string> beyondDisk() const;

private:
    /// What is not told to anyone of an entry.
    struct State {
        std::shared_ptr<const Result> result;
        bool saved = false;
        std::uint64_t bytesOnDisk = 0;
        std::uint64_t used = 0; ///< larger: later
    };

    std::size_t indexOf(const std::string& key) const;
    std::uint64_t onDisk(std::size_t index) const;
    void dropBeyondMemory();

    std::vector<ResultEntry> m_entries;
    std::vector<State> m_states; ///< of m_entries
    std::uint64_t m_memoryBudget = kMemoryBudget;
    std::uint64_t m_diskBudget = kDiskBudget;
    std::uint64_t m_uses = 0;
};

/// How long a run will take, judged by how long earlier runs of the same methods on as many threads took;
/// none if there were none.
std::optional<double> expectedSeconds(const RunPlan& plan, const std::vector<ResultEntry>& earlier);

/// One thing in which two recipes differ.
struct RecipeDifference {
    Message what; ///< a parameter's title, "Seed", …
    Message first;
    Message second; ///< either is empty where it does not apply
};

/// All things in which they differ, in the order in which the window shows settings.
std::vector<RecipeDifference> differences(const Recipe& first, const Recipe& second);

} // namespace texloom
